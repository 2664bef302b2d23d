/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Scan.h>
#include <psmks/motion/PlanarVelocity.h>

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace psmks
{
/** Corrects scans for the motion of the scanner while it took them, so that all rays are as if cast
 * from one pose (docs/derivations.md, "Sweeps").
 *
 *     turn 0    0   2   4   6     a scanner that turns meanwhile: the rays of the second turn
 *     turn 1        1   3   5   7    lie on other bearings than in between those of the first
 *     grid      0 1 2 3 4 5 6 7   each range is led along its surface to its place in the grid
 *
 * - Rotation during a sweep widens or narrows the grid, which stays even: no range changes by it.
 * - Where several turns of the beam took the scan, translation, and rotation from turn to turn,
 * move the end of a ray to another range and bearing. Each ray of the grid takes the moved ray of
 * its own turn that is nearest to it, and where rays of that turn show a straight surface, its
 * slope leads to the bearing of the grid. Elsewhere the range stays, and its bearing is off by less
 * than half the angle between two rays of a turn. Edges stay sharp, and no two ranges are averaged,
 *   so that the noise stays white.
 *
 * Translation during a scan of one turn is not corrected. Rays whose turn did not reach as far are
 * NaN. Where the rays would cover more than a full circle, the last ones are dropped.
 *
 * The pose of a scan of one turn is that at its first ray, and so at its stamp. Of several turns it
 * is that in the middle of the scan, for which ranges are corrected least: half a scan after its
 * first ray, the same delay in all scans of a scanner. */
class Deskewer
{
 public:
  /** Takes the motion out of a scan. The scan stays as it is where the velocity is zero or not
   *  finite, where the scan does not state its timing, and where it has not as many ranges as rays.
   *  @param velocity of the sensor, in its own axes */
  void deskew(Scan& scan, const PlanarVelocity& velocity);

  /** The velocity of the sensor, by the differences between its interleaved turns: where they are
   *  matched against each other, a scan tells by itself how the sensor moved from turn to turn.
   *  @param expected from other sources
   *  @param covariance of `expected`: (m/s)^2, (rad/s)^2
   *  @return `expected` where the scan was taken in one turn or does not state its timing */
  PlanarVelocity fittedVelocity(const Scan& scan, const PlanarVelocity& expected,
                                const Eigen::Matrix3d& covariance);

 private:
  /** A ray as if cast from the pose in the middle of the scan. */
  struct MovedRay
  {
    double range_m;
    double excess_rad;  //!< of its bearing, over that of its place in the grid
  };

  bool prepare(const Scan& scan);
  void takeCorrected(int ray, Scan& scan) const;
  void measureSlopes();
  double bendAt_m(std::size_t ray, std::size_t firstStep, std::size_t secondStep) const;
  double slopeAt(std::size_t ray) const;
  MovedRay moved(int ray, const PlanarVelocity& velocity) const;
  int nearestMoved(int ray, const PlanarVelocity& velocity) const;
  double correctedRange_m(int ray, int source, const PlanarVelocity& velocity) const;
  void correctAll(const PlanarVelocity& velocity);
  Eigen::Vector3d sensitivity(int ray) const;
  void addDifferences(double scale_m, Eigen::Matrix3d& information, Eigen::Vector3d& pull);
  double typicalDifference_m();

  BeamGrid grid_;
  int turns_ = 1;
  std::vector<double> range_m_;  //!< as measured; NaN without return
  std::vector<double> rise_;     //!< of the inverse range to the next ray of the turn, 1/(m rad)
  double typicalBend_m_ = 0;     //!< median of bendAt_m()
  std::vector<double> slope_m_rad_;   //!< of the range by the bearing, along the ray's own turn
  std::vector<double> time_s_;        //!< since the middle of the scan
  std::vector<double> turnOffset_s_;  //!< of it, what is not due to the sweep
  std::vector<double> corrected_m_;   //!< NaN where nothing is known
  std::vector<int> source_;           //!< the ray that the corrected range comes from, or -1
  std::vector<double> difference_m_;  //!< between a corrected range and its neighbours
  std::vector<double> sizes_;
  std::vector<std::uint8_t> valid_;  //!< flags before the correction
};
}  // namespace psmks
