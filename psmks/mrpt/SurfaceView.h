/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Scan.h>

#include <Eigen/Core>
#include <limits>
#include <vector>

namespace psmks
{
/** Turns points into ranges of a scan whose sensor stands at the origin. Of several points in one
 *  direction the nearest counts: a z-buffer over bearings.
 *
 *      ray i  ray i+1
 *        \     /
 *     a---x---x---b     points a, b of one surface: the rays between them meet the join a-b
 *          \ /
 *           o
 *
 * A point seldom lies on a ray, and on a wall seen at a slant half the spacing of the rays makes
 * centimetres of range. Ranges are therefore measured to the joins of neighbouring points and not
 * to the points themselves. */
class SurfaceView
{
 public:
  /** @param maxGap_m two points are on one surface if they are closer to each other than this plus
   *  three times the spacing of the rays at their range */
  SurfaceView(const BeamGrid& grid, double maxGap_m);

  /** Adds a point in the frame of the sensor. One that is not finite, at the origin or outside the
   *  field of view is left out. */
  void addPoint(const Eigen::Vector2d& p);

  /** Sets the range of every ray that meets a join and marks it as valid.
   *  @param[in,out] scan on the grid of the view, with every ray invalid before */
  void draw(Scan& scan) const;

 private:
  struct Point
  {
    Eigen::Vector2d p;
    double range_m;
    int ray;  //!< the nearest one
  };

  /** What a ray sees first: the mean of the points nearest to the ray, without those that lie more
   *  than maxGap_m behind the nearest. */
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
