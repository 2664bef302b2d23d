/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <optional>
#include <string>

namespace psmks
{
/** The results of the paper for a kind of world (Tables 1 and 2): means over five drives of ten
 * minutes on maps of the authors, which are not public. */
struct PaperFigures
{
  char map;  //!< its letter in the paper
  double matches, distance_m, turns, segmentation_ms, match_ms;
  double drift_m, drift_deg;                  //!< mean errors of scan matching
  double odometryDrift_m, odometryDrift_deg;  //!< mean errors of odometry

  double timesBetter() const { return odometryDrift_m / drift_m; }
  double timesBetterHeading() const { return odometryDrift_deg / drift_deg; }
};

/** The results of the paper for a site; nothing if the paper has none. */
std::optional<PaperFigures> paperFigures(const std::string& site);
}  // namespace psmks
