/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

namespace psmks
{
/** The times of the parts of a run. */
struct RunTimes
{
  double reading_s = 0;
  double segmentation_s = 0;
  double matching_s = 0;  //!< without segmentation
  double map_s = 0;       //!< choice of references and their map
  double output_s = 0;

  /** The time from scans to poses. */
  double building_s() const { return segmentation_s + matching_s + map_s; }
  double total_s() const { return reading_s + building_s() + output_s; }
};
}  // namespace psmks
