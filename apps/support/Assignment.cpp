/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/support/Assignment.h>
#include <psmks/base/ShortText.h>

namespace psmks
{
Assignment parseAssignment(const std::string& text)
{
  const auto dot = text.find('.'), equals = text.find('=');
  if (equals == std::string::npos || dot == std::string::npos || dot > equals)
    throw OptionError("'" + shortText(text) + "' is not SECTION.KEY=VALUE");
  return {text.substr(0, dot), text.substr(dot + 1, equals - dot - 1), text.substr(equals + 1)};
}

void assignOptions(OptionTable& table, const std::vector<std::string>& assignments)
{
  for (const auto& assignment : assignments)
  {
    const auto [section, key, value] = parseAssignment(assignment);
    table.set(section, key, value);
  }
}
}  // namespace psmks
