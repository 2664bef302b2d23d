/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/PairError.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace psmks
{
/** Statistics of a set of errors; NaN if there are none. */
struct ErrorStatistics
{
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  double mean = kNone;
  double std = kNone;  //!< about the mean, divided by the number of errors
  double rms = kNone, median = kNone, p95 = kNone, max = kNone;
};

ErrorStatistics errorStatistics(const std::vector<double>& errors);

/** Statistics of the errors of poses or motions. Rotations that are not known are left out. */
struct PairErrorStatistics
{
  std::size_t count = 0;
  ErrorStatistics translation_m, rotation_rad;
  ErrorStatistics squaredTranslation_m2;        //!< of the squared errors of the translations
  double withinLimit = ErrorStatistics::kNone;  //!< share of the errors below both limits
};

PairErrorStatistics errorStatistics(const std::vector<PairError>& errors, const PairError& limit);
}  // namespace psmks
