/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/poses/CPosePDFGaussian.h>
#include <mrpt/slam/CICP.h>
#include <psmks/base/Stopwatch.h>
#include <psmks/matchers/PairMatcherRegistration.h>
#include <psmks/mrpt/Convert.h>
#include <psmks/segmentation/Preprocessing.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace psmks
{
namespace
{
using mrpt::maps::CSimplePointsMap;
using mrpt::obs::CObservation2DRangeScan;
using mrpt::poses::CPosePDFGaussian;
using mrpt::slam::CICP;
using mrpt::slam::TICPAlgorithm;

/** MRPT's map builder refuses a match whose share of correspondences is not above this. */
constexpr double kAcceptedGoodness = 0.40;

/** Parameters of MRPT's ICP and of the point maps that it is given. The defaults are MRPT's. */
struct IcpSettings
{
  CICP::TConfigParams icp;
  float referenceSpacing_m = CSimplePointsMap::TInsertionOptions().minDistBetweenLaserPoints;
  float currentSpacing_m = referenceSpacing_m;
};

IcpSettings defaultSettings(TICPAlgorithm algorithm)
{
  IcpSettings settings;
  settings.icp.ICP_algorithm = algorithm;
  return settings;
}

/** The parameters in the files that come with MRPT's icp-slam, icp-slam_demo_classic.ini and
 *  icp-slam_demo_LM.ini, where points of the map are 5 cm apart and points of the scan 2 cm. */
IcpSettings icpSlamSettings(TICPAlgorithm algorithm)
{
  IcpSettings settings = defaultSettings(algorithm);
  settings.referenceSpacing_m = 0.05F;
  settings.icp.maxIterations = 80;
  settings.icp.thresholdDist = 0.3;
  settings.icp.thresholdAng = degToRad(5);
  settings.icp.ALFA = 0.8;
  settings.icp.smallestThresholdDist = 0.05;
  settings.icp.onlyUniqueRobust = algorithm == mrpt::slam::icpClassic;
  return settings;
}

/** Parameters for accuracy at any cost in time: every point is used, the gate is wide at first and
 *  narrow in the end. The covariance is the one that costs least. */
IcpSettings tunedSettings(TICPAlgorithm algorithm)
{
  IcpSettings settings = defaultSettings(algorithm);
  settings.referenceSpacing_m = settings.currentSpacing_m = 0;
  settings.icp.corresponding_points_decimation = 1;
  settings.icp.maxIterations = 100;
  settings.icp.thresholdDist = 1.0;
  settings.icp.thresholdAng = degToRad(3);
  settings.icp.ALFA = 0.5;
  settings.icp.smallestThresholdDist = 0.03;
  settings.icp.ICP_covariance_method = mrpt::slam::icpCovLinealMSE;
  return settings;
}

/** The scan as an observation. MRPT's observations have their middle bearing along the x axis of
 *  the sensor; the sensor pose turns the scan back to where it points. */
CObservation2DRangeScan toObservation(const SegmentedScan& scan)
{
  const std::size_t rays = scan.range_m.size();
  const double aperture_rad = scan.grid.increment_rad() * (static_cast<double>(rays) - 1);
  CObservation2DRangeScan observation;
  observation.rightToLeft = true;
  observation.aperture = static_cast<float>(aperture_rad);
  observation.sensorPose.setYawPitchRoll(scan.grid.firstBearing_rad() + aperture_rad / 2, 0, 0);
  observation.resizeScan(rays);
  for (std::size_t i = 0; i < rays; ++i)
  {
    observation.setScanRange(i, static_cast<float>(scan.range_m[i]));
    observation.setScanRangeValidity(i, scan.valid[i] != 0);
  }
  return observation;
}

/** The valid rays of a scan as points; none closer to another than the spacing. */
CSimplePointsMap toPointsMap(const Scan& scan, float spacing_m)
{
  SegmentedScan cleaned;
  cleanScan(scan, PreprocessingOptions(), cleaned);
  CSimplePointsMap map;
  map.insertionOptions.minDistBetweenLaserPoints = spacing_m;
  if (cleaned.rays() > 1) map.loadFromRangeScan(toObservation(cleaned));
  return map;
}

/** mrpt::slam::CICP on two point maps, each made of a scan.
 *
 *  A match whose share of correspondences is not above kAcceptedGoodness is a failure,
 *  NoImprovement. `score` is that share, at most 1, and times.segmentation_s the time of making the
 *  maps. */
class IcpPairMatcher : public PairMatcher
{
 public:
  IcpPairMatcher(std::string name, const IcpSettings& settings)
      : name_(std::move(name)), settings_(settings), icp_(settings.icp)
  {
  }

  std::string name() const override { return name_; }

  MatchResult match(const Scan& reference, const Scan& current, const Guess& guess) override
  {
    Stopwatch stopwatch;
    const CSimplePointsMap referenceMap = toPointsMap(reference, settings_.referenceSpacing_m);
    const CSimplePointsMap currentMap = toPointsMap(current, settings_.currentSpacing_m);
    const double maps_s = stopwatch.lap_s();
    if (referenceMap.empty() || currentMap.empty() || !guess.T_ref_cur.isFinite())
      return keptGuess(MatchStatus::InvalidInput, guess);

    MatchResult result = align(referenceMap, currentMap, guess);
    result.times.segmentation_s = maps_s;
    result.times.refinement_s = stopwatch.lap_s();
    return result;
  }

 private:
  MatchResult align(const CSimplePointsMap& reference, const CSimplePointsMap& current,
                    const Guess& guess)
  {
    CICP::TReturnInfo info;
    CPosePDFGaussian estimate;
    estimate.copyFrom(
        *icp_.AlignPDF(&reference, &current, CPosePDFGaussian(toMrpt(guess.T_ref_cur)), info));

    MatchResult result = keptGuess(MatchStatus::NoImprovement, guess);
    if (info.goodness > kAcceptedGoodness)
    {
      const bool stopped = info.nIterations < icp_.options.maxIterations;
      result.status = stopped ? MatchStatus::Converged : MatchStatus::MaxIterations;
      result.T_ref_cur = toPose2(estimate.mean);
      if (!estimate.cov.asEigen().isZero()) result.covariance = estimate.cov.asEigen();
      settleCovariance(guess, result);
    }
    result.score = std::min(1.0, info.goodness);
    result.associations = pairedPoints(info, current.size());
    result.iterations = static_cast<int>(info.nIterations);
    return result;
  }

  /** How many points of the current map found a partner. */
  int pairedPoints(const CICP::TReturnInfo& info, std::size_t points) const
  {
    const double tried = static_cast<double>(points) / icp_.options.corresponding_points_decimation;
    return static_cast<int>(std::lround(info.goodness * tried));
  }

  std::string name_;
  IcpSettings settings_;
  CICP icp_;
};

PairMatcherRegistration registration(const std::string& name, int place,
                                     const std::string& description, const IcpSettings& settings)
{
  return PairMatcherRegistration({name, description, PairMatcherFamily::Icp, place,
                                  [settings](const std::string& asked, const MatcherOptions&)
                                  { return std::make_unique<IcpPairMatcher>(asked, settings); }});
}

using mrpt::slam::icpClassic;
using mrpt::slam::icpLevenbergMarquardt;

const std::array<PairMatcherRegistration, 6> kRegistrations{
    registration("icp-classic", 0, "MRPT's ICP, its default parameters",
                 defaultSettings(icpClassic)),
    registration("icp-classic-icpslam", 1, "MRPT's ICP, the parameters of icp-slam",
                 icpSlamSettings(icpClassic)),
    registration("icp-classic-tuned", 2, "MRPT's ICP, tuned for accuracy",
                 tunedSettings(icpClassic)),
    registration("icp-lm", 3, "MRPT's ICP by Levenberg-Marquardt, its default parameters",
                 defaultSettings(icpLevenbergMarquardt)),
    registration("icp-lm-icpslam", 4, "MRPT's ICP by Levenberg-Marquardt, those of icp-slam",
                 icpSlamSettings(icpLevenbergMarquardt)),
    registration("icp-lm-tuned", 5, "MRPT's ICP by Levenberg-Marquardt, tuned for accuracy",
                 tunedSettings(icpLevenbergMarquardt))};
}  // namespace
}  // namespace psmks
