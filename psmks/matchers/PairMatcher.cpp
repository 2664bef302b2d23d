/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/matchers/PairMatcher.h>
#include <psmks/matchers/PairMatcherRegistration.h>

namespace psmks
{
std::unique_ptr<PreparedScan> PairMatcher::prepare(const Scan& scan, const ScannerNoise&)
{
  return std::make_unique<PreparedAs<Scan>>(scan);
}

MatchResult PairMatcher::matchPrepared(const PreparedScan& reference, const PreparedScan& current,
                                       const Guess& guess, SearchScope)
{
  return match(dataOf<Scan>(reference), dataOf<Scan>(current), guess);
}

std::vector<std::string> pairMatcherNames()
{
  std::vector<std::string> names;
  for (const auto& entry : pairMatcherEntries()) names.push_back(entry.name);
  return names;
}

std::unique_ptr<PairMatcher> makePairMatcher(const std::string& name, const MatcherOptions& options)
{
  std::string known;
  for (const auto& entry : pairMatcherEntries())
  {
    if (entry.name == name) return entry.make(name, options);
    known += (known.empty() ? "" : " | ") + entry.name;
  }
  throw OptionError("matcher '" + name + "' is not known, allowed: " + known);
}
}  // namespace psmks
