/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose3D.h>
#include <mrpt/serialization/CArchive.h>
#include <psmks/logs/RawlogWriter.h>
#include <psmks/mrpt/Convert.h>

namespace psmks
{
using mrpt::obs::CActionCollection;
using mrpt::obs::CActionRobotMovement2D;
using mrpt::obs::CObservation2DRangeScan;
using mrpt::obs::CObservationOdometry;
using mrpt::obs::CSensoryFrame;

namespace
{
void assignRanges(const Scan& scan, CObservation2DRangeScan& observation)
{
  const float noReturn_m = static_cast<float>(scan.maxRange_m);
  observation.resizeScanAndAssign(scan.range_m.size(), noReturn_m, false);
  for (std::size_t ray = 0; ray < scan.range_m.size(); ++ray)
  {
    if (!isReturn(scan, static_cast<int>(ray))) continue;
    observation.setScanRange(ray, static_cast<float>(scan.range_m[ray]));
    observation.setScanRangeValidity(ray, true);
  }
}

/** The odometry noise in the terms of MRPT's Gaussian motion model, which has the same ones: a
 * minimum and shares of the distance and of the turn. */
CActionRobotMovement2D::TMotionModelOptions motionModel(const OdometryOptions& odometry)
{
  constexpr double kTurn_rad = 2 * kPi;
  CActionRobotMovement2D::TMotionModelOptions model;
  model.modelSelection = CActionRobotMovement2D::mmGaussian;
  model.gaussianModel = {odometry.sigmaPerMetre_m,   odometry.sigmaPerTurn_m / kTurn_rad,
                         odometry.sigmaPerMetre_rad, odometry.sigmaPerTurn_rad / kTurn_rad,
                         odometry.minSigma_m,        odometry.minSigma_rad};
  return model;
}
}  // namespace

CObservation2DRangeScan::Ptr toMrpt(const Scan& scan, const Pose2& T_robot_sensor)
{
  const BeamGrid& grid = scan.grid;
  const double aperture_rad = grid.increment_rad() * (grid.count() - 1);
  const double middle_rad = grid.firstBearing_rad() + aperture_rad / 2;

  auto observation = CObservation2DRangeScan::Create();
  observation->timestamp = mrpt::Clock::fromDouble(scan.stamp_s);
  observation->sensorLabel = "LASER1";
  observation->sensorPose = mrpt::poses::CPose3D(toMrpt(T_robot_sensor * Pose2{0, 0, middle_rad}));
  observation->rightToLeft = true;
  observation->aperture = static_cast<float>(aperture_rad);
  observation->maxRange = static_cast<float>(scan.maxRange_m);
  if (scan.rangeSigma_m > 0) observation->stdError = static_cast<float>(scan.rangeSigma_m);
  assignRanges(scan, *observation);
  return observation;
}

bool RawlogWriter::write(const Scan& scan, const Pose2& T_start_odometry)
{
  LaserFrame frame;
  frame.scan = toMrpt(scan, options_.T_robot_sensor);
  frame.stamp_s = scan.stamp_s;
  frame.odometry = T_start_odometry_.value_or(T_start_odometry).inverse() * T_start_odometry;
  frame.observations.insert(frame.scan);
  if (!T_start_odometry_) T_start_odometry_ = T_start_odometry;
  return write(frame);
}

bool RawlogWriter::write(const LaserFrame& frame)
{
  if (frame.scan->timestamp == INVALID_TIMESTAMP)
    frame.scan->timestamp = mrpt::Clock::fromDouble(frame.stamp_s);
  LaserFrame placed = frame;
  if (!T_start_odometry_) placed.odometry = Pose2();
  T_start_odometry_ = T_start_odometry_.value_or(Pose2()) * placed.odometry.value_or(Pose2());
  if (options_.format == RawlogFormat::Actions)
    writeActions(placed);
  else
    writeObservations(placed);
  return file_.isGood();
}

void RawlogWriter::writeActions(const LaserFrame& frame)
{
  CActionCollection actions;
  if (frame.odometry)
  {
    CActionRobotMovement2D movement;
    movement.timestamp = frame.scan->timestamp;
    movement.computeFromOdometry(toMrpt(*frame.odometry), motionModel(options_.odometry));
    actions.insert(movement);
  }
  auto archive = mrpt::serialization::archiveFrom(file_);
  archive << actions << frame.observations;
}

void RawlogWriter::writeObservations(const LaserFrame& frame)
{
  auto archive = mrpt::serialization::archiveFrom(file_);
  if (frame.odometry)
  {
    CObservationOdometry odometry;
    odometry.timestamp = frame.scan->timestamp;
    odometry.sensorLabel = "ODOMETRY";
    odometry.odometry = toMrpt(*T_start_odometry_);
    archive << odometry;
  }
  for (const auto& observation : frame.observations) archive << *observation;
}
}  // namespace psmks
