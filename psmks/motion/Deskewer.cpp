/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/geometry/BeamTiming.h>
#include <psmks/motion/Deskewer.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace psmks
{
namespace
{
/** So many rays of this increment fit into a circle. */
int raysOfCircle(double increment_rad)
{
  return static_cast<int>(std::floor(2 * kPi / increment_rad + 0.5));
}

void dropRaysFrom(int first, Scan& scan)
{
  const auto rays = static_cast<std::size_t>(first);
  scan.range_m.resize(rays);
  if (!scan.valid.empty()) scan.valid.resize(rays);
}

/** The grid of a scan whose scanner turns during the sweep, seen from the pose of the scan; an
 * empty one where the scanner turns back faster than the beam goes round. */
BeamGrid sweptGrid(const Scan& scan, double turnRate_rad_s)
{
  const int rays = scan.grid.count();
  const double turned_rad = turnRate_rad_s * scan.sweepDuration_s;
  if (turned_rad == 0) return scan.grid;
  const double before_rad = scan.interleavedTurns > 1 ? turned_rad / 2 : 0;
  const double first_rad = scan.grid.firstBearing_rad() - before_rad;
  const double increment_rad = scan.grid.increment_rad() + turned_rad / (rays - 1);
  if (!BeamGrid::accepts(first_rad, increment_rad, 1)) return {};
  return {first_rad, increment_rad, std::min(rays, raysOfCircle(increment_rad))};
}

double median(std::vector<double>& values)
{
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/** Stands for a range that there is not. Unit: m. Definition: compares with none. */
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
}  // namespace

void Deskewer::deskew(Scan& scan, const PlanarVelocity& velocity)
{
  if (velocity.isZero() || !velocity.isFinite() || !prepare(scan)) return;
  BeamGrid swept = sweptGrid(scan, velocity.phi_rad_s);
  if (swept.count() == 0) return;
  grid_ = std::move(swept);
  scan.grid = grid_;
  dropRaysFrom(grid_.count(), scan);
  if (turns_ == 1) return;
  measureSlopes();
  correctAll(velocity);
  valid_ = scan.valid;
  for (int ray = 0; ray < grid_.count(); ++ray) takeCorrected(ray, scan);
}

/** Gives a ray of a scan its corrected range, or the state of a ray without return in its place. */
void Deskewer::takeCorrected(int ray, Scan& scan) const
{
  const auto i = static_cast<std::size_t>(ray);
  const int source = source_[i];
  if (source != ray && !valid_.empty())
    scan.valid[i] = source < 0 ? 0 : valid_[static_cast<std::size_t>(source)];
  if (std::isfinite(corrected_m_[i]))
    scan.range_m[i] = corrected_m_[i];
  else if (source != ray)
    scan.range_m[i] = kNone;
}

/** Notes the grid, the ranges and the times of a scan.
 *  @return false where it cannot be corrected */
bool Deskewer::prepare(const Scan& scan)
{
  const int rays = scan.grid.count();
  turns_ = std::max(1, scan.interleavedTurns);
  const bool isTimed = scan.sweepDuration_s != 0 || (turns_ > 1 && scan.turn_s != 0);
  if (rays < 2 || !isTimed || !isWellFormed(scan)) return false;
  grid_ = scan.grid;
  range_m_.resize(scan.range_m.size());
  time_s_.resize(scan.range_m.size());
  turnOffset_s_.resize(scan.range_m.size());
  for (int ray = 0; ray < rays; ++ray)
  {
    const auto i = static_cast<std::size_t>(ray);
    range_m_[i] = isReturn(scan, ray) ? scan.range_m[i] : kNone;
    time_s_[i] = sinceMiddle_s(scan, ray);
    turnOffset_s_[i] = turnOffset_s(scan, ray);
  }
  return true;
}

/** Notes how the inverse range changes from each ray to the next one of its turn, and how much the
 * ranges scatter about straight surfaces. */
void Deskewer::measureSlopes()
{
  const std::size_t rays = range_m_.size(), apart = static_cast<std::size_t>(turns_);
  const double step_rad = turns_ * grid_.increment_rad();
  rise_.assign(rays, kNone);
  for (std::size_t i = 0; i + apart < rays; ++i)
    rise_[i] = (1 / range_m_[i + apart] - 1 / range_m_[i]) / step_rad;
  sizes_.clear();
  for (std::size_t i = apart; i < rays; ++i)
  {
    const double bend_m = bendAt_m(i, i - apart, i);
    if (std::isfinite(bend_m)) sizes_.push_back(bend_m);
  }
  typicalBend_m_ = median(sizes_);
  slope_m_rad_.resize(rays);
  for (std::size_t i = 0; i < rays; ++i) slope_m_rad_[i] = slopeAt(i);
}

/** By how much three rays of a turn miss a straight line, as a range near a ray: by the change from
 * one step of the inverse range to the next. */
double Deskewer::bendAt_m(std::size_t ray, std::size_t firstStep, std::size_t secondStep) const
{
  return std::abs(rise_[secondStep] - rise_[firstStep]) * range_m_[ray] * range_m_[ray] * turns_ *
         grid_.increment_rad();
}

/** The slope of the range along a straight surface at a ray: the mean over the steps of those three
 * rays of its turn, it among them, that lie on a line. An edge next to the ray leaves those on
 * the other side of it. Where both sides are straight and end at the ray, or none is, it is 0. */
double Deskewer::slopeAt(std::size_t ray) const
{
  /** Bend beyond which three rays are on no straight surface. Unit: median bends of the scan.
   * Definition: two standard deviations of normal noise. */
  constexpr double kLargestBend = 3;

  /** The same where most rays of a scan are in foliage. Definition: three standard deviations of
   * the bend of ranges with a noise of 1 cm. */
  constexpr double kLargestBend_m = 0.07;
  const double limit_m = std::min(kLargestBend_m, kLargestBend * typicalBend_m_);
  const std::size_t apart = static_cast<std::size_t>(turns_), rays = range_m_.size();
  const auto isStraight = [&](std::size_t step)
  { return step + apart < rays && bendAt_m(ray, step, step + apart) <= limit_m; };
  const bool before = ray >= 2 * apart && isStraight(ray - 2 * apart);
  const bool around = ray >= apart && isStraight(ray - apart);
  const bool after = isStraight(ray);
  if (before && after && !around) return 0;

  double sum = 0;
  int steps = 0;
  const auto take = [&](bool counts, std::size_t step)
  {
    if (!counts) return;
    sum += rise_[step];
    ++steps;
  };
  take(before, ray - 2 * apart);
  take(before || around, ray - apart);
  take(around || after, ray);
  take(after, ray + apart);
  return steps > 0 ? -range_m_[ray] * range_m_[ray] * sum / steps : 0;
}

Deskewer::MovedRay Deskewer::moved(int ray, const PlanarVelocity& velocity) const
{
  const auto i = static_cast<std::size_t>(ray);
  const double turned_rad = velocity.phi_rad_s * turnOffset_s_[i];
  if (!std::isfinite(range_m_[i])) return {kNone, turned_rad};
  const Eigen::Vector2d sight = grid_.direction(ray);
  const Eigen::Vector2d moved_m = time_s_[i] * Eigen::Vector2d(velocity.x_m_s, velocity.y_m_s);
  const double along_m = range_m_[i] + sight.dot(moved_m);
  const double aside_m = sight.x() * moved_m.y() - sight.y() * moved_m.x();
  return {std::hypot(along_m, aside_m), turned_rad + std::atan2(aside_m, along_m)};
}

/** The ray of the same turn that lies nearest to a ray of the grid once it is moved, or -1 beyond
 * the end of an open grid. */
int Deskewer::nearestMoved(int ray, const PlanarVelocity& velocity) const
{
  /** Looks for the nearest ray. Unit: looks. Definition: neighbours move alike, so that the first
   * step finds it but where the surface ends. */
  constexpr int kLooks = 3;
  int source = ray;
  for (int look = 0; look < kLooks; ++look)
  {
    const double apart = moved(source, velocity).excess_rad / (turns_ * grid_.increment_rad());
    const int next = ray - turns_ * static_cast<int>(std::lround(apart));
    if (next == source) break;
    if (next < 0 || next >= grid_.count()) return -1;
    source = next;
  }
  return source;
}

/** The range that a ray of the grid takes from a moved ray, along the surface there. */
double Deskewer::correctedRange_m(int ray, int source, const PlanarVelocity& velocity) const
{
  const MovedRay ofSource = moved(source, velocity);
  const double slope_m_rad = slope_m_rad_[static_cast<std::size_t>(source)];
  const double beyond_rad = ofSource.excess_rad + (source - ray) * grid_.increment_rad();
  return ofSource.range_m / (1 + slope_m_rad * beyond_rad / ofSource.range_m);
}

void Deskewer::correctAll(const PlanarVelocity& velocity)
{
  corrected_m_.assign(range_m_.size(), kNone);
  source_.assign(range_m_.size(), -1);
  for (int ray = 0; ray < grid_.count(); ++ray)
  {
    const auto i = static_cast<std::size_t>(ray);
    const int source = nearestMoved(ray, velocity);
    source_[i] = source;
    if (source >= 0) corrected_m_[i] = correctedRange_m(ray, source, velocity);
  }
}

/** The derivative of a corrected range by the velocity, but for what the even grid takes up. */
Eigen::Vector3d Deskewer::sensitivity(int ray) const
{
  const auto i = static_cast<std::size_t>(source_[static_cast<std::size_t>(ray)]);
  const Eigen::Vector2d sight = grid_.direction(ray);
  const double slope_m_rad = slope_m_rad_[i], perRange = slope_m_rad / range_m_[i];
  return {time_s_[i] * (sight.x() + perRange * sight.y()),
          time_s_[i] * (sight.y() - perRange * sight.x()), -turnOffset_s_[i] * slope_m_rad};
}

/** Adds what the differences between each ray and its neighbours of other turns say of the
 * velocity. */
void Deskewer::addDifferences(double scale_m, Eigen::Matrix3d& information, Eigen::Vector3d& pull)
{
  /** Variance of a difference over that with which the mean of many of them, their signs taken in
   * turn, tells the shift between two turns: each ray is in three of them. Unit: ratio.
   * Definition: (1 + 2 / 4) s^2 over (2 s)^2. */
  constexpr double kIndependent = 1.5 / 4;
  for (int ray = 1; ray + 1 < grid_.count(); ++ray)
  {
    const double difference_m = difference_m_[static_cast<std::size_t>(ray)];
    if (!std::isfinite(difference_m)) continue;
    const Eigen::Vector3d row =
        sensitivity(ray) - (sensitivity(ray - 1) + sensitivity(ray + 1)) / 2;
    const double sigmas = difference_m / scale_m;
    const double weight = kIndependent / ((1 + sigmas * sigmas) * scale_m * scale_m);
    information += weight * row * row.transpose();
    pull -= weight * difference_m * row;
  }
}

/** Notes the differences between each ray and the straight line between its neighbours.
 *  @return their median absolute value; 0 where there is none */
double Deskewer::typicalDifference_m()
{
  difference_m_.assign(range_m_.size(), kNone);
  sizes_.clear();
  for (int ray = 1; ray + 1 < grid_.count(); ++ray)
  {
    const auto i = static_cast<std::size_t>(ray);
    // The inverse range is linear along a straight surface, but for the square of the increment.
    const double difference_m =
        corrected_m_[i] - 2 / (1 / corrected_m_[i - 1] + 1 / corrected_m_[i + 1]);
    difference_m_[i] = difference_m;
    if (std::isfinite(difference_m)) sizes_.push_back(std::abs(difference_m));
  }
  return median(sizes_);
}

PlanarVelocity Deskewer::fittedVelocity(const Scan& scan, const PlanarVelocity& expected,
                                        const Eigen::Matrix3d& covariance)
{
  /** Steps of the solution. Unit: steps. Definition: the corrected ranges are all but linear in the
   * velocity, so that the second one only looks up rays that the first one moved elsewhere. */
  constexpr int kSteps = 3;
  /** Standard deviation of normal numbers over the median of their absolute values. Unit: ratio.
   * Definition: of the normal distribution. */
  constexpr double kNormalSigma = 1.4826;
  /** Least scale of the differences. Definition: the unit in which scanners send ranges. */
  constexpr double kLeastScale_m = 1e-3;
  if (scan.interleavedTurns < 2 || scan.turn_s == 0 || !prepare(scan)) return expected;
  measureSlopes();
  const Eigen::Matrix3d prior = covariance.inverse();
  const Eigen::Vector3d middle(expected.x_m_s, expected.y_m_s, expected.phi_rad_s);
  Eigen::Vector3d fitted = middle;
  for (int step = 0; step < kSteps; ++step)
  {
    correctAll({fitted.x(), fitted.y(), fitted.z()});
    const double scale_m = std::max(kLeastScale_m, kNormalSigma * typicalDifference_m());
    Eigen::Matrix3d information = prior;
    Eigen::Vector3d pull = prior * (middle - fitted);
    addDifferences(scale_m, information, pull);
    fitted += information.ldlt().solve(pull);
    if (!fitted.allFinite()) return expected;
  }
  return {fitted.x(), fitted.y(), fitted.z()};
}
}  // namespace psmks
