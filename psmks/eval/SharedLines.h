/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/AnchoredLine.h>
#include <psmks/segmentation/Segment.h>

#include <vector>

namespace psmks
{
/** The straight walls of two scans that are laid over each other at the true pose: the pieces that
 * each scan shows, sorted into walls.
 *
 *      reference   ----------------
 *      current              -------------     one wall: both pieces overlap on one line
 *                                    |
 *                                    |        another wall */
class SharedLines
{
 public:
  struct Piece
  {
    AnchoredLine line;  //!< in the frame of the reference
    Eigen::Vector2d firstEnd_m, lastEnd_m;
    double begin_m, end_m;  //!< coordinates along the line
    std::size_t wall = 0;   //!< index of the most certain piece of the same wall
  };

  /** Adds a piece.
   *  @param T_ref_scan true pose of the scan that shows it */
  void add(const Segment& straight, const Pose2& T_ref_scan);

  /** Sorts the pieces into walls. It has to be called once, after all pieces were added. */
  void group();

  const std::vector<Piece>& pieces() const { return pieces_; }

  /** The piece on which a ray ends, within a few standard deviations of its range; null if there is
   * none.
   *  @param direction of the ray, unit vector
   *  @param end_m measured end point of the ray */
  const Piece* pieceAt(const Eigen::Vector2d& direction, const Eigen::Vector2d& end_m,
                       double rangeSigma_m) const;

 private:
  void join(std::size_t wall, std::size_t otherWall);

  std::vector<Piece> pieces_;
};
}  // namespace psmks
