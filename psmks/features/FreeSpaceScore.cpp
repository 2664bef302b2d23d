/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/features/FreeSpaceScore.h>
#include <psmks/features/RayOutcome.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace psmks
{
namespace
{
/** What a look on a surface says for a pose. Unit: nat. Evidence: ln = 0.7 of the shares of the
 * looks that are on surfaces at right and at the best wrong poses (docs/benchmarks.md, "Likelihood
 * of the rays"), less for what looks have in common. */
constexpr double kOnSurface = 0.6;

/** Weight of a look in free space against the pose. Unit: looks on a surface. Evidence: ln = -2.7
 * of the same shares, 4 times 0.7. */
constexpr double kFrontWeight = 4;

/** Weight of a look behind a surface, which may have been hidden. Unit: looks on a surface.
 * Evidence: ln = -1.1 of the same shares; with 2 in place of 1, 1.9 times as many wrong poses score
 * as much as right ones on every fourth scan of the MIT CSAIL log (`csail`). */
constexpr double kBehindWeight = 1;

/** Weight of a look at an object that may have moved. Unit: looks on a surface. Evidence: ln =
 * -0.9 and -0.3 of the same shares for what stands in front and behind. */
constexpr double kMayHaveMovedWeight = 0.25;

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
      looks_[size_] = points.looks[first];
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
      switch (outcomeOf(surface, cell_[i], x_[i], y_[i], tolerance_m))
      {
        case RayOutcome::On:
          n.on += looks_[i], ++n.raysOn;
          break;
        case RayOutcome::Front:
          (movable_[i] ? n.moved : n.front) += looks_[i];
          break;
        case RayOutcome::Behind:
          n.behind += looks_[i];
          break;
        case RayOutcome::Uncovered:
          n.uncovered += looks_[i];
          break;
        case RayOutcome::Unknown:
          n.unknown += looks_[i];
          break;
        case RayOutcome::Undecided:
          break;
      }
    n.rays = static_cast<int>(size_);
    counts += n;
  }

 private:
  std::array<float, kCapacity> x_, y_, looks_;
  std::array<int, kCapacity> cell_;
  std::array<std::uint8_t, kCapacity> movable_;
  std::size_t size_ = 0;
};

/** What speaks against a pose, in looks on surfaces that speak for it. */
double against(const RayCounts& n)
{
  return kFrontWeight * n.front + kBehindWeight * n.behind +
         kMayHaveMovedWeight * (n.moved + n.uncovered);
}
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
  const auto skipped = static_cast<float>(stride);
  counts.on *= skipped, counts.front *= skipped, counts.behind *= skipped;
  counts.moved *= skipped, counts.uncovered *= skipped, counts.unknown *= skipped;
  return counts;
}

double logLikelihoodRatio(const RayCounts& n)
{
  /** Most looks that are independent. Unit: looks. Evidence: in a round room of 15 m
   * radius, with 380 to 720 looks, headings that explain the scans alike differ by 31 to 42 nat if
   * all of them count, and by 3 to 4 if 50 do. */
  constexpr float kMostIndependent = 50;
  const double share = std::min(1.0f, kMostIndependent / std::max(1.0f, n.looks()));
  return kOnSurface * share * (n.on - against(n));
}

double freeSpaceScore(const RayCounts& n)
{
  const double decided = n.on + against(n);
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
