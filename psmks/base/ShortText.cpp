/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/base/ShortText.h>

#include <algorithm>

namespace psmks
{
std::string shortText(std::string_view text)
{
  /** Longest text that is quoted whole. Unit: characters. Definition: a line of a terminal. */
  constexpr std::size_t kLongest = 60;
  constexpr char kDelete = 0x7F;
  const auto isControl = [](unsigned char c) { return c < ' ' || c == kDelete; };
  std::string quoted(text.substr(0, kLongest));
  std::replace_if(quoted.begin(), quoted.end(), isControl, '?');
  return text.size() > kLongest ? quoted + "..." : quoted;
}
}  // namespace psmks
