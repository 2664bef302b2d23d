/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/geometry/BeamGrid.h>

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

namespace psmks
{
namespace
{
std::string valueText(double value)
{
  std::ostringstream out;
  out << value;
  return out.str();
}

bool isFirstBearing(double bearing_rad)
{
  return std::abs(bearing_rad) <= BeamGrid::kLargestBearing_rad;
}

bool isIncrement(double increment_rad)
{
  return increment_rad >= BeamGrid::kLeastIncrement_rad && std::isfinite(increment_rad);
}

/** Whether rays over such an angle do not go more than once round. */
bool isWithinCircle(double circle_rad, double increment_rad)
{
  return circle_rad < 2 * kPi + increment_rad / 2;
}

void requireGrid(bool condition, const char* what, double value)
{
  if (!condition) throw std::invalid_argument("BeamGrid: " + (what + (" " + valueText(value))));
}
}  // namespace

BeamGrid::BeamGrid() : directions_(std::make_shared<Directions>()) {}

BeamGrid::BeamGrid(double firstBearing_rad, double increment_rad, int count)
    : first_rad_(firstBearing_rad), increment_rad_(increment_rad), count_(count)
{
  requireGrid(isFirstBearing(firstBearing_rad), "the first bearing must be within two turns, got",
              firstBearing_rad);
  requireGrid(isIncrement(increment_rad), "the increment must be at least 1e-05 rad, got",
              increment_rad);
  requireGrid(count >= 0, "the count must not be negative, got", count);
  const double circle_rad = count * increment_rad;
  requireGrid(isWithinCircle(circle_rad, increment_rad),
              "the rays go more than once round, rad:", circle_rad);
  closed_ = circle_rad > 2 * kPi - increment_rad / 2;

  auto directions = std::make_shared<Directions>();
  directions->cosine.resize(static_cast<std::size_t>(count));
  directions->sine.resize(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
  {
    directions->cosine[static_cast<std::size_t>(i)] = std::cos(bearing_rad(i));
    directions->sine[static_cast<std::size_t>(i)] = std::sin(bearing_rad(i));
  }
  directions_ = std::move(directions);
}

bool BeamGrid::accepts(double firstBearing_rad, double increment_rad, int count)
{
  return isFirstBearing(firstBearing_rad) && isIncrement(increment_rad) && count >= 0 &&
         isWithinCircle(count * increment_rad, increment_rad);
}

BeamGrid BeamGrid::centered(double fieldOfView_rad, int count)
{
  /** A field of view this close to a circle is one. Definition: the rounding of angles. */
  constexpr double kRounding_rad = 1e-9;
  const bool fullCircle = fieldOfView_rad > 2 * kPi - kRounding_rad;
  const int steps = fullCircle ? count : count - 1;
  return {-fieldOfView_rad / 2, fieldOfView_rad / std::max(1, steps), count};
}

double BeamGrid::fieldOfView_rad() const
{
  return closed_ ? 2 * kPi : increment_rad_ * std::max(0, count_ - 1);
}

double BeamGrid::index(double bearing_rad) const
{
  const double centre = 0.5 * (count_ - 1);
  const double fromCentre_rad = wrapAngle(bearing_rad - first_rad_ - centre * increment_rad_);
  const double i = centre + fromCentre_rad / increment_rad_;
  return closed_ && i >= count_ - 0.5 ? i - count_ : i;
}

int BeamGrid::neighbour(int i, int step) const
{
  const int j = i + step;
  if (j >= 0 && j < count_) return j;
  if (!closed_) return -1;
  return (j % count_ + count_) % count_;
}

bool BeamGrid::operator==(const BeamGrid& other) const
{
  return count_ == other.count_ && first_rad_ == other.first_rad_ &&
         increment_rad_ == other.increment_rad_;
}
}  // namespace psmks
