/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

/** \file
 * What MRPT 2 and MRPT 3 name differently. */

namespace psmks::compat
{
/** Step of a grid map's ray caster in cells: a member of the map in MRPT 3 ... */
template <class GridMap>
auto raytraceStep_cells(const GridMap& map)
    -> decltype(double(map.insertionOptions.raytraceStepSizeInCellUnits))
{
  return map.insertionOptions.raytraceStepSizeInCellUnits;
}

/** ... and a static one in MRPT 2. */
template <class GridMap>
auto raytraceStep_cells(const GridMap&)
    -> decltype(double(GridMap::RAYTRACE_STEP_SIZE_IN_CELL_UNITS))
{
  return GridMap::RAYTRACE_STEP_SIZE_IN_CELL_UNITS;
}
}  // namespace psmks::compat
