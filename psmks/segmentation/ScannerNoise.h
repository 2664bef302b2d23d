/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

namespace psmks
{
/** Tells noise from clutter by many scans of one scanner: noise shows in nearly all of them,
 * clutter, which looks alike to a single scan, in some. */
class ScannerNoise
{
 public:
  /** @param showsMore whether the scan shows clearly more noise than stated, see
   *  SegmentedScan::showsMoreNoise */
  void add(bool showsMore)
  {
    ++scans_;
    noisy_ += showsMore ? 1 : 0;
  }

  /** Whether what a scan shows is to be believed; true before the first scan. */
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
