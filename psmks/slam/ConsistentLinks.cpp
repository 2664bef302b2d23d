/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/geometry/Angle.h>
#include <psmks/slam/ConsistentLinks.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
bool areAlike(const Pose2& a, const Pose2& b)
{
  /** Distance and angle within which two corrections of a pose agree. Evidence: measured. */
  constexpr double kApart_m = 0.05, kApart_rad = degToRad(1);
  return (a.translation() - b.translation()).norm() < kApart_m &&
         std::abs(wrapAngle(a.phi_rad - b.phi_rad)) < kApart_rad;
}

/** By what each match moves the scan from where the map has it. */
std::vector<Pose2> correctionsBy(const std::vector<ReferenceMatch>& found,
                                 const std::vector<PosedScan>& scans, const PosedScan& current)
{
  std::vector<Pose2> corrections;
  for (const ReferenceMatch& match : found)
  {
    const Pose2 expected =
        scans[match.reference].T_world_robot.pose.inverse() * current.T_world_robot.pose;
    corrections.push_back(expected.inverse() * match.T_ref_cur.pose);
  }
  return corrections;
}
}  // namespace

std::vector<ReferenceMatch> consistentLinks(const std::vector<PosedScan>& scans,
                                            const PosedScan& current,
                                            const std::vector<ReferenceMatch>& found)
{
  const std::vector<Pose2> corrections = correctionsBy(found, scans, current);
  std::vector<ReferenceMatch> consistent;
  for (std::size_t m = 0; m < found.size(); ++m)
  {
    const auto agrees = [&](const Pose2& other) { return areAlike(corrections[m], other); };
    const auto agreeing = std::count_if(corrections.begin(), corrections.end(), agrees);
    const bool hasWitness = agreeing > 1;  // the match agrees with itself
    if (agrees(Pose2()) || hasWitness) consistent.push_back(found[m]);
  }
  return consistent;
}
}  // namespace psmks
