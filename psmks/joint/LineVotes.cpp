/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/joint/LineVotes.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
/** Bin of the votes for a rotation. Evidence: measured. */
constexpr double kAngleBin_rad = degToRad(1);

/** Angle within which two lines are a pair at a voted rotation. Evidence: measured. */
constexpr double kParallel_rad = degToRad(3);

/** Sine of the smallest angle between two lines that vote for a position together. Unit: sine.
 * Evidence: measured. */
constexpr double kCrossing = 0.3;

/** Cell of the votes for a position. Evidence: measured. */
constexpr double kGridCell_m = 0.10;

/** Most positions that are kept for each rotation. Unit: positions. Evidence: measured. */
constexpr int kPeaksPerAngle = 4;

/** Evidence of a pair of segments: the length they can have in common, at most that of a wall of a
 *  room, so that one long corridor wall does not decide alone. */
double evidence_m(const Segment& a, const Segment& b)
{
  /** Length from which on a pair of lines has no more votes. Evidence: measured. */
  constexpr double kLongest_m = 4;
  return std::min({a.length_m(), b.length_m(), kLongest_m});
}
}  // namespace

void LineVotes::voteAngles(const ScanFeatures& reference, const ScanFeatures& current,
                           double guess_rad, const VoteLimits& limits)
{
  const int half = static_cast<int>(std::ceil(limits.angle_rad / kAngleBin_rad));
  const int bins = 2 * half + 1;
  histogram_.assign(static_cast<std::size_t>(bins), 0);
  for (const Segment& cur : current.scan->segments)
    for (const Segment& ref : reference.scan->segments)
    {
      const double turn_rad = wrapAngle(ref.line.phi0_rad - cur.line.phi0_rad - guess_rad);
      const double position = turn_rad / kAngleBin_rad + half;
      const int lower = static_cast<int>(std::floor(position));
      if (lower < 0 || lower + 1 >= bins) continue;
      const double upperShare = position - lower, votes = evidence_m(cur, ref);
      histogram_[static_cast<std::size_t>(lower)] += (1 - upperShare) * votes;
      histogram_[static_cast<std::size_t>(lower) + 1] += upperShare * votes;
    }

  angles_.clear();
  for (int b = 0; b < bins; ++b)
  {
    const auto at = [&](int i)
    { return i < 0 || i >= bins ? 0.0 : histogram_[static_cast<std::size_t>(i)]; };
    const double left = at(b - 1), middle = at(b), right = at(b + 1);
    const double votes = left + middle + right;
    const double votesLeft = at(b - 2) + left + middle, votesRight = middle + right + at(b + 2);
    if (!(votes > 0) || votes < votesLeft || votes <= votesRight) continue;
    const double mean = (right - left) / votes;
    angles_.push_back({wrapAngle(guess_rad + (b - half + mean) * kAngleBin_rad), votes});
  }
  std::sort(angles_.begin(), angles_.end(),
            [](const VotedAngle& a, const VotedAngle& b) { return a.votes > b.votes; });
  if (angles_.size() > static_cast<std::size_t>(limits.votedAngles))
    angles_.resize(static_cast<std::size_t>(limits.votedAngles));
}

/** One vote, spread over the grid cell's centre of gravity. */
void LineVotes::cast(double x_m, double y_m, double votes, double radius_m)
{
  if (std::abs(x_m) > radius_m || std::abs(y_m) > radius_m) return;
  const int column = static_cast<int>((x_m + radius_m) / kGridCell_m);
  const int row = static_cast<int>((y_m + radius_m) / kGridCell_m);
  Cell& cell = grid_[static_cast<std::size_t>((row + 1) * gridSide_ + column + 1)];
  cell.votes += votes;
  cell.sumX_m += votes * x_m;
  cell.sumY_m += votes * y_m;
}

