/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/core/Matcher.h>
#include <psmks/eval/RangeScatter.h>
#include <psmks/geometry/Scan.h>
#include <psmks/motion/Deskewer.h>

#include <optional>
#include <string>
#include <vector>

namespace psmks
{
/** What the scans of a log tell of their scanner, in three levels: the ray, the scan along its
 * rays, and the scan as a whole. */
struct SensorReport
{
  /** What one kind of evidence tells of the rays. */
  struct Rays
  {
    std::vector<RangeScatter::Bin> bins;
    RangeNoise noise;
    double raysPerReading = 1;  //!< as SegmentedScan::raysPerReading
    int scans = 0;
  };

  int scans = 0;
  Rays walls;     //!< residuals of rays on straight walls, with the unevenness of the walls
  Rays standing;  //!< differences of the same ray between scans, while the scanner stood

  /** By how much ranges of rays with an odd number exceed those with an even one, on walls. */
  struct HalfScans
  {
    double oddMinusEven_m = 0;
    double sigma_m = 0;  //!< standard deviation of that mean
  };
  HalfScans halfScans;     //!< of the scans that add() was given
  HalfScans rawHalfScans;  //!< of those that compareTurns() was given

  /** How much later odd rays are cast than even ones, by what the scans shift between them for
   * each metre a second, and each radian a second, that the odometry measured. Errors of the
   * odometry make it too small. About 0 for a scanner that takes its scans in one turn. */
  struct OddRayDelay
  {
    double byDriving_s = 0, byDrivingSigma_s = 0;
    double byTurning_s = 0, byTurningSigma_s = 0;
    int scans = 0;
  };
  OddRayDelay oddRayDelay;

  /** By how much whole scans err besides the noise of their rays: from the scatter of the poses of
   * a standing scanner. None where it never stood. */
  std::optional<WholeScanOptions> wholeScan;
  double poseScatter_m = 0, poseScatter_rad = 0;  //!< from scan to scan, of a standing scanner

  /** The evidence that says most of the scanner itself: that of standing, of at least 100 scans. */
  const Rays& best() const;

  /** An option file that states the noise by best(), for `--sensor-file`; that of whole scans
   * where the scanner stood long enough. */
  std::string sensorFile() const;
};

/** Looks at the scans of a log one after the other.
 *
 * A scanner stands while its scans match the first of a stretch to within 1 cm and 1 degree, over
 * at least 20 scans. There each ray is held against itself one scan before, and the poses of
 * successive scans against each other. A robot that creeps by less is taken to stand. */
class SensorSurvey
{
 public:
  /** @param options of the segmentation that finds the walls and of the matches */
  explicit SensorSurvey(const MatcherOptions& options) : matcher_(options) {}

  /** Adds the next scan of the log. */
  void add(const Scan& scan);

  /** Adds a scan as it came, before it was deskewed, for the comparison of its odd with its even
   * rays.
   *  @param velocity of the scanner, by odometry; a scan without one, or from a scanner at rest,
   *  says nothing of delays */
  void compareTurns(const Scan& raw, const PlanarVelocity& velocity);

  /** What the scans so far tell. The stretch that the scanner stands in ends here. */
  SensorReport report();

 private:
  struct Stretch
  {
    SegmentedScan first, last;
    std::vector<Pose2> steps;              //!< from scan to scan
    std::vector<Eigen::Vector3d> claimed;  //!< variances that the matches of the steps claim
    std::vector<std::vector<double>> differences_m;  //!< of the rays, scan by scan
    std::vector<std::vector<double>> ranges_m;
  };

  /** Sums over scans of a regression through the origin. */
  struct Regression
  {
    double squares = 0, products = 0, responses = 0;
    int count = 0;

    void add(double cause, double response);
    double slope() const;
    double sigma() const;
  };

  void addWalls(const SegmentedScan& scan);
  void follow(const SegmentedScan& scan);
  void finish(const Stretch& stretch);
  void addDifferences(const std::vector<double>& ranges_m,
                      const std::vector<double>& differences_m);

  Matcher matcher_;
  MatcherWorkspace workspace_;
  SegmentedScan current_;
  std::optional<Stretch> stretch_;

  int scans_ = 0, scansWithWalls_ = 0, standingScans_ = 0;
  RangeScatter wallScatter_, standingScatter_;
  std::vector<double> readings_;                            //!< raysPerReading of each scan
  std::vector<double> oddMinusEven_m_, rawOddMinusEven_m_;  //!< of each wall
  Regression driving_, turning_;
  Deskewer deskewer_;
  double products_m2_ = 0, squares_m2_ = 0;  //!< of differences of neighbouring rays
  std::vector<Eigen::Vector3d> steps_, claimed_;
};
}  // namespace psmks
