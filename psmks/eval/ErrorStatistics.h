/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/PairError.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace psmks
{
/** What errors come to; NaN where there are none. */
struct ErrorStatistics
{
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  double mean = kNone;
  double std = kNone;  //!< about the mean, of these very errors (divided by their number)
  double rms = kNone, median = kNone, p95 = kNone, max = kNone;
};

ErrorStatistics errorStatistics(const std::vector<double>& errors);

/** The errors of poses or motions. */
struct PairErrorStatistics
{
  std::size_t count = 0;
  ErrorStatistics translation_m, rotation_rad;
  ErrorStatistics squaredTranslation_m2;        //!< of the squares of the translations' errors
  double withinLimit = ErrorStatistics::kNone;  //!< share of the errors below both limits
};

PairErrorStatistics errorStatistics(const std::vector<PairError>& errors, const PairError& limit);
}  // namespace psmks
