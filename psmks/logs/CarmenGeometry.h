/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/BeamGrid.h>
#include <psmks/logs/CarmenMessage.h>
#include <psmks/logs/CarmenOptions.h>
#include <psmks/logs/CarmenSurvey.h>

#include <string>

namespace psmks
{
/** What is known of the scanner of a message: by the user, by the message, by the log's parameters
 *  and by its readings, in this order. */
class CarmenGeometry
{
 public:
  CarmenGeometry(const std::string& sensor, const CarmenSurvey& survey,
                 const CarmenOptions& options);

  /** Steps of the increment that a field of view has which so many rays fill. */
  static int stepsOf(int rays);

  /** Where the sensor sits: a FLASER straight ahead, an RLASER looking back, at the offset that
   *  parameters state; a ROBOTLASER where its messages put it. */
  const Pose2& T_robot_sensor() const { return T_robot_sensor_; }

  /** The bearings of so many rays.
   *
   * Where nothing states the field of view it is the half circle, from -90 degrees on: with an even
   * number of rays, the ray at +90 degrees is missing.
   *
   *     rays       181     180     361     360
   *     every      1 deg   1 deg   0.5     0.5 deg
   *     last ray   +90     +89     +90     +89.5 deg
   *
   * An angle between rays by which they would go round more than once is taken for a mistake. */
  const BeamGrid& grid(const CarmenScanner& stated, int rays);

  /** Readings at or beyond it are no returns. */
  double maxRange_m(const CarmenScanner& stated) const;

  /** Time in which the beam goes once round: of the SICK LMS (75 turns a second), for which the
   * messages without a scanner's description were made, and of the SICK PLS (25); 0 for others.
   *  Source: SICK, technical descriptions LMS 200 / 211 / 221 / 291 and PLS 101. */
  static double beamTurn_s(const std::optional<CarmenScanner>& stated);

  /** Whether nothing but the number of its rays tells where they point to. */
  bool isGuessed(const CarmenScanner& stated, int rays) const;

 private:
  CarmenOptions options_;
  CarmenScanner parameters_;
  NoReturnReading noReturn_;
  Pose2 T_robot_sensor_;
  BeamGrid grid_;  //!< of the last message: most scans share theirs
};
}  // namespace psmks
