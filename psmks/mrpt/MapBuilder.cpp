/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>
#include <mrpt/poses/CPosePDFGaussian.h>
#include <psmks/mrpt/ConfigFile.h>
#include <psmks/mrpt/MapBuilder.h>

#include <cmath>
#include <optional>
#include <type_traits>

namespace psmks
{
using mrpt::config::CConfigFileBase;
using mrpt::maps::CMultiMetricMap;
using mrpt::maps::CSimpleMap;
using mrpt::obs::CObservation;
using mrpt::obs::CObservation2DRangeScan;
using mrpt::obs::CObservationOdometry;
using mrpt::obs::CSensoryFrame;
using mrpt::poses::CPose3D;
using mrpt::poses::CPose3DPDFGaussian;
using mrpt::poses::CPosePDFGaussian;

namespace
{
/** The section of the options of psmks in an ini file of icp-slam. */
constexpr const char* kSection = "PSMKS";

bool isFartherThan(const Pose2& a, const Pose2& b, double distance_m, double angle_rad)
{
  return (a.translation() - b.translation()).norm() > distance_m ||
         std::abs(wrapAngle(a.phi_rad - b.phi_rad)) > angle_rad;
}

/** The map as a pointer or as a reference. */
template <class Result>
Result as(const CMultiMetricMap& map)
{
  if constexpr (std::is_pointer_v<Result>)
    return &map;
  else
    return map;
}

CPose3DPDFGaussian inSpace(const UncertainPose& pose) { return CPose3DPDFGaussian(toMrpt(pose)); }
}  // namespace

void MapBuilder::TConfigParams::loadFromConfigFile(const CConfigFileBase& source,
                                                   const std::string& section)
{
  MRPT_LOAD_CONFIG_VAR(insertionLinDistance, double, source, section)
  MRPT_LOAD_CONFIG_VAR_DEGREES(insertionAngDistance, source, section)
  MRPT_LOAD_CONFIG_VAR(matchAgainstTheGrid, bool, source, section)
  MRPT_LOAD_CONFIG_VAR(localizationLinDistance, double, source, section)
  MRPT_LOAD_CONFIG_VAR_DEGREES(localizationAngDistance, source, section)
  MRPT_LOAD_CONFIG_VAR(minICPgoodnessToAccept, double, source, section)
  mapInitializers.loadFromConfigFile(source, section);
}

MapBuilder::MapBuilder() { setLoggerName("psmks::MapBuilder"); }

void MapBuilder::loadOptions(const CConfigFileBase& file, const std::string& section)
{
  ICP_options.loadFromConfigFile(file, section);
  if (hasStages(file, kSection)) psmks_options.matching.loadFromConfigFile(file, kSection);
}

void MapBuilder::restart()
{
  slam_ = std::make_unique<ObservationSlam>(psmks_options);
  T_map_first_ = {};
  T_first_robot_ = {};
  frames_.clear();
  lastInserted_.clear();
  maps_.setListOfMaps(ICP_options.mapInitializers);
}

void MapBuilder::initialize(const CSimpleMap& initialMap, const mrpt::poses::CPosePDF* x0)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  restart();
  addKnownFrames(initialMap);
  if (!x0) return;
  const Pose2 start = toPose2(x0->getMeanVal());
  if (scans().empty())
    T_map_first_ = start;
  else
    slam_->addMotion(toMrpt(T_map_robot(T_first_robot_).pose.inverse() * start));
}

/** Gives the scans of a map to the SLAM. The first pose of the map is that of the first scan. */
void MapBuilder::addKnownFrames(const CSimpleMap& known)
{
  std::optional<Pose2> last;
  for (const auto& frame : known)
  {
    const Pose2 here = toPose2(mrpt::poses::CPose2D(frame.pose->getMeanVal()));
    if (last)
      slam_->addMotion(toMrpt(last->inverse() * here));
    else
      T_map_first_ = here;
    last = here;
    for (const CObservation::Ptr& observation : *frame.sf) observe(observation);
  }
}

void MapBuilder::processActionObservation(mrpt::obs::CActionCollection& action,
                                          CSensoryFrame& frame)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!slam_) restart();
  if (const auto movement = action.getBestMovementEstimation())
    slam_->addMotion(movement->poseChange->getMeanVal());
  for (const CObservation::Ptr& observation : frame) observe(observation);
}

