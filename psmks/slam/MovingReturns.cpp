/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/geometry/FastBearing.h>
#include <psmks/slam/MovingReturns.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
/** How far from a scan its witnesses stand at most. Definition: as far as keyframes are matched
 * against each other. With 6 m the same segments of people stay. */
constexpr double kWitnessReach_m = 4;

/** How far poses and ranges may be off. Definition: what overlap() forgives. */
constexpr double kTolerance_m = 0.3;

std::pair<int, int> cellAt(const Eigen::Vector2d& position_m)
{
  return {static_cast<int>(std::floor(position_m.x() / kWitnessReach_m)),
          static_cast<int>(std::floor(position_m.y() / kWitnessReach_m))};
}

/** What a scan says of a point in space. */
enum class Testimony
{
  Nothing,
  Met,
  LookedThrough
};

/** What a scan says of a point in the frame of its sensor: it looked through where all rays that
 * may have met the point went beyond it, and met it where one of them ended there.
 *  @param spacing_m rays that are farther apart there may pass what it lies on */
Testimony testimony(const Scan& witness, const Eigen::Vector2d& point_m, double spacing_m)
{
  /** How far aside of the point rays may have met it. Definition: the standard deviation of what is
   * known, see ReferencePolicy::isKnown(). */
  constexpr double kAside_m = 0.1;
  const double range_m = point_m.norm(), between_m = range_m * witness.grid.increment_rad();
  if (between_m > spacing_m) return Testimony::Nothing;
  const double index = witness.grid.index(
      fastBearing_rad(static_cast<float>(point_m.y()), static_cast<float>(point_m.x())));
  const int middle = static_cast<int>(std::lround(index));
  const int aside = static_cast<int>(std::ceil(kAside_m / between_m));
  bool isBeyond = true;
  for (int step = 0; step <= 2 * aside; ++step)
  {
    const int ray = witness.grid.neighbour(middle, step % 2 ? (step + 1) / 2 : -step / 2);
    const bool isSeen = ray >= 0 && isReturn(witness, ray);
    const double beyond_m = isSeen ? witness.range_m[static_cast<std::size_t>(ray)] - range_m : 0;
    if (isSeen && std::abs(beyond_m) <= kTolerance_m) return Testimony::Met;
    isBeyond = isBeyond && beyond_m > kTolerance_m;
  }
  return isBeyond ? Testimony::LookedThrough : Testimony::Nothing;
}

/** For each ray how close together the rays of a witness have to be, so that two of them meet what
 * it met: half of the width of the row of returns of about the same range. */
std::vector<double> neededSpacings_m(const Scan& scan)
{
  /** Of a thing that a single ray met. Definition: the width of a leg of a chair. */
  constexpr double kLeg_m = 0.03;
  const auto rays = static_cast<std::size_t>(scan.grid.count());
  std::vector<double> spacing_m(rays, kLeg_m);
  const auto isJoined = [&scan](std::size_t ray)
  {
    return isReturn(scan, static_cast<int>(ray)) && isReturn(scan, static_cast<int>(ray) - 1) &&
           std::abs(scan.range_m[ray] - scan.range_m[ray - 1]) < kTolerance_m;
  };
  for (std::size_t first = 0, next = 1; first < rays; first = next++)
  {
    while (next < rays && isJoined(next)) ++next;
    const double width_m =
        static_cast<double>(next - first - 1) * scan.grid.increment_rad() * scan.range_m[first];
    std::fill(spacing_m.begin() + static_cast<std::ptrdiff_t>(first),
              spacing_m.begin() + static_cast<std::ptrdiff_t>(next), std::max(kLeg_m, width_m / 2));
  }
  return spacing_m;
}
}  // namespace

MovingReturns::MovingReturns(const std::vector<PosedScan>& scans) : scans_(scans)
{
  for (std::size_t s = 0; s < scans.size(); ++s)
    if (scans[s].isReference && isWellFormed(scans[s].scan))
      references_[cellAt(scans[s].T_world_sensor().translation())].push_back(s);
}

/** The nearest references, without the scan itself. */
std::vector<std::size_t> MovingReturns::witnessesOf(std::size_t index) const
{
  /** Most of them. Unit: scans. Evidence: 12 of 70 segments of people stay in the map of an office,
   * with 12 witnesses 35. */
  constexpr std::size_t kMost = 40;
  const Eigen::Vector2d here_m = scans_[index].T_world_sensor().translation();
  const Cell centre = cellAt(here_m);
  std::vector<std::pair<double, std::size_t>> near;  // each with its distance
  for (int x = centre.first - 1; x <= centre.first + 1; ++x)
    for (int y = centre.second - 1; y <= centre.second + 1; ++y)
    {
      const auto found = references_.find({x, y});
      if (found == references_.end()) continue;
      for (const std::size_t reference : found->second)
      {
        const double apart_m = (scans_[reference].T_world_sensor().translation() - here_m).norm();
        if (reference != index && apart_m < kWitnessReach_m) near.emplace_back(apart_m, reference);
      }
    }
  std::sort(near.begin(), near.end());
  if (near.size() > kMost) near.resize(kMost);
  std::vector<std::size_t> witnesses;
  witnesses.reserve(near.size());
  for (const auto& [apart_m, reference] : near) witnesses.push_back(reference);
  return witnesses;
}

std::vector<std::uint8_t> MovingReturns::of(std::size_t index) const
{
  /** So many witnesses outweigh an error of one of them. Unit: scans. Definition: one more than
   * one.
   */
  constexpr int kFewest = 2;
  const PosedScan& posed = scans_[index];
  const auto rays = static_cast<std::size_t>(posed.scan.grid.count());
  std::vector<std::uint8_t> moving(rays, 0);
  if (!isWellFormed(posed.scan)) return moving;
  const std::vector<double> spacing_m = neededSpacings_m(posed.scan);
  std::vector<int> through(rays, 0), met(rays, 0);
  const std::vector<std::size_t> witnesses = witnessesOf(index);
  for (std::size_t w = 0; w < witnesses.size(); ++w)
  {
    const std::size_t witness = witnesses[w];
    const int left = static_cast<int>(witnesses.size() - w);
    const Pose2 T_witness_sensor =
        scans_[witness].T_world_sensor().inverse() * posed.T_world_sensor();
    const Eigen::Matrix2d R = T_witness_sensor.rotation();
    for (std::size_t ray = 0; ray < rays; ++ray)
    {
      const bool isOpen = through[ray] + left > met[ray];
      if (!isOpen || !isReturn(posed.scan, static_cast<int>(ray))) continue;
      const Eigen::Vector2d point_m =
          posed.scan.range_m[ray] * posed.scan.grid.direction(static_cast<int>(ray));
      const Testimony says = testimony(
          scans_[witness].scan, R * point_m + T_witness_sensor.translation(), spacing_m[ray]);
      through[ray] += says == Testimony::LookedThrough ? 1 : 0;
      met[ray] += says == Testimony::Met ? 1 : 0;
    }
  }
  for (std::size_t ray = 0; ray < rays; ++ray)
    moving[ray] = through[ray] >= kFewest && through[ray] > met[ray] ? 1 : 0;
  return moving;
}
}  // namespace psmks
