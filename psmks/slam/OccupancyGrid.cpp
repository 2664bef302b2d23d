/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/geometry/GridRay.h>
#include <psmks/segmentation/Preprocessing.h>
#include <psmks/slam/OccupancyGrid.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace psmks
{
namespace
{
/** By how much a ray that ends in a cell counts more than one that passes it. Unit: rays.
 * Definition: a cell is occupied where more than one of four rays ended in it, for rays that graze
 * a wall pass cells in which others end. */
constexpr int kPassesPerEnd = 3;

/** Calls a function with each reference scan, cleaned, and the pose of its sensor. */
template <class Use>
void forReferences(const std::vector<PosedScan>& scans, const PreprocessingOptions& options,
                   Use use)
{
  SegmentedScan cleaned;
  for (const PosedScan& posed : scans)
  {
    if (!posed.isReference) continue;
    cleanScan(posed.scan, options, cleaned);
    use(cleaned, posed.T_world_sensor());
  }
}

Eigen::AlignedBox2d boundsOf(const std::vector<PosedScan>& scans,
                             const PreprocessingOptions& options)
{
  Eigen::AlignedBox2d bounds;
  forReferences(scans, options,
                [&bounds](const SegmentedScan& scan, const Pose2& T_world_sensor)
                {
                  bounds.extend(T_world_sensor.translation());
                  for (int ray = 0; ray < scan.rays(); ++ray)
                    if (scan.isValid(ray)) bounds.extend(T_world_sensor * scan.point_m(ray));
                });
  return bounds;
}

/** Cells that cover a box, with whole multiples of their size for borders and a margin around. */
UniformGrid frameAround(const Eigen::AlignedBox2d& bounds)
{
  /** Size of a cell. Unit: m. Definition: that of most maps of robots. */
  constexpr double kCell_m = 0.05;

  /** Most cells. Unit: cells. Definition: 290 by 290 m in cells of 5 cm. */
  constexpr int kMostCells = 1 << 25;
  if (bounds.isEmpty()) return {Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero(), kCell_m};
  const Eigen::Vector2d low = (bounds.min() / kCell_m).array().floor() - 1;
  const Eigen::Vector2d high = (bounds.max() / kCell_m).array().ceil() + 1;
  return {kCell_m * low, kCell_m * high, kCell_m, kMostCells};
}
}  // namespace

OccupancyGrid::OccupancyGrid(const UniformGrid& frame)
    : frame_(frame), evidence_(static_cast<std::size_t>(frame.cells()), 0)
{
}

void OccupancyGrid::add(const SegmentedScan& scan, const Pose2& T_world_sensor)
{
  const Eigen::Vector2d from_m = T_world_sensor.translation();
  for (int ray = 0; ray < scan.rays(); ++ray)
    if (scan.isValid(ray)) addRay(from_m, T_world_sensor * scan.point_m(ray));
}

void OccupancyGrid::addRay(const Eigen::Vector2d& from_m, const Eigen::Vector2d& end_m)
{
  const Eigen::Vector2d way_m = end_m - from_m;
  const double length_m = way_m.norm();
  const int endCell = frame_.cell(frame_.column(end_m.x()), frame_.row(end_m.y()));
  for (GridRay ray(frame_, from_m, way_m / length_m, length_m); ray.isInside(); ray.advance())
    if (ray.cell() != endCell) change(ray.cell(), -1);
  const Eigen::AlignedBox2d all(frame_.low_m(), frame_.high_m());
  if (all.contains(end_m)) change(endCell, kPassesPerEnd);
}

void OccupancyGrid::change(int cell, int by)
{
  Evidence& evidence = evidence_[static_cast<std::size_t>(cell)];
  /** Most evidence of a cell. Unit: counts. Definition: what its type holds. */
  constexpr int kMost = std::numeric_limits<Evidence>::max();
  evidence = static_cast<Evidence>(std::clamp(evidence + by, -kMost, kMost));
}

OccupancyGrid::Cell OccupancyGrid::at(int column, int row) const
{
  const int evidence = evidence_[static_cast<std::size_t>(frame_.cell(column, row))];
  if (evidence == 0) return Cell::Unknown;
  return evidence > 0 ? Cell::Occupied : Cell::Free;
}

OccupancyGrid makeOccupancyGrid(const std::vector<PosedScan>& scans,
                                const PreprocessingOptions& options)
{
  OccupancyGrid grid(frameAround(boundsOf(scans, options)));
  forReferences(scans, options,
                [&grid](const SegmentedScan& scan, const Pose2& T_world_sensor)
                { grid.add(scan, T_world_sensor); });
  return grid;
}
}  // namespace psmks
