/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

namespace psmks
{
/** Tells noise from clutter by many scans of one scanner. In a single scan both look alike; over
 * many scans, noise shows in nearly all of them and clutter only in some. */
class ScannerNoise
{
 public:
  /** Counts a scan.
   *  @param showsMore SegmentedScan::showsMoreNoise of it */
  void add(bool showsMore)
  {
    ++scans_;
    noisy_ += showsMore ? 1 : 0;
  }

  /** Whether the noise that a scan shows is that of the scanner; true before the first scan. */
  bool isBelieved() const
  {
    /** Share of its scans in which a noisy scanner shows its noise, at least. Unit: share.
     * Evidence: measured. */
    constexpr double kNearlyAll = 0.75;
    return static_cast<double>(noisy_) >= kNearlyAll * static_cast<double>(scans_);
  }

 private:
  long long scans_ = 0, noisy_ = 0;
};
}  // namespace psmks
