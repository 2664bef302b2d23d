/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/pairs/ScanPairs.h>
#include <psmks/motion/Deskewer.h>
#include <psmks/motion/OdometryNoise.h>

namespace psmks
{
namespace
{
Scan deskewed(Scan scan, const PlanarVelocity& measured)
{
  if (measured.isZero()) return scan;
  constexpr double kTime_s = MeanVelocity::kWindow_s;
  const Pose2 motion{kTime_s * measured.x_m_s, kTime_s * measured.y_m_s,
                     kTime_s * measured.phi_rad_s};
  const Eigen::Matrix3d covariance =
      odometryCovariance(motion, OdometryOptions()) / (kTime_s * kTime_s);
  Deskewer deskewer;
  deskewer.deskew(scan, deskewer.fittedVelocity(scan, measured, covariance));
  return scan;
}
}  // namespace

std::vector<ScanPair> scanPairs(const PairSet& set)
{
  std::vector<ScanPair> pairs;
  for (const SimulatedPair& pair : set.pairs)
    pairs.push_back({pair.id, pair.T_ref_cur_true, pair.T_ref_cur_odometry,
                     deskewed(pair.reference.scan, pair.refVelocityOdometry),
                     deskewed(pair.current.scan, pair.curVelocityOdometry)});
  return pairs;
}
}  // namespace psmks
