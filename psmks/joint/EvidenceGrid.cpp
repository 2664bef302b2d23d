/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/features/RayOutcome.h>
#include <psmks/joint/EvidenceGrid.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace psmks
{
namespace
{
/** Side of a cell, but for scans of wide places. Evidence: cells of 15 cm find as many pairs, in
 * the same time. */
constexpr double kSmallestCell_m = 0.1;

/** Most cells of a grid. Unit: cells. Definition: scans of 20 m by 15 m that are searched 5 m about
 * have cells of 10 cm, and larger ones coarser cells. */
constexpr int kMostCells = 1 << 17;

/** How much larger the cells of a grid with too many are made. Unit: ratio. Definition: two steps
 * halve the number of the cells. */
constexpr double kCoarser = 1.2;

/** Points whose rays are found at once. Unit: points. Definition: a multiple of any vector
 * register.
 */
constexpr int kBlock = 32;

/** Evidence of a ray that ends on a surface, in front of it, behind it, and behind an object that
 * may have moved. Unit: 1 / 24 of a ray on a surface. Evidence: those of logLikelihoodRatio() put
 * too much against poses that are off by half a cell or half a step, so that walls stand in free
 * space: of every fourth scan of the MIT CSAIL log (`csail`) 81 % have the right pose among the
 * first eight with -72 and -24 in front and behind, 85 % with -48 and -24, 89 % with -36 and -12.
 */
constexpr std::int8_t kOn = EvidenceGrid::kOnSurface, kFront = -36, kBehind = -12, kUncovered = -6;

std::int8_t evidence(RayOutcome outcome)
{
  switch (outcome)
  {
    case RayOutcome::On:
      return kOn;
    case RayOutcome::Front:
      return kFront;
    case RayOutcome::Behind:
      return kBehind;
    case RayOutcome::Uncovered:
      return kUncovered;
    default:
      return 0;
  }
}

/** The rectangle about the end points of a scan and the scanner. */
EvidenceGrid::Extent extentOf(const RayPoints& points)
{
  EvidenceGrid::Extent e;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    e.left_m = std::min(e.left_m, points.x_m[i]), e.right_m = std::max(e.right_m, points.x_m[i]);
    e.bottom_m = std::min(e.bottom_m, points.y_m[i]), e.top_m = std::max(e.top_m, points.y_m[i]);
  }
  return e;
}
}  // namespace

void EvidenceGrid::reserve()
{
  for (auto& values : levels_) values.reserve(kMostCells);
}

void EvidenceGrid::build(const ScanFeatures& scan, double reach_m, double rangeTolerance_m)
{
  layOut(extentOf(scan.points), reach_m);
  std::vector<std::int8_t>& values = levels_[0];
  std::fill(values.begin(), values.end(), std::int8_t{0});
  const auto tolerance_m = static_cast<float>(rangeTolerance_m + cell_m_);
  for (int row = 2 * reach_; row < rows_ - reach_ - margin_; ++row)
    fillRow(scan.surface, row, tolerance_m);
  bound();
}

/** Chooses the cells:
 *
 *   | reach, never hit | reach | about the points of the scan | reach | margin |
 *
 * Rays of the guess end anywhere between the first reach and the margin. */
void EvidenceGrid::layOut(const Extent& extent, double reach_m)
{
  for (cell_m_ = kSmallestCell_m;; cell_m_ *= kCoarser)
  {
    perMetre_ = static_cast<float>(1 / cell_m_);
    reach_ = static_cast<int>(reach_m / cell_m_) + 1;
    margin_ = reach_ + (1 << (kLevels - 1));
    const int width = static_cast<int>((extent.right_m - extent.left_m) * perMetre_) + 3;
    const int height = static_cast<int>((extent.top_m - extent.bottom_m) * perMetre_) + 3;
    columns_ = 3 * reach_ + width + margin_;
    rows_ = 3 * reach_ + height + margin_;
    if (static_cast<double>(columns_) * rows_ <= kMostCells) break;
  }
  const auto before_m = static_cast<float>((2 * reach_ + 1) * cell_m_);
  originX_m_ = extent.left_m - before_m, originY_m_ = extent.bottom_m - before_m;
  for (auto& values : levels_) values.resize(static_cast<std::size_t>(columns_ * rows_));
}

/** Fills the cells of a row about the points of the scan, a block at a time, whose first loops
 * compilers vectorise. */
void EvidenceGrid::fillRow(const PolarLookup& surface, int row, float tolerance_m)
{
  const auto step_m = static_cast<float>(cell_m_);
  const float y_m = originY_m_ + (static_cast<float>(row) + 0.5f) * step_m;
  const int end = columns_ - reach_ - margin_;
  std::array<float, kBlock> x_m;
  std::array<int, kBlock> ray;
  for (int first = 2 * reach_; first < end; first += kBlock)
  {
    const float first_m = originX_m_ + (static_cast<float>(first) + 0.5f) * step_m;
    for (std::size_t i = 0; i < x_m.size(); ++i) x_m[i] = first_m + static_cast<float>(i) * step_m;
    for (std::size_t i = 0; i < x_m.size(); ++i) ray[i] = surface.cellOf(x_m[i], y_m);
    std::int8_t* values = levels_[0].data() + row * columns_ + first;
    const auto count = static_cast<std::size_t>(std::min(kBlock, end - first));
    for (std::size_t i = 0; i < count; ++i)
      values[i] = evidence(outcomeOf(surface, ray[i], x_m[i], y_m, tolerance_m));
  }
}

void EvidenceGrid::bound()
{
  const auto size = static_cast<std::size_t>(columns_ * rows_);
  for (int h = 1; h < kLevels; ++h)
  {
    const int half = 1 << (h - 1);
    const std::int8_t* from = level(h - 1);
    std::int8_t* to = levels_[static_cast<std::size_t>(h)].data();
    const auto right = static_cast<std::size_t>(half),
               up = static_cast<std::size_t>(half * columns_);
    const std::size_t last = size - right - up;
    for (std::size_t i = 0; i < last; ++i)
      to[i] = std::max(std::max(from[i], from[i + right]),
                       std::max(from[i + up], from[i + up + right]));
    std::fill(to + last, to + size, std::int8_t{0});
  }
}
}  // namespace psmks