void MapBuilder::processObservation(const CObservation::Ptr& observation)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!slam_) restart();
  observe(observation);
}

void MapBuilder::observe(const CObservation::Ptr& observation)
{
  if (const auto odometry = std::dynamic_pointer_cast<CObservationOdometry>(observation))
    slam_->addOdometry(*odometry);
  if (const auto scan = std::dynamic_pointer_cast<CObservation2DRangeScan>(observation))
    T_first_robot_ = slam_->addScan(*scan).T_world_robot;
  if (!scans().empty() && options.enableMapUpdating && isDue(*observation)) insert(observation);
}

bool MapBuilder::isDue(const CObservation& observation) const
{
  if (options.debugForceInsertion ||
      options.alwaysInsertByClass.contains(observation.GetRuntimeClass()))
    return true;
  const auto last = lastInserted_.find(observation.sensorLabel);
  return last == lastInserted_.end() ||
         isFartherThan(last->second, robot(), ICP_options.insertionLinDistance,
                       ICP_options.insertionAngDistance);
}

void MapBuilder::insert(const CObservation::Ptr& observation)
{
  lastInserted_[observation->sensorLabel] = robot();
  const auto frame = CSensoryFrame::Create();
  frame->insert(observation);
  frames_.push_back({scans().size() - 1, frame, robot()});
  insertIntoMaps(frames_.back());
  followLoops();
}

void MapBuilder::insertIntoMaps(const Frame& frame)
{
  const CPose3D pose(toMrpt(T_map_first_ * frame.T_first_robot));
  frame.observations->insertObservationsInto(maps_, pose);
}

/** Fills the maps anew where a loop has moved what they show. */
void MapBuilder::followLoops()
{
  /** Motion of a pose that maps show: less than the noise of a scan. Definition: a fifth of a cell
   * of 5 cm, and what moves a wall so far at 10 m. */
  constexpr double kSeen_m = 0.01, kSeen_rad = 0.001;
  slam_->optimise();
  T_first_robot_.pose = scans().back().T_world_robot.pose;
  bool isMoved = false;
  for (const Frame& frame : frames_)
    isMoved = isMoved || isFartherThan(scans()[frame.scan].T_world_robot.pose, frame.T_first_robot,
                                       kSeen_m, kSeen_rad);
  if (!isMoved) return;
  maps_.clear();
  for (Frame& frame : frames_)
  {
    frame.T_first_robot = scans()[frame.scan].T_world_robot.pose;
    insertIntoMaps(frame);
  }
  MRPT_LOG_DEBUG_STREAM("a loop was closed: " << frames_.size() << " observations inserted anew");
}

Pose2 MapBuilder::robot() const { return T_first_robot_.pose; }

UncertainPose MapBuilder::T_map_robot(const UncertainPose& T_first_robot) const
{
  return conjugated(T_first_robot, T_map_first_, {});
}

mrpt::poses::CPose3DPDF::Ptr MapBuilder::getCurrentPoseEstimation() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return CPose3DPDFGaussian::Create(inSpace(T_map_robot(T_first_robot_)));
}

void MapBuilder::getCurrentlyBuiltMap(CSimpleMap& out_map) const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  out_map.clear();
  for (const Frame& frame : frames_)
  {
    UncertainPose pose = scans()[frame.scan].T_world_robot;
    pose.pose = frame.T_first_robot;
    out_map.insert(CPose3DPDFGaussian::Create(inSpace(T_map_robot(pose))), frame.observations);
  }
}

unsigned int MapBuilder::getCurrentlyBuiltMapSize()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return static_cast<unsigned int>(frames_.size());
}

MapBuilder::MetricMap MapBuilder::getCurrentlyBuiltMetricMap() const
{
  return as<MetricMap>(maps_);
}

void MapBuilder::saveCurrentEstimationToImage(const std::string& file, bool)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (maps_.countMapsByClass<mrpt::maps::COccupancyGridMap2D>() == 0)
  {
    MRPT_LOG_WARN_STREAM("no occupancy grid to draw, '" << file << "' is not written");
    return;
  }
  maps_.mapByClass<mrpt::maps::COccupancyGridMap2D>()->saveAsBitmapFile(file);
}
}  // namespace psmks
