/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/matchers/PairMatcherRegistration.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <tuple>

namespace psmks
{
namespace
{
/** All registered matchers by their names. The first registration makes it before that registration
 * is complete, so it is destroyed after the last one. */
std::map<std::string, PairMatcherEntry>& registry()
{
  static std::map<std::string, PairMatcherEntry> entries;
  return entries;
}

bool isListedBefore(const PairMatcherEntry& a, const PairMatcherEntry& b)
{
  return std::tie(a.family, a.placeInFamily, a.name) < std::tie(b.family, b.placeInFamily, b.name);
}
}  // namespace

PairMatcherRegistration::PairMatcherRegistration(PairMatcherEntry entry) : name_(entry.name)
{
  if (!registry().emplace(name_, std::move(entry)).second)
    throw std::logic_error("matcher '" + name_ + "' is registered twice");
}

PairMatcherRegistration::~PairMatcherRegistration() { registry().erase(name_); }

std::vector<PairMatcherEntry> pairMatcherEntries()
{
  std::vector<PairMatcherEntry> entries;
  for (const auto& [name, entry] : registry()) entries.push_back(entry);
  std::sort(entries.begin(), entries.end(), isListedBefore);
  return entries;
}
}  // namespace psmks
