/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <mrpt/poses/CPose3DPDFGaussian.h>
#include <psmks/base/Stopwatch.h>
#include <psmks/matchers/BuiltSolvers.h>
#include <psmks/mrpt/MapMatch.h>
#include <psmks/mrpt/ScanMatcher.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <stdexcept>
#include <string>

IMPLEMENTS_MRPT_OBJECT(ScanMatcher, CObject, psmks)

namespace psmks
{
using mrpt::maps::CMetricMap;
using mrpt::obs::CObservation2DRangeScan;
using mrpt::poses::CPose3DPDF;
using mrpt::poses::CPose3DPDFGaussian;
using mrpt::poses::CPosePDF;
using mrpt::poses::CPosePDFGaussian;
using mrpt::slam::CICP;
using mrpt::slam::TMetricMapAlignmentResult;

namespace
{
/** Makes ScanMatcher known to MRPT's class factory when the library is loaded. MRPT_INITIALIZER
 * would not do: what it runs may come before the class' own record, defined above, is filled. */
[[maybe_unused]] const bool kIsRegistered =
    (mrpt::rtti::registerClass(CLASS_ID(ScanMatcher)), true);

/** The covariance as a prior; none where it is not positive definite. */
std::optional<Eigen::Matrix3d> priorOf(const Eigen::Matrix3d& covariance)
{
  if (!covariance.allFinite() || covariance.llt().info() != Eigen::Success) return std::nullopt;
  return covariance;
}

/** The score on MRPT's scale: linear from 0 to the threshold that MRPT's map builders use, which
 *  stands for the score at which a match is just accepted, and from there to 1. */
double goodnessOf(const MatchResult& match, double acceptScore)
{
  constexpr double kThreshold = 0.4;
  if (!match.usable()) return 0;
  const double goodness =
      match.score < acceptScore
          ? kThreshold * match.score / acceptScore
          : kThreshold + (1 - kThreshold) * (match.score - acceptScore) / (1 - acceptScore);
  return std::clamp(goodness, 0.0, 1.0);
}

/** The goodness of a match that leaves nothing open, else 0. */
double qualityOf(const MatchResult& match, double goodness)
{
  return match.status == MatchStatus::Degenerate ? 0 : goodness;
}

/** Fills the fields that the caller's class of information has. */
void fill(const ScanMatcher::ReturnInfo& info,
          mrpt::optional_ref<TMetricMapAlignmentResult> outInfo)
{
  if (!outInfo.has_value()) return;
  TMetricMapAlignmentResult& out = outInfo.value().get();
  out.executionTime = info.executionTime;
  if (auto* icp = dynamic_cast<CICP::TReturnInfo*>(&out)) *icp = info;
  if (auto* own = dynamic_cast<ScanMatcher::ReturnInfo*>(&out)) *own = info;
}

void requireMap(const CMetricMap* map, const char* name)
{
  if (!map) throw std::invalid_argument(std::string("psmks::ScanMatcher: ") + name + " is null");
}

double square(double x) { return x * x; }

/** Where the current map may lie in the other one: as far from the guess as its points are from its
 * origin, and as far as a match may move it. */
MapRegion regionAbout(const MapPoints& current, const Pose2& T_m1_m2)
{
  /** How far a match of maps moves the guess, at most. Unit: m. Evidence: open. */
  constexpr double kFarthest_m = 1.5;
  double reach_m = 0;
  for (const Eigen::Vector2d& point_m : current.points_m)
    reach_m = std::max(reach_m, point_m.norm());
  return {T_m1_m2.translation(), reach_m + kFarthest_m};
}

/** The pose in space: x, y and yaw are those of the plane, z, pitch and roll those of the guess.
 * The latter are at least as uncertain as the assumption that the robot moves in a plane. */
CPose3DPDFGaussian lifted(const CPosePDFGaussian& plane, const CPose3DPDFGaussian& guess)
{
  constexpr double kPlaneSigma_m = 0.01, kPlaneSigma_rad = degToRad(1);
  constexpr int kZ = 2, kYaw = 3, kPitch = 4, kRoll = 5;
  const Eigen::Vector3d floor(kPlaneSigma_m * kPlaneSigma_m, kPlaneSigma_rad * kPlaneSigma_rad,
                              kPlaneSigma_rad * kPlaneSigma_rad);
  CPose3DPDFGaussian pose;
  pose.mean.setFromValues(plane.mean.x(), plane.mean.y(), guess.mean.z(), plane.mean.phi(),
                          guess.mean.pitch(), guess.mean.roll());
  const int estimated[] = {0, 1, kYaw}, kept[] = {kZ, kPitch, kRoll};
  pose.cov.setZero();
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j) pose.cov(estimated[i], estimated[j]) = plane.cov(i, j);
    pose.cov(kept[i], kept[i]) = std::max(guess.cov(kept[i], kept[i]), floor[i]);
  }
  return pose;
}

