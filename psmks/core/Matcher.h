/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/core/MatcherOptions.h>
#include <psmks/geometry/Scan.h>
#include <psmks/match/ExternalSolvers.h>
#include <psmks/match/Guess.h>
#include <psmks/match/MatchResult.h>
#include <psmks/match/MatchTrace.h>
#include <psmks/match/SearchScope.h>
#include <psmks/segmentation/ScannerNoise.h>
#include <psmks/segmentation/SegmentedScan.h>

#include <memory>

namespace psmks
{
/** The buffers of a match. One per thread; after the first match with scans of a size, a further
 * one allocates nothing. */
class MatcherWorkspace
{
 public:
  MatcherWorkspace();
  ~MatcherWorkspace();
  MatcherWorkspace(MatcherWorkspace&&) noexcept;
  MatcherWorkspace& operator=(MatcherWorkspace&&) noexcept;

  struct Buffers;
  Buffers& buffers() { return *buffers_; }

 private:
  std::unique_ptr<Buffers> buffers_;
};

/** Estimates the motion between two scans by PSM-KS.
 *
 * Immutable: one matcher may serve several threads, each with its own workspace. */
class Matcher
{
 public:
  /** @param externalSolvers needed where the options choose Ceres (psmks/ceres/CeresSolvers.h)
   *  @throws OptionError if the options choose Ceres and no external solvers are given */
  explicit Matcher(MatcherOptions options = {},
                   std::shared_ptr<const ExternalSolvers> externalSolvers = nullptr);

  const MatcherOptions& options() const { return options_; }

  /** Preprocessing and segmentation by these options; see segmentScan(). A scan that serves as
   *  reference several times is segmented once. */
  void segment(const Scan& scan, MatcherWorkspace& workspace, SegmentedScan& result,
               const ScannerNoise& scanner = {}) const;

  /** Pose of the current scan in the frame of the reference scan. Bad data never throws: see
   *  MatchStatus.
   *  @param trace filled with the steps where not null
   *  @param scope how far from the guess the joint scheme looks; the paper's scheme has but one */
  MatchResult match(const SegmentedScan& reference, const SegmentedScan& current,
                    const Guess& guess, MatcherWorkspace& workspace, MatchTrace* trace = nullptr,
                    SearchScope scope = SearchScope::Full) const;

  /** The same from raw scans: segments both, and counts the time of it. */
  MatchResult match(const Scan& reference, const Scan& current, const Guess& guess,
                    MatcherWorkspace& workspace, MatchTrace* trace = nullptr,
                    SearchScope scope = SearchScope::Full) const;

 private:
  MatcherOptions options_;
  std::shared_ptr<const ExternalSolvers> externalSolvers_;
};
}  // namespace psmks
