/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Pose2.h>
#include <psmks/geometry/Scan.h>

namespace psmks
{
/** Two fixed scans of the simulated room over 180 degrees with a range of 30 m. They are 36 cm and
 * 8 degrees apart. */
struct RoomPair
{
  Scan reference, current;
  Pose2 T_ref_cur_true{0.3, 0.2, degToRad(8)};

  explicit RoomPair(int rays);
};
}  // namespace psmks
