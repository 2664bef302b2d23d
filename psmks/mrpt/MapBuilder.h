/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <mrpt/config/CLoadableOptions.h>
#include <mrpt/obs/CObservation.h>
#include <mrpt/slam/CMetricMapBuilder.h>
#include <psmks/mrpt/ObservationSlam.h>

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace psmks
{
/** A map builder of MRPT on the SLAM of psmks, in place of mrpt::slam::CMetricMapBuilderICP: scans
 * are matched against keyframes, loops are closed, and any metric maps and a CSimpleMap are filled.
 *
 *     psmks::MapBuilder builder;
 *     builder.loadOptions(mrpt::config::CConfigFile("icp-slam.ini"), "MappingApplication");
 *     builder.initialize();
 *     builder.processActionObservation(action, frame);
 *
 *  - Every CObservation2DRangeScan is used to localise. Where the robot has moved or turned so far
 *    since the last insertion of its sensor, an observation of any kind is inserted into the maps.
 *  - When a loop that closes moves earlier poses, the metric maps are cleared and filled anew from
 *    the moved poses, so that they always show what the CSimpleMap holds. All poses are optimised
 *    with each insertion, which takes the longer the longer the log.
 *  - The frame of the maps is that of the robot at the first scan, or the one of `x0` and of the
 *    initial map of initialize(). The scans of an initial map are given to the SLAM first, with the
 *    motions between their poses as odometry.
 *  - Scans and odometry never throw. Where no match is usable, the odometry carries on.
 *  - Threads may call its functions at the same time. The pointer that getCurrentlyBuiltMetricMap()
 *    returns is for the thread that processes observations. */
class MapBuilder : public mrpt::slam::CMetricMapBuilder
{
 public:
  /** Of the fields of CMetricMapBuilderICP::TConfigParams those that steer the insertion. The keys
   * of an ini file have their names, angles in degrees. */
  struct TConfigParams : public mrpt::config::CLoadableOptions
  {
    double insertionLinDistance = 1.0;                        //!< m
    double insertionAngDistance = degToRad(30);               //!< rad
    mrpt::maps::TSetOfMetricMapInitializers mapInitializers;  //!< which maps are filled

    /** @name Fields without a counterpart: every scan is matched, against scans
     *  @{ */
    bool matchAgainstTheGrid = false;
    double localizationLinDistance = 0.2, localizationAngDistance = degToRad(30);
    double minICPgoodnessToAccept = 0.4;
    /** @} */

    void loadFromConfigFile(const mrpt::config::CConfigFileBase& source,
                            const std::string& section) override;
  };

  MapBuilder();

  TConfigParams ICP_options;             //!< as CMetricMapBuilderICP calls them
  ObservationSlamOptions psmks_options;  //!< taken over by initialize()

  /** Loads ICP_options from the section of icp-slam's ini files, and the options of matching from
   *  the sections `[PSMKS.stage]`, one for each stage, beside it, where there are any.
   *  @throws OptionError for options of psmks that cannot be accepted */
  void loadOptions(const mrpt::config::CConfigFileBase& file,
                   const std::string& section = "MappingApplication");

  /** Begins anew. Without a call, the first observation makes one with default arguments.
   *  @param x0 where the robot is in the frame of the maps; null: at the last pose of the initial
   *  map, or at the origin
   *  @throws OptionError for psmks_options that the matcher does not accept */
  void initialize(const mrpt::maps::CSimpleMap& initialMap = mrpt::maps::CSimpleMap(),
                  const mrpt::poses::CPosePDF* x0 = nullptr) override;

  /** Where the robot is, a CPose3DPDFGaussian in the plane. */
  mrpt::poses::CPose3DPDF::Ptr getCurrentPoseEstimation() const override;

  /** A motion and what was observed after it. */
  void processActionObservation(mrpt::obs::CActionCollection& action,
                                mrpt::obs::CSensoryFrame& frame) override;

  /** One observation: odometry, a scan, or any other that maps can hold. */
  void processObservation(const mrpt::obs::CObservation::Ptr& observation);

  /** The inserted observations with the poses of the robot. */
  void getCurrentlyBuiltMap(mrpt::maps::CSimpleMap& out_map) const override;
  unsigned int getCurrentlyBuiltMapSize() override;

  /** A pointer or a reference, as the version of MRPT has it. */
  using MetricMap = decltype(std::declval<const CMetricMapBuilder&>().getCurrentlyBuiltMetricMap());
  MetricMap getCurrentlyBuiltMetricMap() const override;

  /** Draws the first occupancy grid of the maps; without one nothing is written, with a warning.
   *  @param file .png, .jpg or .bmp
   *  @param formatEMF_BMP has no effect */
  void saveCurrentEstimationToImage(const std::string& file, bool formatEMF_BMP = true) override;

  /** The scans with their poses and matches in the frame of the first one, as
   *  ObservationSlam::scans(). Not to be called before initialize() or the first observation. */
  const std::vector<PosedScan>& scans() const { return slam_->scans(); }

 private:
  /** Observations that are part of the map, with the scan whose pose they move with. */
  struct Frame
  {
    std::size_t scan;
    mrpt::obs::CSensoryFrame::Ptr observations;
    Pose2 T_first_robot;  //!< where the maps have it now
  };

  void restart();
  void addKnownFrames(const mrpt::maps::CSimpleMap& known);
  void observe(const mrpt::obs::CObservation::Ptr& observation);
  bool isDue(const mrpt::obs::CObservation& observation) const;
  void insert(const mrpt::obs::CObservation::Ptr& observation);
  void insertIntoMaps(const Frame& frame);
  void followLoops();
  Pose2 robot() const;
  UncertainPose T_map_robot(const UncertainPose& T_first_robot) const;

  mutable std::mutex mutex_;
  std::unique_ptr<ObservationSlam> slam_;  //!< null until initialize()
  Pose2 T_map_first_;                      //!< the robot at the first scan in the frame of the maps
  UncertainPose T_first_robot_;            //!< now
  std::vector<Frame> frames_;
  std::map<std::string, Pose2> lastInserted_;  //!< by the label of the sensor
  mrpt::maps::CMultiMetricMap maps_;
};
}  // namespace psmks
