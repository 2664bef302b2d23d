/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

namespace psmks
{
/** Where the time of a run goes. */
struct RunTimes
{
  double reading_s = 0;
  double segmentation_s = 0;
  double matching_s = 0;  //!< segmentation left out
  double map_s = 0;       //!< choosing references and keeping the map of them
  double output_s = 0;

  /** From a scan to its pose. */
  double building_s() const { return segmentation_s + matching_s + map_s; }
  double total_s() const { return reading_s + building_s() + output_s; }
};
}  // namespace psmks
