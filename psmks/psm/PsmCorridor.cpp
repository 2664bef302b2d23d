/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/psm/PsmCorridor.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace psmks
{
namespace
{
using Directions = std::vector<double>;

/** The direction of the same undirected line in [0, pi). */
double folded(double direction_rad)
{
  const double rest_rad = std::fmod(direction_rad, kPi);
  return rest_rad < 0 ? rest_rad + kPi : rest_rad;
}

Directions chordDirections(const PsmScan& scan, double chordArc_rad)
{
  const int step =
      std::max(1, static_cast<int>(std::lround(chordArc_rad / scan.grid.increment_rad())));
  Directions directions;
  for (int i = 0; i < scan.rays(); ++i)
  {
    const int next = scan.grid.neighbour(i, step);
    if (next < 0 || !scan.sameSurface(i, next)) continue;
    const Eigen::Vector2d chord = scan.point(next) - scan.point(i);
    directions.push_back(std::atan2(chord.y(), chord.x()));
  }
  return directions;
}

double median(double a, double b, double c)
{
  return std::max(std::min(a, b), std::min(std::max(a, b), c));
}

/** The standard deviation of the directions after turning them by an angle, folding and median
 * filtering. */
double spread_rad(const Directions& directions, double turn_rad)
{
  const auto at = [&](std::size_t i) { return folded(directions[i] + turn_rad); };
  double sum = 0, sumOfSquares = 0;
  for (std::size_t i = 1; i + 1 < directions.size(); ++i)
  {
    const double direction_rad = median(at(i - 1), at(i), at(i + 1));
    sum += direction_rad;
    sumOfSquares += direction_rad * direction_rad;
  }
  const double n = static_cast<double>(directions.size()) - 2;
  return std::sqrt(std::max(0.0, sumOfSquares / n - (sum / n) * (sum / n)));
}

/** The middle of the 2-degree bin that holds the most directions. */
double mode_rad(const Directions& directions)
{
  /** Bins of the histogram. Unit: bins. Definition: the size of an array. Bins of 2 degrees are a
   * choice, and the baseline is not tuned. */
  constexpr int kBins = 90;

  /** Width of a bin. Definition: half a circle in so many bins. */
  constexpr double kBin_rad = kPi / kBins;
  std::array<int, kBins> histogram{};
  for (const double direction_rad : directions)
  {
    const int bin = static_cast<int>(folded(direction_rad) / kBin_rad);
    ++histogram[static_cast<std::size_t>(std::min(bin, kBins - 1))];
  }
  const auto fullest = std::max_element(histogram.begin(), histogram.end());
  return (static_cast<double>(fullest - histogram.begin()) + 0.5) * kBin_rad;
}

/** The mode of the directions, moved to the mean of the directions near it. Walls perpendicular to
 * it are turned by 90 degrees and count as well. */
double mainDirection_rad(const Directions& directions)
{
  /** Directions this near to the mode are averaged. Evidence: none; two and a half bins to either
   * side are a choice, and the baseline is not tuned. */
  constexpr double kNear_rad = degToRad(5);
  const double mode = mode_rad(directions);
  double sum_rad = 0;
  int n = 0;
  for (const double direction_rad : directions)
  {
    const double off_rad = std::remainder(direction_rad - mode, kPi / 2);
    if (std::abs(off_rad) > kNear_rad) continue;
    sum_rad += off_rad;
    ++n;
  }
  return folded(mode + sum_rad / std::max(1, n));
}
}  // namespace

std::optional<double> corridorDirection_rad(const PsmScan& scan, const PsmOptions& options)
{
  /** Turn before the second estimate of the spread. Definition: the spread is too large where the
   * directions lie about the seam of the half circle; turned by 36 degrees they do not, whatever
   * direction they had. */
  constexpr double kSecondTurn_rad = kPi / 5;
  const Directions directions = chordDirections(scan, options.chordArc_rad);
  if (directions.size() < 3) return std::nullopt;
  const double spread =
      std::min(spread_rad(directions, 0), spread_rad(directions, kSecondTurn_rad));
  if (spread >= options.corridorSpread_rad) return std::nullopt;
  return mainDirection_rad(directions);
}
}  // namespace psmks
