/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/eval/ErrorStatistics.h>
#include <psmks/eval/Statistics.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
ErrorStatistics errorStatistics(const std::vector<double>& errors)
{
  if (errors.empty()) return {};
  constexpr double kP95 = 0.95;
  const double meanError = mean(errors);
  double squares = 0, deviations = 0;
  for (const double error : errors)
  {
    squares += error * error;
    deviations += (error - meanError) * (error - meanError);
  }
  const double n = static_cast<double>(errors.size());
  return {
      meanError,      std::sqrt(deviations / n), std::sqrt(squares / n),
      median(errors), quantile(errors, kP95),    *std::max_element(errors.begin(), errors.end())};
}

PairErrorStatistics errorStatistics(const std::vector<PairError>& errors, const PairError& limit)
{
  std::vector<double> translations_m, rotations_rad, squares_m2, successes;
  for (const PairError& error : errors)
  {
    translations_m.push_back(error.translation_m);
    if (!std::isnan(error.rotation_rad)) rotations_rad.push_back(error.rotation_rad);
    squares_m2.push_back(error.translation_m * error.translation_m);
    successes.push_back(isSuccess(error, limit) ? 1 : 0);
  }
  return {errors.size(), errorStatistics(translations_m), errorStatistics(rotations_rad),
          errorStatistics(squares_m2), mean(successes)};
}
}  // namespace psmks
