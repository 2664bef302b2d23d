/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Scan.h>

#include <Eigen/Core>
#include <limits>
#include <vector>

namespace psmks
{
/** Turns loose points, seen from the origin, into ranges of a scan (a z-buffer by bearing).
 *
 *      ray i  ray i+1
 *        \     /
 *     a---x---x---b     points a, b of one surface: the rays between them meet the join a-b
 *          \ /
 *           o
 *
 * A point seldom lies on a ray, and on a wall seen at a slant half a ray's width is centimetres of
 * range: therefore rays meet the joins of neighbouring points instead of taking over their ranges.
 */
class SurfaceView
{
 public:
  /** @param maxGap_m points closer together are one surface; a multiple of the spacing of the rays
   * at the points is granted beside it */
  SurfaceView(const BeamGrid& grid, double maxGap_m);

  /** Points that are not finite, at the origin or outside the field of view are left out. */
  void addPoint(const Eigen::Vector2d& p);

  /** Fills ranges and validity of a scan on the same grid, with every ray invalid before. */
  void draw(Scan& scan) const;

 private:
  struct Point
  {
    Eigen::Vector2d p;
    double range_m;
    int ray;  //!< the nearest one
  };

  /** The surface that the rays see first: the mean of the points near a ray, less those behind. */
  struct Surface
  {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    int points = 0;
    double nearest_m = std::numeric_limits<double>::infinity();

    Eigen::Vector2d mean() const { return sum / points; }
  };

  std::vector<Surface> visibleSurfaces() const;
  double reach_m(double range_m) const;
  int nextOnSurface(const std::vector<Surface>& surfaces, int ray) const;
  void join(const Eigen::Vector2d& from, const Eigen::Vector2d& to, Scan& scan) const;

  BeamGrid grid_;
  double maxGap_m_;
  std::vector<Point> points_;
};
}  // namespace psmks
