/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/eval/SharedLines.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
using Piece = SharedLines::Piece;

constexpr double kGate = 4;  // standard deviations by which two pieces of one wall may differ
/** Length by which a wall is extended beyond the part that was seen. */
constexpr double kMargin_m = 0.1;

bool isOn(const AnchoredLine& line, const AnchoredLine& other, const Eigen::Vector2d& point_m)
{
  const double distance_m = line.normal.dot(point_m) - line.distance_m;
  const double variance_m2 =
      line.distanceVarianceAt_m2(point_m) + other.distanceVarianceAt_m2(point_m);
  return distance_m * distance_m < kGate * kGate * variance_m2;
}

bool isOn(const Piece& line, const Piece& piece)
{
  return isOn(line.line, piece.line, piece.firstEnd_m) &&
         isOn(line.line, piece.line, piece.lastEnd_m);
}

/** Whether the extents of both pieces along the first one overlap. */
bool touches(const Piece& a, const Piece& b)
{
  const double first_m = a.line.along.dot(b.firstEnd_m), last_m = a.line.along.dot(b.lastEnd_m);
  return std::min(first_m, last_m) < a.end_m + kMargin_m &&
         std::max(first_m, last_m) > a.begin_m - kMargin_m;
}

bool isSameWall(const Piece& a, const Piece& b)
{
  return touches(a, b) && isOn(a, b) && isOn(b, a);
}
}  // namespace

void SharedLines::add(const Segment& straight, const Pose2& T_ref_scan)
{
  Piece piece;
  piece.line = AnchoredLine(straight.line.transformed(T_ref_scan));
  piece.firstEnd_m = T_ref_scan * straight.firstEnd_m;
  piece.lastEnd_m = T_ref_scan * straight.lastEnd_m;
  const double first_m = piece.line.along.dot(piece.firstEnd_m);
  const double last_m = piece.line.along.dot(piece.lastEnd_m);
  piece.begin_m = std::min(first_m, last_m);
  piece.end_m = std::max(first_m, last_m);
  pieces_.push_back(piece);
}

// Begins with the most certain piece, so that the number of a wall is that of its most certain
// piece.
void SharedLines::group()
{
  std::sort(pieces_.begin(), pieces_.end(),
            [](const Piece& a, const Piece& b)
            { return a.line.angleVariance_rad2 < b.line.angleVariance_rad2; });
  for (std::size_t p = 0; p < pieces_.size(); ++p)
  {
    pieces_[p].wall = p;
    for (std::size_t q = 0; q < p; ++q)
      if (isSameWall(pieces_[q], pieces_[p])) join(pieces_[q].wall, pieces_[p].wall);
  }
}

void SharedLines::join(std::size_t wall, std::size_t otherWall)
{
  const auto [kept, dropped] = std::minmax(wall, otherWall);
  for (Piece& piece : pieces_)
    if (piece.wall == dropped) piece.wall = kept;
}

const SharedLines::Piece* SharedLines::pieceAt(const Eigen::Vector2d& direction,
                                               const Eigen::Vector2d& end_m,
                                               double rangeSigma_m) const
{
  const Piece* nearest = nullptr;
  double nearest_m = kGate * rangeSigma_m;
  for (const Piece& piece : pieces_)
  {
    const double along_m = piece.line.along.dot(end_m);
    if (along_m < piece.begin_m - kMargin_m || along_m > piece.end_m + kMargin_m) continue;
    const double residual_m = std::abs((piece.line.normal.dot(end_m) - piece.line.distance_m) /
                                       piece.line.normal.dot(direction));
    if (residual_m >= nearest_m) continue;
    nearest_m = residual_m;
    nearest = &piece;
  }
  return nearest;
}
}  // namespace psmks
