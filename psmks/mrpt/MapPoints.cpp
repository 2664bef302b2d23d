/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/maps/CPointsMap.h>
#include <psmks/mrpt/MapPoints.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace psmks
{
using mrpt::maps::CMetricMap;
using mrpt::maps::CMultiMetricMap;
using mrpt::maps::COccupancyGridMap2D;
using mrpt::maps::CPointsMap;

namespace
{
bool isWithin(const MapRegion& region, const Eigen::Vector2d& p)
{
  return (p - region.middle_m).cwiseAbs().maxCoeff() <= region.reach_m;
}

MapPoints pointsOfPointMap(const CPointsMap& map, const MapRegion& region)
{
  MapPoints result;
  const auto& x = map.getPointsBufferRef_x();
  const auto& y = map.getPointsBufferRef_y();
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    const Eigen::Vector2d p(x[i], y[i]);
    if (p.allFinite() && isWithin(region, p)) result.points_m.push_back(p);
  }
  return result;
}

/** The cells of one axis that lie in a region: from the first to the one before the last. */
struct CellRange
{
  int first, last;
};

CellRange cellsWithin(double middle_m, double reach_m, double min_m, double cell_m,
                      std::size_t size)
{
  const auto clamped = [&](double place_m)
  {
    const double cell = std::floor((place_m - min_m) / cell_m);
    return static_cast<int>(std::clamp(cell, 0.0, static_cast<double>(size)));
  };
  return {clamped(middle_m - reach_m), clamped(middle_m + reach_m + cell_m)};
}

MapPoints pointsOfGrid(const COccupancyGridMap2D& map, const MapRegion& region)
{
  MapPoints result;
  result.cell_m = map.getResolution();
  const CellRange columns = cellsWithin(region.middle_m.x(), region.reach_m, map.getXMin(),
                                        result.cell_m, map.getSizeX());
  const CellRange rows = cellsWithin(region.middle_m.y(), region.reach_m, map.getYMin(),
                                     result.cell_m, map.getSizeY());
  for (int row = rows.first; row < rows.last; ++row)
  {
    const auto* cells = map.getRow(row);  // log-odds of being free
    for (int column = columns.first; cells && column < columns.last; ++column)
      if (cells[column] < 0) result.points_m.emplace_back(map.idx2x(column), map.idx2y(row));
  }
  return result;
}

/** The part of a multi-metric map that is matched; null where there is none. */
const CMetricMap* matchablePart(const CMultiMetricMap& map)
{
  const CMetricMap* matchable = nullptr;
  for (const auto& part : map.maps)
  {
    const bool isPoints = dynamic_cast<const CPointsMap*>(part.get()) != nullptr;
    if (isPoints && !part->isEmpty()) return part.get();
    if (isPoints || dynamic_cast<const COccupancyGridMap2D*>(part.get()))
      matchable = isPoints && matchable ? matchable : part.get();
  }
  return matchable;
}

[[noreturn]] void refuseMap(const CMetricMap& map)
{
  throw std::invalid_argument(
      std::string("psmks::ScanMatcher: a map of class ") + map.GetRuntimeClass()->className +
      " cannot be matched, allowed: point maps, COccupancyGridMap2D, and CMultiMetricMap with one "
      "of these");
}
}  // namespace

double MapPoints::cellSigma_m() const { return cell_m / std::sqrt(12.0); }

MapPoints pointsOf(const CMetricMap& map, const MapRegion& region)
{
  const auto* multi = dynamic_cast<const CMultiMetricMap*>(&map);
  const CMetricMap* matchable = multi ? matchablePart(*multi) : &map;
  const auto* points = dynamic_cast<const CPointsMap*>(matchable);
  const auto* cells = dynamic_cast<const COccupancyGridMap2D*>(matchable);
  if (!points && !cells) refuseMap(map);
  if (!region.middle_m.allFinite()) return {};
  return points ? pointsOfPointMap(*points, region) : pointsOfGrid(*cells, region);
}
}  // namespace psmks
