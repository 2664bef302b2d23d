/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/joint/EvidenceGrid.h>
#include <psmks/joint/Hypothesis.h>

#include <cstdint>
#include <vector>

namespace psmks
{
/** The poses that a search covers: every translation within a square and every heading within an
 * angle about a guess. */
struct SearchWindow
{
  double radius_m;   //!< greatest displacement from the guess along either axis of the reference,
                     //!< rounded up to whole cells
  double angle_rad;  //!< greatest rotation to either side, rounded up to whole steps
};

/** Finds the poses of a window that explain the rays of the current scan best, by correlation with
 * the evidence of the reference (Olson 2009), branch and bound (Hess et al. 2016).
 *
 * The window is a grid of poses: translations by whole cells of the EvidenceGrid, headings by steps
 * that move half of the rays by at most two cells, but no less than 1 and no more than 3 degrees.
 * The score of a pose is the sum of the evidence in the cells in which its rays end. A node is a
 * heading and a square block of translations, with the sum of the bounds of each ray's square as
 * its own bound; nodes are taken in the order of their bounds and split, so that poses are met in
 * the order of their scores. The result is that of scoring every pose of the grid: the pose with
 * the highest score, then the highest that is another optimum (isSameStart()), and so on. */
class CorrelativeSearch
{
 public:
  /** Most rays of the current scan that are scored. Unit: rays. Evidence: of every fourth
   * scan of the MIT CSAIL log (`csail`) 86.6 % have the right pose among the optima with 60, 87.8 %
   * with 120, in 1.6 times the time. */
  static constexpr int kMostRays = 60;

  /** Replaces the hypotheses by the optima of the window that have more than half of the highest
   *  score, highest first. The score of a hypothesis is its evidence as a share of what it is where
   *  all rays lie on surfaces.
   *  @param rangeTolerance_m within which a point is on a surface
   *  @param most optima that are returned at most */
  void propose(const ScanFeatures& reference, const ScanFeatures& current,
               const Pose2& guess_T_ref_cur, const SearchWindow& window, double rangeTolerance_m,
               std::size_t most, std::vector<Hypothesis>& hypotheses);

  /** Reserves the memory that searches usually need. */
  void reserve();

 private:
  /** A heading, and the block of translations from (x, y) on of 2^level cells in either axis. */
  struct Node
  {
    int score;  //!< upper bound of the poses of the block; the score of the pose at level 0
    std::int16_t heading, x, y, level;
  };
  static bool hasLowerBound(const Node& a, const Node& b) { return a.score < b.score; }
  struct Ray
  {
    float x_m, y_m;
  };

  void pickRays(const RayPoints& points);
  void prepareHeadings(const Pose2& guess_T_ref_cur, const SearchWindow& window);
  void prepareHeading(std::size_t heading);
  void pushRoots();
  void split(const Node& node);
  void push(int heading, int x, int y, int level);
  bool isHopeless(int score) const;
  Pose2 poseOf(const Node& node) const;
  bool leadsOnlyTo(const Node& node, const std::vector<Hypothesis>& known) const;

  EvidenceGrid grid_;
  std::vector<Ray> rays_;
  std::vector<float> distances_m_;  //!< of the rays
  std::vector<int> cells_;          //!< of each heading, the cells of the rays that the grid knows
  std::vector<int> counts_;         //!< of each heading, how many cells these are
  std::vector<Node> nodes_;         //!< a heap
  Pose2 guess_T_ref_cur_;
  double turn_rad_ = 0;           //!< step of the headings
  int headings_ = 0, moves_ = 0;  //!< steps to either side
  int bestScore_ = 0;             //!< of the poses of the grid so far
};

/** Whether two starts lead to the same optimum: they are less than 0.3 m and 5 degrees apart. */
bool isSameStart(const Pose2& a, const Pose2& b);
}  // namespace psmks
