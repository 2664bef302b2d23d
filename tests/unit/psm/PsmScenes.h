/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/psm/PsmScan.h>
#include <tests/support/Scenes.h>

#include <limits>
#include <vector>

namespace psmks::test
{
constexpr double kNothing_m = std::numeric_limits<double>::infinity();

/** The default options without the median filter, for scenes drawn ray by ray. */
inline PsmOptions unfiltered()
{
  PsmOptions options;
  options.medianWindow = 1;
  return options;
}

inline PsmScan prepared(const Scan& scan, const PsmOptions& options = unfiltered())
{
  PsmScan result;
  preparePsmScan(scan, options, result);
  return result;
}

/** A scan drawn by its ranges. */
inline Scan drawnScan(const std::vector<double>& range_m, double fieldOfView_rad = kPi)
{
  Scan scan;
  scan.grid = BeamGrid::centered(fieldOfView_rad, static_cast<int>(range_m.size()));
  scan.range_m = range_m;
  scan.maxRange_m = 30;
  return scan;
}

inline PsmScan preparedScene(const std::vector<Wall>& walls, const Pose2& T_world_sensor,
                             const BeamGrid& grid)
{
  return prepared(castScan(walls, T_world_sensor, grid));
}
}  // namespace psmks::test
