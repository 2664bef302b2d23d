/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/matchers/PairMatcher.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace psmks
{
/** The scans of one scanner as a matcher has prepared them, so that a scan which serves in many
 * matches is prepared once.
 *
 * Memory is bounded: the prepared scans that were used last are kept, up to a number. Any other is
 * prepared anew when it is asked for again, with the same result.
 *
 * The noise of the scanner is learnt here: every scan counts once, when it is asked for the first
 * time. When ScannerNoise::isBelieved() changes, a kept scan that shows more noise than stated is
 * segmented anew, for its lines depend on it. So what is returned depends
 * on which scans were asked for before, and never on which of them are still kept. */
class PreparedScans
{
 public:
  /** Most prepared scans that are kept: as many as a robot has keyframes around it, with a margin.
   * Unit: scans. Definition: bounds the memory; segmented scans of 1,081 rays take about 20 kB
   * each. */
  static constexpr std::size_t kCapacity = 128;

  /** @param matcher kept by reference
   *  @param capacity at least 2: the scans of one match */
  explicit PreparedScans(PairMatcher& matcher, std::size_t capacity = kCapacity);

  /** A prepared scan.
   *  @param index of the scan in its trajectory. Scans are asked for the first time in the order of
   * their indices, which need not be consecutive. */
  std::shared_ptr<const PreparedScan> find(std::size_t index, const Scan& scan);

  /** What the scans so far have shown of the scanner's noise. */
  const ScannerNoise& scanner() const { return scanner_; }

 private:
  struct Entry
  {
    std::size_t index = 0;
    std::shared_ptr<const PreparedScan> scan;
    bool noiseBelieved = false;  //!< ScannerNoise::isBelieved() when it was prepared
  };

  bool isUpToDate(const Entry& entry) const;
  Entry prepared(std::size_t index, const Scan& scan);

  PairMatcher* matcher_;
  std::size_t capacity_;
  ScannerNoise scanner_;
  std::size_t firstUncounted_ = 0;  //!< scans before it count in the scanner's noise
  std::vector<Entry> entries_;      //!< the one that was used last stands at the end
};
}  // namespace psmks
