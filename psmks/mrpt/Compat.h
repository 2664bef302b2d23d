/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

/** \file
 * One name for what MRPT 2 and MRPT 3 name differently. */

namespace psmks::compat
{
/** Step of a grid map's ray caster, in cells. This overload is chosen in MRPT 3, where the step is
 *  an option of each map. */
template <class GridMap>
auto raytraceStep_cells(const GridMap& map)
    -> decltype(double(map.insertionOptions.raytraceStepSizeInCellUnits))
{
  return map.insertionOptions.raytraceStepSizeInCellUnits;
}

/** Step of a grid map's ray caster, in cells. This overload is chosen in MRPT 2, where the step is
 *  a static member of the class. */
template <class GridMap>
auto raytraceStep_cells(const GridMap&)
    -> decltype(double(GridMap::RAYTRACE_STEP_SIZE_IN_CELL_UNITS))
{
  return GridMap::RAYTRACE_STEP_SIZE_IN_CELL_UNITS;
}
}  // namespace psmks::compat
