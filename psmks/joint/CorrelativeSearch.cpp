/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/geometry/Angle.h>
#include <psmks/joint/CorrelativeSearch.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
/** Distance and angle within which two starts lead to the same optimum. Evidence: measured. */
constexpr double kSame_m = 0.3, kSame_rad = degToRad(5);

/** Smallest and largest step of the heading. Evidence: measured. */
constexpr double kLeastTurn_rad = degToRad(1), kMostTurn_rad = degToRad(3);
}  // namespace

bool isSameStart(const Pose2& a, const Pose2& b)
{
  return (a.translation() - b.translation()).norm() < kSame_m &&
         std::abs(wrapAngle(a.phi_rad - b.phi_rad)) < kSame_rad;
}

void CorrelativeSearch::reserve()
{
  /** Nodes whose memory is reserved. Unit: nodes. Definition: a search of 5 m and 120 degrees has
   * some 10,000; more are allocated when needed. */
  constexpr std::size_t kNodes = 1 << 16;
  const auto headings = static_cast<std::size_t>(2 * kPi / kLeastTurn_rad) + 1;
  grid_.reserve();
  const auto rays = static_cast<std::size_t>(kMostRays) + 1;
  rays_.reserve(rays);
  distances_m_.reserve(rays);
  cells_.reserve(rays * headings);
  counts_.reserve(headings);
  nodes_.reserve(kNodes);
}

void CorrelativeSearch::propose(const ScanFeatures& reference, const ScanFeatures& current,
                                const Pose2& guess_T_ref_cur, const SearchWindow& window,
                                double rangeTolerance_m, std::size_t most,
                                std::vector<Hypothesis>& hypotheses)
{
  hypotheses.clear();
  pickRays(current.points);
  if (rays_.empty()) return;
  grid_.build(reference, window.radius_m, rangeTolerance_m);
  prepareHeadings(guess_T_ref_cur, window);
  pushRoots();
  while (!nodes_.empty() && hypotheses.size() < most)
  {
    std::pop_heap(nodes_.begin(), nodes_.end(), hasLowerBound);
    const Node node = nodes_.back();
    nodes_.pop_back();
    if (isHopeless(node.score)) return;
    if (leadsOnlyTo(node, hypotheses)) continue;
    if (node.level > 0)
      split(node);
    else
      hypotheses.push_back({poseOf(node), node.score / (static_cast<double>(rays_.size()) *
                                                        EvidenceGrid::kOnSurface)});
  }
}

/** Picks rays so that each stands for as much of the surfaces as the others. Those on movable
 * objects are left out, but where they are most of what there is. */
void CorrelativeSearch::pickRays(const RayPoints& points)
{
  /** Largest share of the looks on movable objects that is left out. Unit: share. Definition: most.
   */
  constexpr float kMost = 0.5f;
  rays_.clear();
  float seen = 0, movable = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    seen += points.looks[i];
    movable += points.movable[i] ? points.looks[i] : 0;
  }
  const bool keepsMovable = movable > kMost * seen;
  const float perRay = seen / static_cast<float>(kMostRays);
  float since = 0.5f * perRay;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    since += points.looks[i];
    if (since < perRay) continue;
    since = std::min(since - perRay, perRay);
    if (keepsMovable || !points.movable[i]) rays_.push_back({points.x_m[i], points.y_m[i]});
  }
}

void CorrelativeSearch::prepareHeadings(const Pose2& guess_T_ref_cur, const SearchWindow& window)
{
  distances_m_.clear();
  for (const Ray& ray : rays_) distances_m_.push_back(std::hypot(ray.x_m, ray.y_m));
  const auto median = distances_m_.begin() + static_cast<std::ptrdiff_t>(distances_m_.size() / 2);
  std::nth_element(distances_m_.begin(), median, distances_m_.end());
  turn_rad_ =
      std::clamp(2 * grid_.cell_m() / static_cast<double>(*median), kLeastTurn_rad, kMostTurn_rad);
  guess_T_ref_cur_ = guess_T_ref_cur;
  headings_ = static_cast<int>(std::ceil(window.angle_rad / turn_rad_));
  moves_ = static_cast<int>(std::ceil(window.radius_m / grid_.cell_m()));

  const std::size_t headings = 2 * static_cast<std::size_t>(headings_) + 1;
  cells_.resize(headings * rays_.size());
  counts_.resize(headings);
  for (std::size_t heading = 0; heading < headings; ++heading) prepareHeading(heading);
}

