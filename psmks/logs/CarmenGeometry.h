/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/BeamGrid.h>
#include <psmks/geometry/BeamTiming.h>
#include <psmks/logs/CarmenMessage.h>
#include <psmks/logs/CarmenOptions.h>
#include <psmks/logs/CarmenSurvey.h>

#include <string>

namespace psmks
{
/** The geometry of the scanner of a CARMEN log. The sources in the order of their priority are the
 * user, the message, the parameters of the log and the readings. */
class CarmenGeometry
{
 public:
  CarmenGeometry(const std::string& sensor, const CarmenSurvey& survey,
                 const CarmenOptions& options);

  /** The number of increments that the field of view of so many rays has. */
  static int stepsOf(int rays);

  /** The mounting of the sensor. A FLASER looks straight ahead and an RLASER back, at the offset
   * that the parameters state. The messages of a ROBOTLASER state its mounting. */
  const Pose2& T_robot_sensor() const { return T_robot_sensor_; }

  /** The bearings of a scan.
   *
   * If nothing states the field of view, it is the half circle, beginning at -90 degrees. With an
   * even number of rays the ray at +90 degrees is missing.
   *
   *     rays       181     180     361     360
   *     every      1 deg   1 deg   0.5     0.5 deg
   *     last ray   +90     +89     +90     +89.5 deg
   *
   * A stated increment with which the rays would exceed the circle is ignored. */
  const BeamGrid& grid(const CarmenScanner& stated, int rays);

  /** The range at or beyond which readings are no returns. */
  double maxRange_m(const CarmenScanner& stated) const;

  /** When the rays are cast. It is known for the SICK LMS (75 turns a second, in each of which it
   * casts a ray every degree), for which the messages without a description of the scanner were
   * made, for the SICK PLS (25 turns a second), and for the Hokuyo URG (10 turns a second), which
   * is known by its 1024 steps a turn, for converters of logs leave the type of the scanner at its
   * default; a time of 0 for others. A field of view beyond the half circle is none of an LMS.
   * Sources: SICK, technical descriptions LMS 200 / 211 / 221 / 291 and PLS 101; Hokuyo,
   * specification URG-04LX. */
  static BeamTiming beam(const std::optional<CarmenScanner>& stated);

  /** Whether the bearings of the rays follow from their number alone. */
  bool isGuessed(const CarmenScanner& stated, int rays) const;

 private:
  CarmenOptions options_;
  CarmenScanner parameters_;
  NoReturnReading noReturn_;
  Pose2 T_robot_sensor_;
  BeamGrid grid_;  //!< grid of the last message, for most scans share theirs
};
}  // namespace psmks
