/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/joint/ScanScores.h>

#include <algorithm>

namespace psmks
{
namespace
{
/** Every how many-th point of a scan is counted. */
int strideOf(const RayPoints& points, std::size_t enoughRays)
{
  return std::max(1, static_cast<int>(points.size() / enoughRays));
}

/** Rays of a scan that a full score counts, about. Unit: rays. Evidence: measured. */
constexpr std::size_t kEnoughRays = 180;
}  // namespace

ScanScores::ScanScores(const ScanFeatures& reference, const ScanFeatures& current,
                       double rangeSigma_m)
    : reference_(reference), current_(current), tolerance_m_(surfaceTolerance_m(rangeSigma_m))
{
}

double ScanScores::roughScore(const Pose2& T_ref_cur) const
{
  /** Tolerance of a rough score. Evidence: measured. */
  constexpr float kRoughTolerance_m = 0.15f;

  /** A rough score counts every so many rays. Unit: rays. Evidence: measured. */
  constexpr int kStride = 4;
  return freeSpaceScore(
      countRays(current_.points, reference_.surface, T_ref_cur, kRoughTolerance_m, kStride));
}

RayCounts ScanScores::allCounts(const Pose2& T_ref_cur) const
{
  RayCounts counts = countRays(current_.points, reference_.surface, T_ref_cur, tolerance_m_,
                               strideOf(current_.points, kEnoughRays));
  counts += countRays(reference_.points, current_.surface, T_ref_cur.inverse(), tolerance_m_,
                      strideOf(reference_.points, kEnoughRays));
  return counts;
}

double ScanScores::inlierRays(const RayCounts& counts) const
{
  const auto points = static_cast<double>(current_.points.size() + reference_.points.size());
  return 0.5 * points * counts.raysOn / std::max(1, counts.rays);
}
}  // namespace psmks
