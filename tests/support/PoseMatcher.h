/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <gtest/gtest.h>
#include <psmks/geometry/Pose2.h>

namespace psmks
{
/** Compares two poses: `EXPECT_TRUE(isNearly(actual, expected, tol_m, tol_rad))`. If they are
 * farther apart, the failure prints both poses and their difference. */
inline testing::AssertionResult isNearly(const Pose2& actual, const Pose2& expected, double tol_m,
                                         double tol_rad)
{
  const double apart_m = (actual.translation() - expected.translation()).norm();
  const double turned_rad = std::abs(wrapAngle(actual.phi_rad - expected.phi_rad));
  if (apart_m <= tol_m && turned_rad <= tol_rad) return testing::AssertionSuccess();
  const auto text = [](const Pose2& pose)
  {
    std::ostringstream out;
    out << '(' << pose.x_m << " m, " << pose.y_m << " m, " << radToDeg(pose.phi_rad) << " deg)";
    return out.str();
  };
  return testing::AssertionFailure()
         << text(actual) << " is not nearly " << text(expected) << ": apart " << apart_m
         << " m (allowed " << tol_m << "), " << radToDeg(turned_rad) << " deg (allowed "
         << radToDeg(tol_rad) << ")";
}
}  // namespace psmks
