/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/features/FreeSpaceScore.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace psmks
{
namespace
{
/** Weight of a ray behind the surface, which may have been hidden from the other viewpoint. Unit:
 * rays in front. Evidence: measured. */
constexpr double kBehindWeight = 0.5;

/** Weight of a ray in front of the surface on an object that may have moved there. Unit: rays in
 * front. Evidence: measured. */
constexpr double kMovedWeight = 0.5;

/** Weight of a ray behind an object that may have moved away. Unit: rays in front. Evidence:
 * measured.
 */
constexpr double kUncoveredWeight = 0.25;

/** Share of the rays that the other scan has to have seen before the score is reduced. Unit: share.
 * Evidence: measured. */
constexpr double kFullyVisible = 0.4;

/** Smallest tolerance within which a point is on a surface. Evidence: measured. */
constexpr double kSmallestTolerance_m = 0.04;

/** Tolerance besides the range noise, for what surfaces are not straight. Evidence: measured. */
constexpr double kToleranceMargin_m = 0.01;

/** Standard deviations of a range that the tolerance includes. Unit: standard deviations.
 * Evidence: 99.7 % of normal errors. */
constexpr double kToleranceSigmas = 3;

/** A block of points as seen from the scanner of the surface. Its loops run over arrays of fixed
 * size, which compilers vectorise without special flags. */
class PointBlock
{
 public:
  /** Points of a block. Unit: points. Definition: capacity of the arrays; a multiple of any vector
   * register. */
  static constexpr std::size_t kCapacity = 32;

  /** Loads every `stride`-th point from `first` on, as many as fit.
   *  @return index of the next point to load */
  std::size_t load(const RayPoints& points, std::size_t first, std::size_t stride)
  {
    size_ = 0;
    for (; first < points.size() && size_ < kCapacity; first += stride, ++size_)
    {
      x_[size_] = points.x_m[first];
      y_[size_] = points.y_m[first];
      movable_[size_] = points.movable[first];
    }
    std::fill(x_.begin() + size_, x_.end(), 1.0f);
    std::fill(y_.begin() + size_, y_.end(), 0.0f);
    return first;
  }

  /** Transforms the points into another frame. */
  void move(const Pose2& T)
  {
    const auto c = static_cast<float>(std::cos(T.phi_rad)),
               s = static_cast<float>(std::sin(T.phi_rad));
    const auto tx = static_cast<float>(T.x_m), ty = static_cast<float>(T.y_m);
    for (std::size_t i = 0; i < kCapacity; ++i)
    {
      const float x = c * x_[i] - s * y_[i] + tx, y = s * x_[i] + c * y_[i] + ty;
      x_[i] = x;
      y_[i] = y;
    }
  }

  /** Finds the cell of the surface at the bearing of each point. */
  void find(const PolarLookup& surface)
  {
    for (std::size_t i = 0; i < kCapacity; ++i) cell_[i] = surface.cellOf(x_[i], y_[i]);
  }

  /** Adds the points to the counts. */
  void count(const PolarLookup& surface, float tolerance_m, RayCounts& counts) const
  {
    RayCounts n;
    for (std::size_t i = 0; i < size_; ++i)
    {
      const int k = cell_[i];
      if (k < 0 || !surface.known(k))
      {
        ++n.unknown;
        continue;
      }
      const PolarLookup::Side* sides = surface.sides(k);
      const float a_m = sides[0].distance_m(x_[i], y_[i]), b_m = sides[1].distance_m(x_[i], y_[i]);
      if (std::min(std::fabs(a_m), std::fabs(b_m)) < tolerance_m)
        ++n.on;
      else if (std::max(a_m, b_m) < 0)
        ++(movable_[i] ? n.moved : n.front);
      else if (std::min(a_m, b_m) > 0)
        ++(surface.movable(k) ? n.uncovered : n.behind);
      // A point between the near and the far side of a jump is not counted: anything may be there.
    }
    counts += n;
  }

 private:
  std::array<float, kCapacity> x_, y_;
  std::array<int, kCapacity> cell_;
  std::array<std::uint8_t, kCapacity> movable_;
  std::size_t size_ = 0;
};
}  // namespace

RayCounts countRays(const RayPoints& points, const PolarLookup& surface,
                    const Pose2& T_surface_points, float tolerance_m, int stride)
{
  RayCounts counts;
  PointBlock block;
  for (std::size_t next = 0; next < points.size();)
  {
    next = block.load(points, next, static_cast<std::size_t>(stride));
    block.move(T_surface_points);
    block.find(surface);
    block.count(surface, tolerance_m, counts);
  }
  return counts;
}

double freeSpaceScore(const RayCounts& n)
{
  const double decided = n.on + n.front + (kBehindWeight * n.behind + kMovedWeight * n.moved) +
                         kUncoveredWeight * n.uncovered;
  const double seen = n.on + n.front + n.behind + n.moved + n.uncovered;
  if (!(decided > 0)) return 0;
  const double visibleShare = seen / (seen + n.unknown);
  return n.on / decided * std::min(1.0, visibleShare / kFullyVisible);
}

float surfaceTolerance_m(double rangeSigma_m)
{
  return static_cast<float>(
      std::max(kSmallestTolerance_m, kToleranceSigmas * rangeSigma_m + kToleranceMargin_m));
}
}  // namespace psmks
