/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/report/PairDrawings.h>
#include <apps/psmks-benchmark/report/ScanOutline.h>
#include <psmks/geometry/Angle.h>

#include <Eigen/Geometry>
#include <array>
#include <iomanip>
#include <locale>
#include <sstream>

namespace psmks
{
namespace
{
constexpr double kCentimetresPerMetre = 100;
constexpr double kMillimetresPerMetre = 1000;
constexpr double kMargin = 0.04;  // width of the border, as a share of the side of the picture
/** Half the length of a sensor's arrow, as a share of the side. */
constexpr double kSensorShare = 0.025;
constexpr double kTextShare = 0.06;      // height of letters, as a share of the side
constexpr double kScaleBarShare = 0.25;  // largest length, as a share of the side

std::ostringstream numberStream(int decimals)
{
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << std::fixed << std::setprecision(decimals);
  return out;
}

/** The SVG transformation of a pose. The y axis of SVG points down, and its angles are clockwise.
 */
std::string transformOf(const Pose2& pose)
{
  std::ostringstream out = numberStream(1);
  out << "translate(" << kCentimetresPerMetre * pose.x_m << ',' << -kCentimetresPerMetre * pose.y_m
      << ") rotate(" << std::setprecision(3) << -radToDeg(pose.phi_rad) << ')';
  return out.str();
}

/** A square around all that a picture shows, in the frame of the reference. */
Eigen::AlignedBox2d extentOf(const ScanPair& pair, const PairRecord& record)
{
  Eigen::AlignedBox2d extent(Eigen::Vector2d::Zero());
  extent.extend(record.T_ref_cur_guess.translation());
  for (const auto& p_m : returnPoints(pair.reference)) extent.extend(p_m);
  for (const auto& p_m : returnPoints(pair.current))
  {
    extent.extend(record.T_ref_cur_true * p_m);
    extent.extend(record.result.T_ref_cur * p_m);
  }
  const double half_m = (0.5 + kMargin) * extent.sizes().maxCoeff();
  const Eigen::Vector2d centre = extent.center();
  return {centre.array() - half_m, centre.array() + half_m};
}

std::string arrow(const char* role, const Pose2& T_ref_sensor, double length_m)
{
  std::ostringstream out = numberStream(0);
  const double l = kCentimetresPerMetre * length_m, w = l / 2;
  out << "<path class=\"outline " << role << "\" transform=\"" << transformOf(T_ref_sensor)
      << "\" d=\"M" << -l << ' ' << -w << 'L' << l << " 0L" << -l << ' ' << w << "z\"/>";
  return out.str();
}

/** A scale bar in the lower left corner. */
std::string scaleBar(const Eigen::AlignedBox2d& extent)
{
  constexpr std::array<double, 6> kLengths_m{10, 5, 2, 1, 0.5, 0.2};
  double length_m = kLengths_m.back();
  for (auto it = kLengths_m.rbegin(); it != kLengths_m.rend(); ++it)
    if (*it <= kScaleBarShare * extent.sizes().x()) length_m = *it;

  const double side_m = extent.sizes().x();
  const double x = kCentimetresPerMetre * (extent.min().x() + kMargin / 2 * side_m);
  const double y = -kCentimetresPerMetre * (extent.min().y() + kMargin / 2 * side_m);
  std::ostringstream out = numberStream(0);
  out << "<path class=\"outline\" stroke=\"#222\" d=\"M" << x << ' ' << y << 'h'
      << kCentimetresPerMetre * length_m << "\"/><text x=\"" << x << "\" y=\""
      << y - kCentimetresPerMetre * kMargin / 2 * side_m << "\" font-size=\""
      << kCentimetresPerMetre * kTextShare * side_m << "\">" << std::defaultfloat << length_m
      << " m</text>";
  return out.str();
}

std::string caption(const PairRecord& record)
{
  std::ostringstream out = numberStream(1);
  out << "pair " << record.id << ": " << kMillimetresPerMetre * record.error().translation_m
      << " mm, " << std::setprecision(3) << radToDeg(record.error().rotation_rad) << " deg, "
      << toString(record.result.status);
  return out.str();
}

std::string viewBox(const Eigen::AlignedBox2d& extent)
{
  std::ostringstream out = numberStream(0);
  out << kCentimetresPerMetre * extent.min().x() << ' ' << -kCentimetresPerMetre * extent.max().y()
      << ' ' << kCentimetresPerMetre * extent.sizes().x() << ' '
      << kCentimetresPerMetre * extent.sizes().y();
  return out.str();
}
}  // namespace

std::string PairDrawings::draw(std::size_t place, const PairRecord& record)
{
  drawn_.insert(place);
  const Pose2& truth = record.T_ref_cur_true;
  const Pose2& estimate = record.result.T_ref_cur;
  const Eigen::AlignedBox2d extent = extentOf(pairs_[place], record);
  const double arrow_m = kSensorShare * extent.sizes().x();
  return "<figure><svg class=\"drawing\" viewBox=\"" + viewBox(extent) + "\">" +
         use(place, "reference", "reference", Pose2()) + use(place, "current", "truth", truth) +
         use(place, "current", "estimate", estimate) + arrow("reference", Pose2(), arrow_m) +
         arrow("guess", record.T_ref_cur_guess, arrow_m) + arrow("truth", truth, arrow_m) +
         arrow("estimate", estimate, arrow_m) + scaleBar(extent) + "</svg><figcaption>" +
         caption(record) + "</figcaption></figure>\n";
}

std::string PairDrawings::outlines() const
{
  std::string html = "<svg class=\"outlines\"><defs>\n";
  const auto add = [&html, this](std::size_t place, const char* scan, const Scan& rays)
  {
    html += "<path class=\"outline\" id=\"" + outlineName(place, scan) + "\" d=\"" +
            outlinePath(rays) + "\"/>\n";
  };
  for (const std::size_t place : drawn_)
  {
    add(place, "reference", pairs_[place].reference);
    add(place, "current", pairs_[place].current);
  }
  return html + "</defs></svg>\n";
}

std::string PairDrawings::outlineName(std::size_t place, const char* scan) const
{
  return name_ + '-' + std::to_string(place) + '-' + scan;
}

std::string PairDrawings::use(std::size_t place, const char* scan, const char* role,
                              const Pose2& T_ref_scan) const
{
  return "<use href=\"#" + outlineName(place, scan) + "\" class=\"" + role + "\" transform=\"" +
         transformOf(T_ref_scan) + "\"/>";
}
}  // namespace psmks
