/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/geometry/Angle.h>
#include <psmks/slam/CsvFiles.h>

#include <iomanip>
#include <ostream>

namespace psmks
{
namespace
{
constexpr const char* kMatchesHeader =
    "stamp_s,reference_stamp_s,status,x_m,y_m,phi_deg,cov_xx_m2,cov_xy_m2,cov_yy_m2,"
    "cov_xphi_m_deg,cov_yphi_m_deg,cov_phiphi_deg2,associations,iterations,segmentation_ms,"
    "match_ms,direction_open,direction_weak,heading_open,alternatives,innovation_chi2,"
    "innovation_dof,guess_given_up,decides\n";

void writeStamp(std::ostream& out, double stamp_s)
{
  out << std::fixed << std::setprecision(9) << stamp_s << ',' << std::defaultfloat
      << std::setprecision(7);
}

/** Writes the upper triangle, column by column, with degrees in place of radians. */
void writeCovariance(std::ostream& out, const Eigen::Matrix3d& covariance)
{
  const Eigen::Vector3d units(1, 1, radToDeg(1));
  const Eigen::Matrix3d shown = units.asDiagonal() * covariance * units.asDiagonal();
  for (Eigen::Index column = 0; column < 3; ++column)
    for (Eigen::Index row = 0; row <= column; ++row) out << shown(row, column) << ',';
}

/** What the scans leave open, as 0 or 1 or numbers, and how far the guess is from them. */
void writeOpen(std::ostream& out, const MatchResult& result)
{
  const Innovation innovation = result.innovation.value_or(Innovation());
  out << result.unobservableDirection.has_value() << ',' << result.weakDirection.has_value() << ','
      << result.headingUnobservable << ','
      << (result.ambiguity ? result.ambiguity->alternatives : 0) << ',' << innovation.chi2 << ','
      << innovation.degreesOfFreedom << ',' << result.guessGivenUp << ',';
}

void writeMatch(std::ostream& out, const ReferenceMatch& match, const PosedScan& scan,
                const PosedScan& reference)
{
  const bool decides = &match == scan.decidingMatch();
  const MatchResult& result = match.result;
  const UncertainPose& T_ref_cur = match.T_ref_cur;
  writeStamp(out, scan.stamp_s());
  writeStamp(out, reference.stamp_s());
  out << toString(result.status) << ',' << T_ref_cur.pose.x_m << ',' << T_ref_cur.pose.y_m << ','
      << radToDeg(T_ref_cur.pose.phi_rad) << ',';
  writeCovariance(out, T_ref_cur.covariance);
  out << result.associations << ',' << result.iterations << ',' << 1e3 * result.times.segmentation_s
      << ',' << 1e3 * match.time_s << ',';
  writeOpen(out, result);
  out << (decides ? 1 : 0) << '\n';
}
}  // namespace

void writeMatchesCsv(std::ostream& out, const std::vector<PosedScan>& scans)
{
  out << kMatchesHeader;
  for (const auto& scan : scans)
    for (const auto& match : scan.matches) writeMatch(out, match, scan, scans[match.reference]);
}

void writeSegmentsCsv(std::ostream& out, const ScanMap& map)
{
  out << "x1_m,y1_m,x2_m,y2_m,points,sigma_m\n" << std::setprecision(7);
  for (const auto& wall : map.walls)
    out << wall.from_m.x() << ',' << wall.from_m.y() << ',' << wall.to_m.x() << ',' << wall.to_m.y()
        << ',' << wall.points << ',' << wall.sigma_m << '\n';
}
}  // namespace psmks
