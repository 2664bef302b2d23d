/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/poses/CPosePDFGaussian.h>
#include <psmks/mrpt/Convert.h>
#include <psmks/mrpt/IcpPairMatcher.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace psmks
{
using mrpt::maps::CSimplePointsMap;
using mrpt::obs::CObservation2DRangeScan;
using mrpt::poses::CPosePDFGaussian;

namespace
{
using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

bool isReturn(const Scan& scan, std::size_t ray)
{
  const double range_m = scan.range_m[ray];
  const bool flagged = !scan.valid.empty() && !scan.valid[ray];
  const bool beyond = scan.maxRange_m > 0 && range_m >= scan.maxRange_m;
  return !flagged && !beyond && std::isfinite(range_m) && range_m > 0;
}

/** An observation whose middle bearing is its x axis, as MRPT's are; the mounting turns it back. */
CObservation2DRangeScan toObservation(const Scan& scan)
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
    observation.setScanRangeValidity(i, isReturn(scan, i));
  }
  return observation;
}

CSimplePointsMap toPointsMap(const Scan& scan)
{
  CSimplePointsMap map;
  if (scan.range_m.size() > 1) map.loadFromRangeScan(toObservation(scan));
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
  const auto start = Clock::now();
  const CSimplePointsMap referenceMap = toPointsMap(reference);
  const CSimplePointsMap currentMap = toPointsMap(current);
  const double maps_s = secondsSince(start);
  if (referenceMap.empty() || currentMap.empty() || !guess.T_ref_cur.isFinite())
    return failed(MatchStatus::InvalidInput, guess);

  const auto alignStart = Clock::now();
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
  result.times.refinement_s = secondsSince(alignStart);
  return result;
}
}  // namespace psmks
