/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/eval/RoundNumber.h>

#include <cmath>
#include <initializer_list>

namespace psmks
{
double roundNumber(double x)
{
  const double decade = std::pow(10.0, std::floor(std::log10(x)));
  for (const double step : {5.0, 2.0})
    if (step * decade <= x) return step * decade;
  return decade;
}
}  // namespace psmks
