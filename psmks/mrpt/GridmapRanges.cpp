/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <mrpt/serialization/CArchive.h>
#include <psmks/gzip/GzipInput.h>
#include <psmks/mrpt/GridmapRanges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

namespace psmks
{
using mrpt::maps::COccupancyGridMap2D;

namespace
{
/** A cell that is free with a higher probability is free; as far above 1/2, which is unknown, as
 *  GridmapRanges::kSolidBelow is beneath it. */
constexpr float kFreeAbove = 0.6f;

/** Where a ray crosses the edges between cells along one axis: the range to the next edge, and the
 *  range from edge to edge. */
struct Edges
{
  double next_m, spacing_m;
  int step;  //!< what crossing an edge adds to the cell's index: -1, 0 or 1
};

/** The edges ahead of a ray that begins at o, `inCell_m` behind the lower edge of its cell:
 *
 *      |        o----|--------|---->
 *      |        next  spacing                                                                 */
Edges edgesAlong(double inCell_m, double direction, double cell_m)
{
  constexpr double kNever_m = std::numeric_limits<double>::infinity();
  if (direction > 0) return {(cell_m - inCell_m) / direction, cell_m / direction, 1};
  if (direction < 0) return {inCell_m / -direction, cell_m / -direction, -1};
  return {kNever_m, kNever_m, 0};
}

/** Distance from a point to a square; 0 within it. */
double distanceToBox_m(const Eigen::Vector2d& point_m, const Eigen::Vector2d& middle_m,
                       double side_m)
{
  const Eigen::Array2d beyond_m = (point_m - middle_m).array().abs() - side_m / 2;
  return beyond_m.max(0).matrix().norm();
}

}  // namespace

GridmapRanges::GridmapRanges(const COccupancyGridMap2D& map)
    : columns_(static_cast<int>(map.getSizeX())),
      rows_(static_cast<int>(map.getSizeY())),
      cell_m_(map.getResolution()),
      corner_m_(map.getXMin(), map.getYMin())
{
  cells_.reserve(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column)
    {
      const float free = map.getCell(column, row);
      cells_.push_back(free < kSolidBelow  ? Cell::Solid
                       : free > kFreeAbove ? Cell::Free
                                           : Cell::Unknown);
    }
}

std::optional<GridmapRanges::Reading> GridmapRanges::cast(const Eigen::Vector2d& origin_m,
                                                          const Eigen::Vector2d& direction,
                                                          double maxRange_m) const
{
  Eigen::Vector2i cell = cellOf(origin_m);
  const Eigen::Vector2d inCell_m = origin_m - corner_m_ - cell_m_ * cell.cast<double>();
  Edges x = edgesAlong(inCell_m.x(), direction.x(), cell_m_);
  Edges y = edgesAlong(inCell_m.y(), direction.y(), cell_m_);
  double range_m = 0;
  while (isInside(cell) && !isSolid(cell) && range_m < maxRange_m)
  {
    const bool crossesX = x.next_m < y.next_m;
    Edges& crossed = crossesX ? x : y;
    range_m = crossed.next_m;
    crossed.next_m += crossed.spacing_m;
    cell[crossesX ? 0 : 1] += crossed.step;
  }
  if (!isInside(cell) || range_m >= maxRange_m) return std::nullopt;
  return Reading{range_m, cell.x() + cell.y() * columns_};
}

double GridmapRanges::clearance_m(const Eigen::Vector2d& point_m, double limit_m) const
{
  const Eigen::Vector2d reach_m = Eigen::Vector2d::Constant(limit_m);
  const Eigen::Vector2i last(columns_ - 1, rows_ - 1);
  const Eigen::Vector2i from = cellOf(point_m - reach_m).cwiseMax(0);
  const Eigen::Vector2i to = cellOf(point_m + reach_m).cwiseMin(last);
  double nearest_m = limit_m;
  for (Eigen::Vector2i cell = from; cell.y() <= to.y(); ++cell.y())
    for (cell.x() = from.x(); cell.x() <= to.x(); ++cell.x())
      if (isSolid(cell))
        nearest_m = std::min(nearest_m, distanceToBox_m(point_m, middle_m(cell), cell_m_));
  return nearest_m;
}

Eigen::Vector2d GridmapRanges::roomiestPlace_m() const
{
  cv::Mat free(rows_, columns_, CV_8U), distance;
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column)
      free.at<unsigned char>(row, column) = at({column, row}) == Cell::Free;
  cv::distanceTransform(free, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  double farthest = 0;
  cv::Point place;
  cv::minMaxLoc(distance, nullptr, &farthest, nullptr, &place);
  if (farthest <= 0) throw GridmapError("the map has no free cell");
  return middle_m({place.x, place.y});
}

std::vector<Eigen::Vector2d> GridmapRanges::outline_m() const
{
  const auto isOpen = [this](const Eigen::Vector2i& cell)
  { return isInside(cell) && !isSolid(cell); };
  std::vector<Eigen::Vector2d> middles_m;
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column)
    {
      const Eigen::Vector2i cell(column, row), right(1, 0), up(0, 1);
      const bool seen =
          isOpen(cell + right) || isOpen(cell - right) || isOpen(cell + up) || isOpen(cell - up);
      if (isSolid(cell) && seen) middles_m.push_back(middle_m(cell));
    }
  return middles_m;
}

bool GridmapRanges::isInside(const Eigen::Vector2i& cell) const
{
  return cell.x() >= 0 && cell.y() >= 0 && cell.x() < columns_ && cell.y() < rows_;
}

GridmapRanges::Cell GridmapRanges::at(const Eigen::Vector2i& cell) const
{
  return cells_[static_cast<std::size_t>(cell.y()) * static_cast<std::size_t>(columns_) +
                static_cast<std::size_t>(cell.x())];
}

bool GridmapRanges::isSolid(const Eigen::Vector2i& cell) const { return at(cell) == Cell::Solid; }

Eigen::Vector2i GridmapRanges::cellOf(const Eigen::Vector2d& point_m) const
{
  return ((point_m - corner_m_) / cell_m_).array().floor().cast<int>();
}

Eigen::Vector2d GridmapRanges::middle_m(const Eigen::Vector2i& cell) const
{
  return corner_m_ + cell_m_ * (cell.cast<double>() + Eigen::Vector2d::Constant(0.5));
}

GridmapRanges loadGridmap(const std::string& path)
{
  GzipInput file(path);
  if (!file.isOpen()) throw GridmapError("'" + path + "': no such file, or not to be read");
  COccupancyGridMap2D map;
  try
  {
    auto archive = mrpt::serialization::archiveFrom(file);
    archive >> map;
  }
  catch (const std::exception&)  // MRPT's text names source lines and addresses, no use to a reader
  {
    throw GridmapError("'" + path + "' is no MRPT grid map, or is damaged");
  }
  return GridmapRanges(map);
}

GridmapRanges loadImageAsGridmap(const std::string& path, double pixel_m)
{
  COccupancyGridMap2D map;
  if (!map.loadFromBitmapFile(path, static_cast<float>(pixel_m)))
    throw GridmapError("'" + path + "' cannot be read as an image");
  return GridmapRanges(map);
}
}  // namespace psmks