/** x, y and yaw of a pose in space, with their covariance. */
CPosePDFGaussian flattened(const CPose3DPDFGaussian& guess)
{
  constexpr int kYaw = 3;
  const int plane[] = {0, 1, kYaw};
  CPosePDFGaussian pose({guess.mean.x(), guess.mean.y(), guess.mean.yaw()});
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) pose.cov(i, j) = guess.cov(plane[i], plane[j]);
  return pose;
}
}  // namespace

ScanMatcher::ScanMatcher() { setLoggerName("psmks::ScanMatcher"); }

ScanMatcher::ScanMatcher(const Options& o) : ScanMatcher() { options = o; }

MatchResult ScanMatcher::solve(const Problem& problem, const UncertainPose& T_m1_m2,
                               SearchScope scope, MatcherWorkspace& workspace) const
{
  const UncertainPose T_ref_cur =
      conjugated(T_m1_m2, problem.T_m1_reference.inverse(), problem.T_m2_current.inverse());
  const Matcher matcher(options.matcher, builtSolvers());
  return matcher.match(problem.reference, problem.current,
                       {T_ref_cur.pose, priorOf(T_ref_cur.covariance)}, workspace, nullptr, scope);
}

ScanMatcher::ReturnInfo ScanMatcher::infoOf(const MatchResult& match) const
{
  ReturnInfo info;
  info.match = match;
  info.nIterations = static_cast<unsigned>(match.iterations);
  info.goodness = goodnessOf(match, options.matcher.joint.acceptScore);
  info.quality = qualityOf(match, info.goodness);
  return info;
}

const Scan& ScanMatcher::planarScan(const CObservation2DRangeScan& observation,
                                    ScanConverter& converter, Scan& scan) const
{
  const double tilt_rad = sensorMounting(observation).tilt_rad;
  if (tilt_rad <= options.maxTilt_rad)
  {
    converter.convert(observation, scan);
    return scan;
  }
  MRPT_LOG_WARN_STREAM("scan of sensor '" << observation.sensorLabel << "' is tilted by "
                                          << radToDeg(tilt_rad) << " deg, max_tilt_deg is "
                                          << radToDeg(options.maxTilt_rad));
  return scan = Scan();
}

CPosePDFGaussian::Ptr ScanMatcher::align(const CObservation2DRangeScan& reference,
                                         const CObservation2DRangeScan& current,
                                         const CPosePDFGaussian& initial, ReturnInfo* info)
{
  Stopwatch watch;
  LendingPool<Buffers>::Loan loan(buffers_);
  Buffers& buffers = *loan;
  const Problem problem{planarScan(reference, buffers.referenceConverter, buffers.reference),
                        planarScan(current, buffers.currentConverter, buffers.current),
                        sensorMounting(reference).T_robot_sensor,
                        sensorMounting(current).T_robot_sensor};
  ReturnInfo found =
      infoOf(solve(problem, toUncertainPose(initial), SearchScope::Full, buffers.workspace));
  report(found.match);
  found.executionTime = watch.lap_s();
  if (info) *info = found;
  return CPosePDFGaussian::Create(toMrpt(conjugated({found.match.T_ref_cur, found.match.covariance},
                                                    problem.T_m1_reference, problem.T_m2_current)));
}

