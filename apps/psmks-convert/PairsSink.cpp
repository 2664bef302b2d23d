/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-convert/PairsSink.h>
#include <apps/support/ExitCode.h>
#include <apps/support/GroundTruth.h>
#include <apps/support/ReplacedFile.h>
#include <apps/support/TextFile.h>

#include <cmath>
#include <utility>

namespace psmks
{
namespace
{
/** Sets the ranges of rays without return to 0, as in files of scan pairs. */
void setInvalidToZero(Scan& scan)
{
  for (std::size_t ray = 0; ray < scan.range_m.size(); ++ray)
    if (!scan.valid[ray] || !std::isfinite(scan.range_m[ray])) scan.range_m[ray] = 0;
}

/** The motion between two sensors from that of their robots. */
Pose2 ofSensors(const Pose2& T_ref_cur, const Pose2& T_ref_sensor, const Pose2& T_cur_sensor)
{
  return T_ref_sensor.inverse() * T_ref_cur * T_cur_sensor;
}

/** @throws ProgramError if a file cannot be created */
const std::string& creatable(const std::string& path)
{
  requireCreated(isCreatable(path), path);
  return path;
}

std::string remark(int count, const std::string& what)
{
  return count == 0 ? "" : "; " + std::to_string(count) + " " + what;
}
}  // namespace

PairsSink::PairsSink(const std::string& path, const std::string& groundTruth, int every)
    : path_(creatable(path)),
      truth_(readGroundTruth(groundTruth)),
      truthIndex_(truth_),
      every_(every)
{
}

void PairsSink::write(const LaserFrame& frame)
{
  odometry_ = odometry_ * frame.odometry.value_or(Pose2());
  odometryIsWhole_ = odometryIsWhole_ && frame.odometry;
  if (frames_++ % every_ != 0) return;

  auto current = taken(frame);
  if (reference_ && current) addPair(*current);
  reference_ = std::move(current);
  odometry_ = Pose2();
  odometryIsWhole_ = true;
}

/** The scan with its poses; nothing if its true pose is unknown or a file of scan pairs cannot hold
 * it. */
std::optional<PairsSink::Taken> PairsSink::taken(const LaserFrame& frame)
{
  const auto truth = truthIndex_.nearest(frame.stamp_s, kStampTolerance_s);
  if (!truth || !truth_[*truth].hasHeading())
  {
    ++withoutTruth_;
    return std::nullopt;
  }
  Taken taken{converter_.convert(*frame.scan), sensorMounting(*frame.scan).T_robot_sensor,
              truth_[*truth].pose};
  setInvalidToZero(taken.scan);
  if (header_.grid.count() == 0) header_ = {taken.scan.grid, taken.scan.maxRange_m, 0};
  if (header_.grid.count() > 0 && taken.scan.grid == header_.grid) return taken;
  ++withOtherRays_;
  return std::nullopt;
}

void PairsSink::addPair(const Taken& current)
{
  if (!odometryIsWhole_) ++withoutOdometry_;
  const Pose2& T_ref_sensor = reference_->T_robot_sensor;
  ScanPair pair;
  pair.id = static_cast<int>(pairs_.size());
  pair.T_ref_cur_true = ofSensors(reference_->T_world_true.inverse() * current.T_world_true,
                                  T_ref_sensor, current.T_robot_sensor);
  pair.T_ref_cur_odometry = ofSensors(odometry_, T_ref_sensor, current.T_robot_sensor);
  pair.reference = reference_->scan;
  pair.current = current.scan;
  pairs_.push_back(std::move(pair));
}

std::string PairsSink::finish()
{
  if (pairs_.empty())
    throw ProgramError(kNothingToDo, "no two scans follow each other whose true poses are known");
  header_.pairs = static_cast<int>(pairs_.size());
  requireWritten(replaceFile(path_,
                             [this](const std::string& beside)
                             {
                               PairsWriter writer(beside, header_);
                               for (const auto& pair : pairs_) writer.write(pair);
                               writer.close();
                               return true;
                             }),
                 path_);
  return std::to_string(pairs_.size()) + " pairs" +
         remark(withoutTruth_, "scans without a true pose left out") +
         remark(withOtherRays_, "scans with other rays left out") +
         remark(withoutOdometry_, "pairs with missing odometry in their guess");
}
}  // namespace psmks
