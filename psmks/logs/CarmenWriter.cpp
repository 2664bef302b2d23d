/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/geometry/Angle.h>
#include <psmks/logs/CarmenGeometry.h>
#include <psmks/logs/CarmenWriter.h>

#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>

namespace psmks
{
namespace
{
/** Two scanner geometries are the same if they differ by less. */
constexpr double kTolerance_m = 1e-6, kTolerance_deg = 1e-4;

/** A blank and the shortest text that reads back as the same number. */
template <class Number>
std::string word(Number value)
{
  std::array<char, 400> buffer{};
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed);
  return ' ' + std::string(buffer.data(), end.ptr);
}

std::string words(const Pose2& pose)
{
  return word(pose.x_m) + word(pose.y_m) + word(pose.phi_rad);
}

std::string stamps(double stamp_s) { return word(stamp_s) + " psmks" + word(stamp_s) + '\n'; }

std::string parameter(const std::string& name, double value)
{
  return "PARAM " + name + word(value) + " 0 psmks 0\n";
}

/** The angle between rays. The aperture is a float, so if a multiple of 1e-4 degrees gives the same
 * float, this multiple is taken. */
double increment_deg(float aperture_rad, int rays)
{
  constexpr double kRoundTo = 1e4;
  const double read_deg = radToDeg(static_cast<double>(aperture_rad)) / (rays - 1);
  const double round_deg = std::round(read_deg * kRoundTo) / kRoundTo;
  return static_cast<float>(degToRad(round_deg * (rays - 1))) == aperture_rad ? round_deg
                                                                              : read_deg;
}
}  // namespace

bool CarmenWriter::write(const LaserFrame& frame)
{
  converter_.convert(*frame.scan, scan_);
  if (scan_.grid.count() < 2) return true;
  const Scanner scanner = scannerOf(frame);
  std::string text;
  if (!scanner_)
  {
    scanner_ = scanner;
    text = header(frame);
  }
  if (!scanner_->isNear(scanner))
    throw std::runtime_error("the scanner's bearings or its place on the robot change");
  T_start_robot_ = T_start_robot_ * frame.odometry.value_or(Pose2());
  text += (scanner_->fitsFlaser() ? flaser() : robotLaser(frame)) + stamps(frame.stamp_s);
  return file_.write(text);
}

/** A scan that closes the circle has fewer rays than its observation, and its rays are not
 * symmetric about the x axis. */
CarmenWriter::Scanner CarmenWriter::scannerOf(const LaserFrame& frame) const
{
  const BeamGrid& grid = scan_.grid;
  Scanner scanner{sensorMounting(*frame.scan).T_robot_sensor, radToDeg(grid.increment_rad()),
                  grid.count()};
  if (grid.count() == static_cast<int>(frame.scan->getScanSize()))
    scanner.increment_deg = increment_deg(frame.scan->aperture, scanner.rays);
  else
    scanner.T_robot_sensor.phi_rad +=
        grid.firstBearing_rad() + grid.increment_rad() * (grid.count() - 1) / 2;
  return scanner;
}

bool CarmenWriter::Scanner::fitsFlaser() const
{
  const double first_deg = radToDeg(T_robot_sensor.phi_rad) - halfAperture_deg();
  const double expected_deg = -increment_deg * CarmenGeometry::stepsOf(rays) / 2;
  return std::abs(T_robot_sensor.y_m) < kTolerance_m &&
         std::abs(first_deg - expected_deg) < kTolerance_deg;
}

bool CarmenWriter::Scanner::isNear(const Scanner& other) const
{
  const Pose2 difference = T_robot_sensor.inverse() * other.T_robot_sensor;
  return rays == other.rays && std::abs(increment_deg - other.increment_deg) < kTolerance_deg &&
         difference.translation().norm() < kTolerance_m &&
         std::abs(radToDeg(difference.phi_rad)) < kTolerance_deg;
}

std::string CarmenWriter::header(const LaserFrame& frame) const
{
  std::string text = "# CARMEN Logfile\n";
  if (!scanner_->fitsFlaser()) return text;
  text += parameter("laser_front_laser_resolution", scanner_->increment_deg);
  if (frame.scan->maxRange > 0)
    text += parameter("robot_front_laser_max", static_cast<double>(frame.scan->maxRange));
  return text + parameter("robot_frontlaser_offset", scanner_->T_robot_sensor.x_m);
}

std::string CarmenWriter::flaser() const
{
  const Pose2 T_start_laser = T_start_robot_ * Pose2{scanner_->T_robot_sensor.x_m, 0, 0};
  return "FLASER" + ranges() + words(T_start_laser) + words(T_start_robot_);
}

std::string CarmenWriter::robotLaser(const LaserFrame& frame) const
{
  const double half_rad = degToRad(scanner_->halfAperture_deg());
  const std::string unknownType = " 99", noRemissions = " 0", atRest = " 0 0", noSafety = " 0 0 0";
  return "ROBOTLASER1" + unknownType + word(-half_rad) + word(2 * half_rad) +
         word(degToRad(scanner_->increment_deg)) + word(frame.scan->maxRange) +
         word(frame.scan->stdError) + noRemissions + ranges() + noRemissions +
         words(T_start_robot_ * scanner_->T_robot_sensor) + words(T_start_robot_) + atRest +
         noSafety;
}

/** Writes ranges as floats, for those of MRPT are floats. */
std::string CarmenWriter::ranges() const
{
  std::string text = ' ' + std::to_string(scan_.range_m.size());
  for (std::size_t ray = 0; ray < scan_.range_m.size(); ++ray)
    text += word(static_cast<float>(scan_.valid[ray] ? scan_.range_m[ray] : scan_.maxRange_m));
  return text;
}
}  // namespace psmks
