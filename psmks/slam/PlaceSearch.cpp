/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/slam/Overlap.h>
#include <psmks/slam/PlaceSearch.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
/** Spacing of the tried positions. overlap() forgives 0.3 m, so that a place between two of them is
 * still seen. Evidence: measured. */
constexpr double kStep_m = 0.4;

/** Spacing of the tried headings. At 4 m, 4 degrees move a return by 0.28 m, which overlap()
 * forgives. Evidence: measured. */
constexpr double kStep_rad = degToRad(4);

/** The stride that leaves about 40 rays of a scan. */
int strideOf(const Scan& scan)
{
  /** Rays of a scan that are looked up, about. Unit: rays. Evidence: measured. */
  constexpr int kRays = 40;
  return std::max(1, scan.grid.count() / kRays);
}

int stepsWithin(double reach, double step) { return static_cast<int>(std::ceil(reach / step)); }
}  // namespace

SharedPlace findSharedPlace(const PosedScan& reference, const PosedScan& current,
                            const Pose2& expected_T_ref_cur, const Drift& drift)
{
  const Pose2 T_sensor_robot = reference.T_robot_sensor.inverse();
  const Overlap overlap(reference.scan, current.scan, strideOf(current.scan));
  SharedPlace best{expected_T_ref_cur, 0};
  const int moves = stepsWithin(drift.displacement_m, kStep_m);
  const int turns = stepsWithin(drift.rotation_rad, kStep_rad);
  for (int turn = -turns; turn <= turns; ++turn)
    for (int x = -moves; x <= moves; ++x)
      for (int y = -moves; y <= moves; ++y)
      {
        if (x * x + y * y > moves * moves) continue;
        const Pose2 T_ref_cur{expected_T_ref_cur.x_m + kStep_m * x,
                              expected_T_ref_cur.y_m + kStep_m * y,
                              wrapAngle(expected_T_ref_cur.phi_rad + kStep_rad * turn)};
        const double share = overlap.at(T_sensor_robot * T_ref_cur * current.T_robot_sensor);
        if (share > best.overlap) best = {T_ref_cur, share};
      }
  return best;
}
}  // namespace psmks