std::optional<Pose2> ScanMatcher::poseOfViews(const MapPoints& m1, const MapPoints& m2,
                                              const Pose2& T_m1_m2,
                                              MatcherWorkspace& workspace) const
{
  const ViewOptions& view = options.view;
  const BeamGrid grid = BeamGrid::centered(view.fieldOfView_rad, view.rays);
  const Pose2 T_m1_sensor = T_m1_m2 * view.T_map_sensor;
  const Scan reference = polarView(m1, T_m1_sensor, grid, view.maxGap_m);
  const Scan current = polarView(m2, view.T_map_sensor, grid, view.maxGap_m);
  const MatchResult match = solve({reference, current, T_m1_sensor, view.T_map_sensor}, {T_m1_m2},
                                  SearchScope::NearGuess, workspace);
  if (!match.usable()) return std::nullopt;
  return T_m1_sensor * match.T_ref_cur * view.T_map_sensor.inverse();
}

MatchResult ScanMatcher::matchMaps(const CMetricMap& m1, const CMetricMap& m2,
                                   const UncertainPose& guess)
{
  LendingPool<Buffers>::Loan loan(buffers_);
  Buffers& buffers = *loan;
  const MapPoints current = pointsOf(m2);
  MapPoints reference = pointsOf(m1, regionAbout(current, guess.pose));
  if (reference.points_m.empty()) reference = pointsOf(m1);

  const Eigen::DiagonalMatrix<double, 3> open(
      square(options.guessSigma_m), square(options.guessSigma_m), square(options.guessSigma_rad));
  return MapMatch(options, options.matcher.joint, open.toDenseMatrix())
      .match(reference, current, {guess.pose, priorOf(guess.covariance)}, buffers.field,
             [&] { return poseOfViews(reference, current, guess.pose, buffers.workspace); });
}

CPosePDF::Ptr ScanMatcher::AlignPDF(const CMetricMap* m1, const CMetricMap* m2,
                                    const CPosePDFGaussian& initialEstimationPDF,
                                    mrpt::optional_ref<TMetricMapAlignmentResult> outInfo)
{
  requireMap(m1, "m1");
  requireMap(m2, "m2");
  Stopwatch watch;
  ReturnInfo found = infoOf(matchMaps(*m1, *m2, toUncertainPose(initialEstimationPDF)));
  report(found.match);
  found.executionTime = watch.lap_s();
  fill(found, outInfo);
  return CPosePDFGaussian::Create(
      toMrpt(UncertainPose{found.match.T_ref_cur, found.match.covariance}));
}

CPose3DPDF::Ptr ScanMatcher::Align3DPDF(const CMetricMap* m1, const CMetricMap* m2,
                                        const CPose3DPDFGaussian& initialEstimationPDF,
                                        mrpt::optional_ref<TMetricMapAlignmentResult> outInfo)
{
  const auto& guess = initialEstimationPDF.mean;
  const double tilt_rad = std::max(std::abs(guess.pitch()), std::abs(guess.roll()));
  if (!(tilt_rad <= options.maxTilt_rad))
    throw std::invalid_argument(
        "psmks::ScanMatcher: only poses in the plane can be matched, but pitch or roll of the "
        "guess "
        "is " +
        std::to_string(radToDeg(tilt_rad)) + " deg, max_tilt_deg is " +
        std::to_string(radToDeg(options.maxTilt_rad)));

  const auto plane = AlignPDF(m1, m2, flattened(initialEstimationPDF), outInfo);
  return CPose3DPDFGaussian::Create(
      lifted(dynamic_cast<const CPosePDFGaussian&>(*plane), initialEstimationPDF));
}

void ScanMatcher::report(const MatchResult& match) const
{
  if (match.usable())
    MRPT_LOG_DEBUG_STREAM(match.report());
  else
    MRPT_LOG_WARN_STREAM("the guess is kept: " << match.report());
}
}  // namespace psmks
