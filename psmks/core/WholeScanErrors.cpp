/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/core/WholeScanErrors.h>
#include <psmks/geometry/UncertainPose.h>

namespace psmks
{
void listFields(OptionTable& table, WholeScanOptions& options)
{
  table.beginSection("whole_scan", "Errors that all rays of a scan share.");
  table.add("sigma_m", options.sigma_m, Unit::Metre, 0, 10,
            "standard deviation of the place of a whole scan; the covariance of a match counts it "
            "for both scans");
  table.add("sigma_deg", options.sigma_rad, Unit::Degree, 0, degToRad(180),
            "the same for its heading, by bearings that are off together");
}

void addWholeScanErrors(const WholeScanOptions& options, MatchResult& result)
{
  if (!result.usable() || (options.sigma_m <= 0 && options.sigma_rad <= 0)) return;
  const double variance_m2 = options.sigma_m * options.sigma_m;
  const Eigen::Vector3d variances(variance_m2, variance_m2, options.sigma_rad * options.sigma_rad);
  const UncertainPose frame{{}, variances.asDiagonal()};
  result.covariance =
      composed(composed(frame, {result.T_ref_cur, result.covariance}), frame).covariance;
}
}  // namespace psmks
