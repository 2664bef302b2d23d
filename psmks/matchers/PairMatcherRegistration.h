/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/matchers/PairMatcher.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace psmks
{
/** The families of matchers, in the order in which listings show them. */
enum class PairMatcherFamily
{
  Psmks,
  Psm,
  Icp,
  Gicp,
  Guess  //!< returns the guess, which the others have to improve on
};

/** What a program needs to know of a matcher to list and to make it. */
struct PairMatcherEntry
{
  std::string name;
  std::string description;  //!< one line
  PairMatcherFamily family = PairMatcherFamily::Icp;
  int placeInFamily = 0;  //!< listings show lower ones first

  /** Makes the matcher from the name that it was asked for by and the options of psmks, which other
   * methods ignore. May throw OptionError for options that it cannot accept. */
  std::function<std::unique_ptr<PairMatcher>(const std::string& name, MatcherOptions)> make;
};

/** Makes a matcher known to makePairMatcher() for as long as the registration lives. The source
 * file of a method holds one at namespace scope, and no other file has to name the method:
 *
 *     const PairMatcherRegistration kRegistration(
 *         {"my-icp", "my variant of ICP", PairMatcherFamily::Icp, 10, makeMyIcp});
 *
 * Registrations may be made in any order, and before main(). No two threads may register at the
 * same time. */
class PairMatcherRegistration
{
 public:
  /** @throws std::logic_error where a matcher of that name is registered */
  explicit PairMatcherRegistration(PairMatcherEntry entry);
  ~PairMatcherRegistration();
  PairMatcherRegistration(const PairMatcherRegistration&) = delete;
  PairMatcherRegistration& operator=(const PairMatcherRegistration&) = delete;

 private:
  std::string name_;
};

/** All matchers that are registered, in the order of listings. */
std::vector<PairMatcherEntry> pairMatcherEntries();
}  // namespace psmks
