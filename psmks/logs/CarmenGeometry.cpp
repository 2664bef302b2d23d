/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/geometry/Angle.h>
#include <psmks/logs/CarmenGeometry.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
constexpr double kHalfCircle_rad = kPi;

std::optional<double> firstOf(const std::optional<double>& a, const std::optional<double>& b,
                              const std::optional<double>& c = std::nullopt)
{
  return a ? a : b ? b : c;
}

/** The value of a parameter of CARMEN's "laser" or "robot" module; nothing if the log does not
 * state it. */
std::optional<double> parameterOf(const CarmenSurvey& survey, const std::string& name)
{
  const auto found = survey.parameters.find(name);
  return found == survey.parameters.end() ? std::nullopt : std::make_optional(found->second);
}

std::optional<double> positiveParameterOf(const CarmenSurvey& survey, const std::string& name)
{
  const auto value = parameterOf(survey, name);
  return value && *value > 0 ? value : std::nullopt;
}

std::optional<double> angleParameterOf(const CarmenSurvey& survey, const std::string& name_deg)
{
  const auto value_deg = positiveParameterOf(survey, name_deg);
  return value_deg ? std::make_optional(degToRad(*value_deg)) : std::nullopt;
}

bool isRear(const std::string& sensor)
{
  return sensor == "RLASER" || sensor == "ROBOTLASER2" || sensor == "RAWLASER2";
}

CarmenScanner scannerOfParameters(const CarmenSurvey& survey, bool rear)
{
  const std::string side = rear ? "rear_laser" : "front_laser";
  CarmenScanner scanner;
  scanner.increment_rad = angleParameterOf(survey, "laser_" + side + "_resolution");
  scanner.fieldOfView_rad = angleParameterOf(survey, "laser_" + side + "_fov");
  scanner.maxRange_m = positiveParameterOf(survey, "robot_" + side + "_max");
  return scanner;
}

/** Where a parameter puts the scanner on the robot; 0 where it would not be on a robot. */
double offset_m(const CarmenSurvey& survey, const std::string& name)
{
  /** Largest offset. Definition: a ship. */
  constexpr double kLargest_m = 100;
  const double stated_m = parameterOf(survey, name).value_or(0);
  return std::abs(stated_m) < kLargest_m ? stated_m : 0;
}

Pose2 mountingOfParameters(const CarmenSurvey& survey, bool rear)
{
  const std::string side = rear ? "robot_rearlaser" : "robot_frontlaser";
  return {offset_m(survey, side + "_offset"), offset_m(survey, side + "_side_offset"),
          rear ? kPi : 0};
}

/** Whether rays can have this increment, see BeamGrid. */
bool fitsRound(double increment_rad, int rays) { return BeamGrid::accepts(0, increment_rad, rays); }

/** Whether the rays are those of a Hokuyo URG, which has 1024 steps a turn. */
bool isUrg(const CarmenScanner& scanner)
{
  constexpr double kStep_rad = 2 * kPi / 1024, kRounding = 1e-4;  // six decimals
  return scanner.increment_rad && std::abs(*scanner.increment_rad / kStep_rad - 1) < kRounding;
}

/** Whether the field of view is wider than the half circle and an increment. */
bool isBeyondHalfCircle(const CarmenScanner& scanner)
{
  return scanner.fieldOfView_rad.value_or(0) > kHalfCircle_rad + scanner.increment_rad.value_or(0);
}

double spread_rad(double fieldOfView_rad, int rays)
{
  const double increment_rad = fieldOfView_rad / CarmenGeometry::stepsOf(rays);
  return fitsRound(increment_rad, rays) ? increment_rad : 2 * kPi / rays;
}

/** A field of view where it is one for so many rays; nothing where it is none. */
std::optional<double> sensibleView_rad(const std::optional<double>& fieldOfView_rad, int rays)
{
  /** Widest field of view that is taken for a circle. Definition: a turn and a half. */
  constexpr double kWidest_rad = 3 * kPi;
  const bool isSensible =
      fieldOfView_rad && *fieldOfView_rad <= kWidest_rad &&
      *fieldOfView_rad / CarmenGeometry::stepsOf(rays) >= BeamGrid::kLeastIncrement_rad;
  return isSensible ? fieldOfView_rad : std::nullopt;
}
}  // namespace

