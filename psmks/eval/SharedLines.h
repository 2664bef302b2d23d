/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/AnchoredLine.h>
#include <psmks/segmentation/Segment.h>

#include <vector>

namespace psmks
{
/** The straight walls of two scans that lie on each other: pieces that either scan shows, and which
 * of them are the same wall.
 *
 *      reference   ----------------
 *      current              -------------     one wall: they overlap on one line
 *                                    |
 *                                    |        another one */
class SharedLines
{
 public:
  struct Piece
  {
    AnchoredLine line;  //!< in the axes of the reference
    Eigen::Vector2d firstEnd_m, lastEnd_m;
    double begin_m, end_m;  //!< along the line
    std::size_t wall = 0;   //!< index of the best known piece of the same wall
  };

  /** @param T_ref_scan true pose of the scan that the straight belongs to */
  void add(const Segment& straight, const Pose2& T_ref_scan);

  /** Finds out which pieces are the same wall; to be called once, after all pieces were added. */
  void group();

  const std::vector<Piece>& pieces() const { return pieces_; }

  /** The piece on which a ray ends, to a few standard deviations of its range, or null.
   *  @param direction of the ray, unit vector
   *  @param end_m where it was measured to end */
  const Piece* pieceAt(const Eigen::Vector2d& direction, const Eigen::Vector2d& end_m,
                       double rangeSigma_m) const;

 private:
  void join(std::size_t wall, std::size_t otherWall);

  std::vector<Piece> pieces_;
};
}  // namespace psmks