/** Finds the cells in which the rays end at a heading, with the position of the guess. */
void CorrelativeSearch::prepareHeading(std::size_t heading)
{
  const double phi_rad =
      guess_T_ref_cur_.phi_rad + (static_cast<int>(heading) - headings_) * turn_rad_;
  const auto c = static_cast<float>(std::cos(phi_rad)), s = static_cast<float>(std::sin(phi_rad));
  const auto x_m = static_cast<float>(guess_T_ref_cur_.x_m),
             y_m = static_cast<float>(guess_T_ref_cur_.y_m);
  int* cells = cells_.data() + heading * rays_.size();
  int count = 0;
  for (const Ray& ray : rays_)
  {
    const int cell =
        grid_.indexOf(c * ray.x_m - s * ray.y_m + x_m, s * ray.x_m + c * ray.y_m + y_m);
    if (cell >= 0) cells[count++] = cell;
  }
  counts_[heading] = count;
}

void CorrelativeSearch::pushRoots()
{
  int level = 0;
  while (level + 1 < EvidenceGrid::kLevels && (2 << level) <= 2 * moves_) ++level;
  const int size = 1 << level;
  nodes_.clear();
  bestScore_ = 0;
  for (int heading = 0; heading <= 2 * headings_; ++heading)
    for (int x = -moves_; x <= moves_; x += size)
      for (int y = -moves_; y <= moves_; y += size) push(heading, x, y, level);
}

/** Replaces a node by the quarters of its block that lie in the window. */
void CorrelativeSearch::split(const Node& node)
{
  const int level = node.level - 1, size = 1 << level;
  for (const int x : {node.x + 0, node.x + size})
    for (const int y : {node.y + 0, node.y + size})
      if (x <= moves_ && y <= moves_) push(node.heading, x, y, level);
}

void CorrelativeSearch::push(int heading, int x, int y, int level)
{
  const std::int8_t* evidence = grid_.level(level) + grid_.offset(x, y);
  const int* cells = cells_.data() + static_cast<std::size_t>(heading) * rays_.size();
  const int count = counts_[static_cast<std::size_t>(heading)];
  int score = 0;
  for (int i = 0; i < count; ++i) score += evidence[cells[i]];
  if (level == 0) bestScore_ = std::max(bestScore_, score);
  if (isHopeless(score)) return;
  const auto narrow = [](int value) { return static_cast<std::int16_t>(value); };
  nodes_.push_back({score, narrow(heading), narrow(x), narrow(y), narrow(level)});
  std::push_heap(nodes_.begin(), nodes_.end(), hasLowerBound);
}

/** Whether a pose with this score is no optimum to return. */
bool CorrelativeSearch::isHopeless(int score) const
{
  /** Largest score of such a pose. Unit: share of the best score so far. Evidence: of every fourth
   * scan of the MIT CSAIL log (`csail`) 86.6 % have the right pose among the optima with 0.75,
   * 90.1 % with 0.625. */
  constexpr double kShare = 0.5;
  return score <= kShare * bestScore_;
}

Pose2 CorrelativeSearch::poseOf(const Node& node) const
{
  return {guess_T_ref_cur_.x_m + node.x * grid_.cell_m(),
          guess_T_ref_cur_.y_m + node.y * grid_.cell_m(),
          wrapAngle(guess_T_ref_cur_.phi_rad + (node.heading - headings_) * turn_rad_)};
}

/** Whether every pose of a node is the same start as a known one. */
bool CorrelativeSearch::leadsOnlyTo(const Node& node, const std::vector<Hypothesis>& known) const
{
  const int last = (1 << node.level) - 1;
  const auto isSame = [&](const Hypothesis& hypothesis)
  {
    for (const int x : {0, last})
      for (const int y : {0, last})
      {
        Node corner = node;
        corner.x = static_cast<std::int16_t>(node.x + x);
        corner.y = static_cast<std::int16_t>(node.y + y);
        if (!isSameStart(poseOf(corner), hypothesis.T_ref_cur)) return false;
      }
    return true;
  };
  return std::any_of(known.begin(), known.end(), isSame);
}
}  // namespace psmks