CarmenGeometry::CarmenGeometry(const std::string& sensor, const CarmenSurvey& survey,
                               const CarmenOptions& options)
    : options_(options), parameters_(scannerOfParameters(survey, isRear(sensor)))
{
  const CarmenSensorSurvey& scans = survey.sensors.at(sensor);
  noReturn_ = scans.noReturn;
  const bool isStatedByMessages = sensor.rfind("ROBOTLASER", 0) == 0 && !scans.mountingVaries;
  T_robot_sensor_ =
      isStatedByMessages ? scans.T_robot_sensor : mountingOfParameters(survey, isRear(sensor));
}

int CarmenGeometry::stepsOf(int rays) { return std::max(1, rays % 2 == 1 ? rays - 1 : rays); }

const BeamGrid& CarmenGeometry::grid(const CarmenScanner& stated, int rays)
{
  const auto fieldOfView_rad =
      firstOf(options_.fieldOfView_rad, sensibleView_rad(stated.fieldOfView_rad, rays),
              sensibleView_rad(parameters_.fieldOfView_rad, rays));
  const auto stated_rad =
      firstOf(options_.increment_rad, stated.increment_rad, parameters_.increment_rad);
  const double increment_rad = stated_rad && fitsRound(*stated_rad, rays)
                                   ? *stated_rad
                                   : spread_rad(fieldOfView_rad.value_or(kHalfCircle_rad), rays);

  const double centered_rad = -fieldOfView_rad.value_or(increment_rad * stepsOf(rays)) / 2;
  const bool isSetByUser = options_.fieldOfView_rad.has_value();
  const double statedFirst_rad = stated.firstBearing_rad.value_or(centered_rad);
  const double first_rad = isSetByUser || !BeamGrid::accepts(statedFirst_rad, increment_rad, rays)
                               ? centered_rad
                               : statedFirst_rad;
  const bool isKnown = grid_.count() == rays && grid_.firstBearing_rad() == first_rad &&
                       grid_.increment_rad() == increment_rad;
  if (!isKnown) grid_ = BeamGrid(first_rad, increment_rad, rays);
  return grid_;
}

double CarmenGeometry::maxRange_m(const CarmenScanner& stated) const
{
  if (options_.maxRange_m) return *options_.maxRange_m;
  const auto statedMaxRange_m = firstOf(stated.maxRange_m, parameters_.maxRange_m);
  const double read_m = noReturn_.limit_m();
  if (!statedMaxRange_m) return read_m;
  return noReturn_.isCode() ? std::min(*statedMaxRange_m, read_m) : *statedMaxRange_m;
}

BeamTiming CarmenGeometry::beam(const std::optional<CarmenScanner>& stated)
{
  constexpr int kSickLms = 0, kSickPls = 1;
  constexpr double kPlsTurn_s = 1.0 / 25, kUrgTurn_s = 0.1;
  constexpr BeamTiming kLms{1.0 / 75, degToRad(1)};
  if (!stated) return kLms;
  if (isUrg(*stated)) return {kUrgTurn_s, 0};
  const int type = stated->type.value_or(-1);
  if (type == kSickPls) return {kPlsTurn_s, 0};
  return type == kSickLms && !isBeyondHalfCircle(*stated) ? kLms : BeamTiming{};
}

bool CarmenGeometry::isGuessed(const CarmenScanner& stated, int rays) const
{
  constexpr int kUsual[] = {180, 181, 360, 361};
  return !firstOf(options_.fieldOfView_rad, stated.fieldOfView_rad, parameters_.fieldOfView_rad) &&
         !firstOf(options_.increment_rad, stated.increment_rad, parameters_.increment_rad) &&
         std::find(std::begin(kUsual), std::end(kUsual), rays) == std::end(kUsual);
}
}  // namespace psmks
