/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/matchers/PairMatcher.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace psmks
{
/** Families of matchers, in the order of listings. */
enum class PairMatcherFamily
{
  Psmks,
  Psm,
  Icp,
  Gicp,
  Guess  //!< the floor of them all
};

/** What programs need to know of a matcher to offer and to make it. */
struct PairMatcherEntry
{
  std::string name;
  std::string description;  //!< one line
  PairMatcherFamily family = PairMatcherFamily::Icp;
  int placeInFamily = 0;  //!< in listings

  /** Gets the name that it was asked for and the options of psmks, which others ignore.
   *  May throw OptionError for options that it cannot accept. */
  std::function<std::unique_ptr<PairMatcher>(const std::string& name, MatcherOptions)> make;
};

/** Makes a matcher known to makePairMatcher() for as long as it lives. A rival's source file holds
 * one at namespace scope, and no other file has to name the rival:
 *
 *     const PairMatcherRegistration kRegistration(
 *         {"my-icp", "ICP as I would have it", PairMatcherFamily::Icp, 10, makeMyIcp});
 *
 * Such objects may come to life in any order, before main(). No two threads may register at once.
 */
class PairMatcherRegistration
{
 public:
  /** @throws std::logic_error where the name is taken */
  explicit PairMatcherRegistration(PairMatcherEntry entry);
  ~PairMatcherRegistration();
  PairMatcherRegistration(const PairMatcherRegistration&) = delete;
  PairMatcherRegistration& operator=(const PairMatcherRegistration&) = delete;

 private:
  std::string name_;
};

/** All that are registered, in the order of listings. */
std::vector<PairMatcherEntry> pairMatcherEntries();
}  // namespace psmks
