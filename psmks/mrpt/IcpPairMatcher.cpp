/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/poses/CPosePDFGaussian.h>
#include <psmks/core/Preprocessing.h>
#include <psmks/core/Stopwatch.h>
#include <psmks/mrpt/Convert.h>
#include <psmks/mrpt/IcpPairMatcher.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
using mrpt::maps::CSimplePointsMap;
using mrpt::obs::CObservation2DRangeScan;
using mrpt::poses::CPosePDFGaussian;

namespace
{
/** An observation whose middle bearing is its x axis, as MRPT's are; the mounting turns it back. */
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

CSimplePointsMap toPointsMap(const Scan& scan)
{
  SegmentedScan cleaned;
  cleanScan(scan, PreprocessingOptions(), cleaned);
  CSimplePointsMap map;
  if (cleaned.rays() > 1) map.loadFromRangeScan(toObservation(cleaned));
  return map;
}

MatchResult failed(MatchStatus status, const Guess& guess)
{
  MatchResult result;
  result.status = status;
  result.T_ref_cur = guess.T_ref_cur;
  if (guess.covariance) result.covariance = *guess.covariance;
  return result;
}
}  // namespace

IcpPairMatcher::IcpPairMatcher(std::string name, mrpt::slam::TICPAlgorithm algorithm)
    : name_(std::move(name))
{
  icp_.options.ICP_algorithm = algorithm;
}

MatchResult IcpPairMatcher::match(const Scan& reference, const Scan& current, const Guess& guess)
{
  Stopwatch stopwatch;
  const CSimplePointsMap referenceMap = toPointsMap(reference);
  const CSimplePointsMap currentMap = toPointsMap(current);
  const double maps_s = stopwatch.lap_s();
  if (referenceMap.empty() || currentMap.empty() || !guess.T_ref_cur.isFinite())
    return failed(MatchStatus::InvalidInput, guess);

  mrpt::slam::CICP::TReturnInfo info;
  const auto pdf =
      icp_.AlignPDF(&referenceMap, &currentMap, CPosePDFGaussian(toMrpt(guess.T_ref_cur)), info);
  CPosePDFGaussian estimate;
  estimate.copyFrom(*pdf);

  MatchResult result = failed(MatchStatus::NoImprovement, guess);
  if (info.goodness > kAcceptedGoodness)
  {
    const bool stopped = info.nIterations < icp_.options.maxIterations;
    result.status = stopped ? MatchStatus::Converged : MatchStatus::MaxIterations;
    result.T_ref_cur = toPose2(estimate.mean);
    if (!estimate.cov.asEigen().isZero()) result.covariance = estimate.cov.asEigen();
  }
  result.score = std::min(1.0, info.goodness);
  result.associations =
      static_cast<int>(std::lround(info.goodness * static_cast<double>(currentMap.size()) /
                                   icp_.options.corresponding_points_decimation));
  result.iterations = static_cast<int>(info.nIterations);
  result.times.segmentation_s = maps_s;
  result.times.refinement_s = stopwatch.lap_s();
  return result;
}
}  // namespace psmks