void LineVotes::voteTranslations(const ScanFeatures& reference, const ScanFeatures& current,
                                 const Pose2& guess, const VotedAngle& angle,
                                 const VoteLimits& limits)
{
  // One empty cell all round: a peak then always has eight neighbours.
  gridSide_ = static_cast<int>(std::ceil(2 * limits.radius_m / kGridCell_m)) + 3;
  grid_.assign(static_cast<std::size_t>(gridSide_ * gridSide_), Cell{0, 0, 0});

  constraints_.clear();
  for (const Segment& cur : current.scan->segments)
    for (std::size_t r = 0; r < reference.scan->segments.size(); ++r)
    {
      const Segment& ref = reference.scan->segments[r];
      const double between_rad = wrapAngle(cur.line.phi0_rad + angle.phi_rad - ref.line.phi0_rad);
      if (std::abs(between_rad) > kParallel_rad) continue;
      const Eigen::Vector2d& n = reference.lines[r].normal;
      const double offset_m = ref.line.r0_m - cur.line.r0_m - n.x() * guess.x_m - n.y() * guess.y_m;
      if (std::abs(offset_m) > limits.radius_m) continue;
      constraints_.push_back({n.x(), n.y(), offset_m, evidence_m(cur, ref)});
    }

  for (std::size_t i = 0; i < constraints_.size(); ++i)
  {
    const Constraint& a = constraints_[i];
    /** Weight of the vote of a single line, which leaves the guess along itself and must not
     * outvote an intersection. Unit: votes of a pair. Evidence: measured. */
    constexpr double kAlone = 0.2;
    cast(a.nx * a.offset_m, a.ny * a.offset_m, kAlone * a.weight_m, limits.radius_m);
    for (std::size_t j = i + 1; j < constraints_.size(); ++j)
    {
      const Constraint& b = constraints_[j];
      const double sine = a.nx * b.ny - a.ny * b.nx;
      if (std::abs(sine) < kCrossing) continue;
      cast((a.offset_m * b.ny - b.offset_m * a.ny) / sine,
           (b.offset_m * a.nx - a.offset_m * b.nx) / sine, std::min(a.weight_m, b.weight_m),
           limits.radius_m);
    }
  }
}

void LineVotes::collectPeaks(const Pose2& guess, const VotedAngle& angle,
                             std::vector<Hypothesis>& hypotheses) const
{
  const auto begin = hypotheses.size();
  for (int row = 1; row + 1 < gridSide_; ++row)
    for (int column = 1; column + 1 < gridSide_; ++column)
    {
      const int centre = row * gridSide_ + column;
      const double own = grid_[static_cast<std::size_t>(centre)].votes;
      if (!(own > 0)) continue;
      bool peak = true;
      Cell sum{0, 0, 0};
      for (const int dr : {-1, 0, 1})
        for (const int dc : {-1, 0, 1})
        {
          const int other = centre + dr * gridSide_ + dc;
          const Cell& cell = grid_[static_cast<std::size_t>(other)];
          peak = peak && (other < centre ? cell.votes < own : cell.votes <= own);
          sum.votes += cell.votes, sum.sumX_m += cell.sumX_m, sum.sumY_m += cell.sumY_m;
        }
      if (!peak) continue;
      hypotheses.push_back(
          {{guess.x_m + sum.sumX_m / sum.votes, guess.y_m + sum.sumY_m / sum.votes, angle.phi_rad},
           sum.votes});
    }
  const auto first = hypotheses.begin() + static_cast<std::ptrdiff_t>(begin);
  const auto kept = std::min<std::ptrdiff_t>(kPeaksPerAngle, hypotheses.end() - first);
  std::partial_sort(first, first + kept, hypotheses.end(),
                    [](const Hypothesis& a, const Hypothesis& b) { return a.score > b.score; });
  hypotheses.resize(begin + static_cast<std::size_t>(kept));
}

void LineVotes::propose(const ScanFeatures& reference, const ScanFeatures& current,
                        const Pose2& guess_T_ref_cur, const VoteLimits& limits,
                        std::vector<Hypothesis>& hypotheses)
{
  voteAngles(reference, current, guess_T_ref_cur.phi_rad, limits);
  for (const VotedAngle& angle : angles_)
  {
    voteTranslations(reference, current, guess_T_ref_cur, angle, limits);
    collectPeaks(guess_T_ref_cur, angle, hypotheses);
  }
}
}  // namespace psmks
