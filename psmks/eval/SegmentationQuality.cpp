/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/eval/SegmentationQuality.h>
#include <psmks/eval/Statistics.h>
#include <psmks/geometry/ChiSquared.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
/** For each segment, the number of its rays on each wall. */
std::vector<std::vector<int>> raysOnWalls(const SegmentedScan& scan, const WallTruth& truth)
{
  std::vector<std::vector<int>> counts(scan.segments.size(),
                                       std::vector<int>(truth.lines.size(), 0));
  for (std::size_t ray = 0; ray < truth.wallOfRay.size(); ++ray)
  {
    const int segment = scan.segmentOfRay[ray], wall = truth.wallOfRay[ray];
    if (segment == SegmentedScan::kNoSegment || wall == WallTruth::kNoWall) continue;
    ++counts[static_cast<std::size_t>(segment)][static_cast<std::size_t>(wall)];
  }
  return counts;
}

/** The error of (r0, phi0). A line near the origin is close to both forms (r0, phi0) and (-r0, phi0
 * + pi) of the true line; the smaller error counts. */
Eigen::Vector2d lineError(const Line& estimate, const Line& truth)
{
  const double angle_rad = wrapAngle(estimate.phi0_rad - truth.phi0_rad);
  if (std::abs(angle_rad) <= kPi / 2) return {estimate.r0_m - truth.r0_m, angle_rad};
  return {estimate.r0_m + truth.r0_m, wrapAngle(angle_rad + kPi)};
}
}  // namespace

void SegmentationQuality::add(const SegmentedScan& scan, const WallTruth& truth)
{
  ++scans_;
  validRays_ += scan.validRays();
  for (const int segment : scan.segmentOfRay) usedRays_ += segment != SegmentedScan::kNoSegment;

  const auto counts = raysOnWalls(scan, truth);
  for (std::size_t s = 0; s < counts.size(); ++s)
  {
    const auto most = std::max_element(counts[s].begin(), counts[s].end());
    rightRays_ += *most;
    addSegment(scan.segments[s], truth.lines[static_cast<std::size_t>(most - counts[s].begin())]);
  }
}

void SegmentationQuality::addSegment(const Segment& segment, const Line& wall)
{
  const Eigen::Vector2d error = lineError(segment.line, wall);
  offsets_m_.push_back(std::abs(error(0)));
  angles_rad_.push_back(std::abs(error(1)));
  nees_.push_back(error.dot(segment.line.covariance.inverse() * error));
}

double SegmentationQuality::usedShare() const
{
  return static_cast<double>(usedRays_) / validRays_;
}
double SegmentationQuality::rightWallShare() const
{
  return static_cast<double>(rightRays_) / usedRays_;
}

double SegmentationQuality::segmentsPerScan() const
{
  return static_cast<double>(nees_.size()) / scans_;
}

double SegmentationQuality::raysPerSegment() const
{
  return usedRays_ / static_cast<double>(nees_.size());
}

double SegmentationQuality::offsetMedian_m() const { return median(offsets_m_); }
double SegmentationQuality::angleMedian_rad() const { return median(angles_rad_); }
double SegmentationQuality::neesMean() const { return mean(nees_); }
double SegmentationQuality::ellipseShare() const { return shareBelow(nees_, kChi2At95With2Dof); }
}  // namespace psmks
