/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

namespace psmks
{
/** What the points of a map say of the surface near a place: their normal distribution. */
struct Surface
{
  Eigen::Vector2d mean_m;
  Eigen::Vector2d normal;    //!< unit vector along which the points spread least; its sign is open
  double acrossVariance_m2;  //!< along the normal: noise, thickness of a wall, errors of the map
  double alongVariance_m2;   //!< across the normal, at least as large
  int points;                //!< that were counted
  double window_m;           //!< side of the square in which they lie

  /** Whether the points end on all sides within the window, as those of a post: a window twice as
   *  wide holds hardly more. Where a wall ends, or the view of it, they go on at one side. */
  bool isIsolated;
};

/** The surfaces of a map that may have been made of many scans: walls that are doubled by small
 * errors, or seen from both sides, are thick ones. Normal distributions are fitted in overlapping
 * windows of five sizes, as in the normal distributions transform (Biber and Strasser, 2003):
 *
 *      +---+---+---+
 *      |   |   | . |      a window is a cell with its eight neighbours;
 *      +---+---+---+      a place belongs to the window whose middle cell holds it
 *      |   | x |.  |
 *      +---+---+---+
 *      |   | . |   |
 *      +---+---+---+
 *
 * Where points are sparse, the fine windows hold none and the coarse ones tell. A field serves one
 * thread: it computes surfaces when they are asked for, and keeps them. */
class SurfaceField
{
 public:
  static constexpr int kLevels = 5;  //!< window sizes, each twice the one before

  /** The sides of the finest windows are `3 * kFinestCell_m`: wider than a wall is thick that
   *  appears twice, narrower than what stands in rooms. Evidence: measured. */
  static constexpr double kFinestCell_m = 0.07;

  /** Removes all points, and keeps the memory. */
  void clear();

  /** Adds a point. Surfaces that were computed before do not count it.
   *  @param point_m finite; near the origin of its frame, for squares of coordinates are summed */
  void add(const Eigen::Vector2d& point_m);

  /** The surface of the window about a place.
   *  @param level 0 to kLevels - 1, 0 for the finest window
   *  @return null where the window holds fewer than three points; valid until the next call of
   *  add() or clear() */
  const Surface* at(const Eigen::Vector2d& place_m, int level);

  /** The surface of the finest window about a place that has one, from one level to another. */
  const Surface* finestAt(const Eigen::Vector2d& place_m, int finest, int coarsest);

  static double cell_m(int level) { return kFinestCell_m * (1 << level); }

 private:
  struct Sums
  {
    int n = 0;
    double x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  };

  struct Index
  {
    int x, y;
  };

  struct Cell
  {
    std::int64_t key = kFree;
    Sums sums;
    std::int32_t surface = kUnknown;  //!< index into surfaces_, kNone or kUnknown
  };

  /** Cells by their index: a hash table with open addressing. */
  class Cells
  {
   public:
    void clear();
    Cell& at(Index index);
    const Cell* find(Index index) const;

   private:
    static std::int64_t keyOf(Index index);
    std::size_t slotOf(std::int64_t key) const;
    void grow();

    std::vector<Cell> slots_;
    std::vector<std::size_t> used_;  //!< slots that hold a cell
  };

  static constexpr std::int64_t kFree = INT64_MIN;
  static constexpr std::int32_t kUnknown = -2, kNone = -1;

  static Index indexOf(const Eigen::Vector2d& place_m, int level);
  Sums windowAbout(Index index, int level) const;
  std::int32_t fit(const Sums& window, int level);
  bool isIsolated(const Surface& surface, int level) const;

  std::array<Cells, kLevels> levels_;
  std::deque<Surface> surfaces_;  //!< whose elements stay where they are
};
}  // namespace psmks
