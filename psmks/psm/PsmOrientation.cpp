/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/psm/PsmOrientation.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace psmks
{
namespace
{
/** The sum and the number of the range differences of paired rays. */
struct Differences
{
  double sum_m = 0;
  int pairs = 0;

  double mean_m() const
  {
    return pairs > 0 ? sum_m / pairs : std::numeric_limits<double>::infinity();
  }
};

/** Adds the differences of the projected rays [first, last) from the reference rays `shift` further
 * on. */
void addDifferences(const PsmScan& reference, const PsmProjection& projection, int first, int last,
                    int shift, Differences& differences)
{
  for (int i = first; i < last; ++i)
  {
    const auto p = static_cast<std::size_t>(i);
    if (projection.tag[p] != PsmTag::Good || !reference.isGood(i + shift)) continue;
    differences.sum_m += std::abs(projection.range_m[p] - reference.range(i + shift));
    ++differences.pairs;
  }
}

double shiftError_m(const PsmScan& reference, const PsmProjection& projection, int shift)
{
  const int rays = reference.rays();
  Differences differences;
  const int first = std::max(0, -shift), last = rays - std::max(0, shift);
  addDifferences(reference, projection, first, last, shift, differences);
  if (reference.grid.closed())
  {
    addDifferences(reference, projection, 0, first, shift + rays, differences);
    addDifferences(reference, projection, last, rays, shift - rays, differences);
  }
  return differences.mean_m();
}

/** The number of shifts to either side that the search window allows, at most half of the scan. */
int shiftsToEachSide(const BeamGrid& grid, double searchWindow_rad)
{
  const double shifts = std::round(searchWindow_rad / grid.increment_rad());
  return static_cast<int>(std::clamp(shifts, 0.0, std::max(0, grid.count() - 1) / 2.0));
}
}  // namespace

double parabolaMinimum(double left, double middle, double right)
{
  /** Second difference of the errors below which the three points lie on a straight line.
   * Definition: it keeps the quotient below finite; errors are centimetres. */
  constexpr double kFlat_m = 1e-4;
  const double curvature = left + right - 2 * middle;
  if (left <= middle || right <= middle || !(curvature > kFlat_m)) return 0;
  const double offset = (left - right) / (2 * curvature);
  return std::abs(offset) < 1 ? offset : 0;  // NaN gives 0
}

std::optional<double> findPsmTurn_rad(const PsmScan& reference, const PsmProjection& projection,
                                      double searchWindow_rad, std::vector<double>& errors_m)
{
  const int side = shiftsToEachSide(reference.grid, searchWindow_rad);
  errors_m.clear();
  for (int shift = -side; shift <= side; ++shift)
    errors_m.push_back(shiftError_m(reference, projection, shift));

  const auto smallest = std::min_element(errors_m.begin(), errors_m.end());
  if (!std::isfinite(*smallest)) return std::nullopt;
  double shift = static_cast<double>(smallest - errors_m.begin()) - side;
  if (smallest != errors_m.begin() && smallest + 1 != errors_m.end())
    shift += parabolaMinimum(*(smallest - 1), *smallest, *(smallest + 1));
  return shift * reference.grid.increment_rad();
}
}  // namespace psmks
