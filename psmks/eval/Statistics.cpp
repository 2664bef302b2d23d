/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/eval/Statistics.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace psmks
{
double quantile(std::vector<double> values, double p)
{
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();

  const double position = p * static_cast<double>(values.size() - 1);
  const auto lower = static_cast<std::size_t>(position);
  const auto lowerPlace = values.begin() + static_cast<std::ptrdiff_t>(lower);
  std::nth_element(values.begin(), lowerPlace, values.end());
  if (lower + 1 == values.size()) return *lowerPlace;

  const double next = *std::min_element(lowerPlace + 1, values.end());
  return *lowerPlace + (position - static_cast<double>(lower)) * (next - *lowerPlace);
}

double median(std::vector<double> values) { return quantile(std::move(values), 0.5); }

double mean(const std::vector<double>& values)
{
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double shareBelow(const std::vector<double>& values, double limit)
{
  std::vector<double> below;
  for (const double value : values) below.push_back(value <= limit ? 1 : 0);
  return mean(below);
}
}  // namespace psmks
