/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/eval/SensorSurvey.h>
#include <psmks/eval/Statistics.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace psmks
{
namespace
{
/** A pose up to which a scanner stands. Definition: below what a robot that drives moves within a
 * few scans. */
constexpr double kStanding_m = 0.01, kStanding_rad = degToRad(1);

/** Fewest scans of a stretch in which a scanner stands. Unit: scans. Definition: at a speed of 5
 * mm/s and ten scans a second a robot leaves the place within as many. */
constexpr std::size_t kFewestScans = 20;

/** Differences of a ray beyond which it met something else. Definition: ten times the noise of a
 * common scanner. */
constexpr double kElsewhere_m = 0.2;

/** Fewest rays of a wall whose residuals count. Unit: rays. Definition: the fit of a line takes two
 * of them. */
constexpr int kFewestRays = 12;

/** Standard deviation of normal numbers over the median of their absolute values. Unit: ratio.
 * Definition: of the normal distribution. */
constexpr double kNormalRatio = 1.4826;

bool isAtRest(const Pose2& T)
{
  return T.translation().norm() < kStanding_m && std::abs(T.phi_rad) < kStanding_rad;
}

double rms(const std::vector<Eigen::Vector3d>& rows, int from, int columns)
{
  double sum = 0;
  for (const Eigen::Vector3d& row : rows) sum += row.segment(from, columns).squaredNorm();
  return std::sqrt(sum / (static_cast<double>(rows.size()) * columns));
}

/** Adds the difference of odd and even rays of each wall. */
void compareHalves(const SegmentedScan& scan, std::vector<double>& oddMinusEven_m)
{
  const std::size_t walls = scan.segments.size();
  std::vector<double> sums_m(2 * walls, 0);
  std::vector<int> counts(2 * walls, 0);
  for (int ray = 0; ray < scan.rays(); ++ray)
  {
    const auto i = static_cast<std::size_t>(ray);
    if (scan.segmentOfRay[i] < 0) continue;
    const std::size_t half = 2 * static_cast<std::size_t>(scan.segmentOfRay[i]) + i % 2;
    sums_m[half] += scan.range_m[i] - scan.denoisedRange_m(ray);
    ++counts[half];
  }
  for (std::size_t w = 0; w < walls; ++w)
  {
    const int even = counts[2 * w], odd = counts[2 * w + 1];
    if (even + odd < kFewestRays || even == 0 || odd == 0) continue;
    oddMinusEven_m.push_back(sums_m[2 * w + 1] / odd - sums_m[2 * w] / even);
  }
}

SensorReport::HalfScans halfScansOf(const std::vector<double>& oddMinusEven_m)
{
  if (oddMinusEven_m.empty()) return {};
  const double middle_m = median(oddMinusEven_m);
  std::vector<double> apart_m = oddMinusEven_m;
  for (double& value_m : apart_m) value_m = std::abs(value_m - middle_m);
  return {middle_m,
          kNormalRatio * median(apart_m) / std::sqrt(static_cast<double>(apart_m.size()))};
}

/** What is missing of a variance of differences between two scans, as a standard deviation of one.
 */
double missingSigma(double scatter, double claimedVariance)
{
  return std::sqrt(std::max(0.0, (scatter * scatter - claimedVariance) / 2));
}
}  // namespace

void SensorSurvey::add(const Scan& scan)
{
  ++scans_;
  matcher_.segment(scan, workspace_, current_);
  addWalls(current_);
  compareHalves(current_, oddMinusEven_m_);
  follow(current_);
}

void SensorSurvey::compareTurns(const Scan& raw, const PlanarVelocity& velocity)
{
  matcher_.segment(raw, workspace_, current_);
  compareHalves(current_, rawOddMinusEven_m_);
  if (velocity.isZero() || !velocity.isFinite()) return;

  /** Standard deviation of the motion from turn to turn. Definition: as good as unknown. */
  constexpr double kVague_m = 0.1, kVague_rad = degToRad(5);
  Scan inTwoTurns = raw;
  inTwoTurns.sweepDuration_s = 0;
  inTwoTurns.interleavedTurns = 2;
  inTwoTurns.turn_s = 1;
  const Eigen::Vector3d vague(kVague_m, kVague_m, kVague_rad);
  const PlanarVelocity perTurn =
      deskewer_.fittedVelocity(inTwoTurns, {}, vague.cwiseAbs2().asDiagonal());
  driving_.add(velocity.x_m_s, perTurn.x_m_s);
  driving_.add(velocity.y_m_s, perTurn.y_m_s);
  turning_.add(velocity.phi_rad_s, perTurn.phi_rad_s);
}

void SensorSurvey::Regression::add(double cause, double response)
{
  squares += cause * cause;
  products += cause * response;
  responses += response * response;
  ++count;
}

double SensorSurvey::Regression::slope() const { return squares > 0 ? products / squares : 0; }

double SensorSurvey::Regression::sigma() const
{
  if (count < 2 || squares <= 0) return 0;
  const double unexplained = std::max(0.0, responses - slope() * products);
  return std::sqrt(unexplained / (count - 1) / squares);
}

/** The residuals of the rays on walls. */
void SensorSurvey::addWalls(const SegmentedScan& scan)
{
  if (scan.segments.empty()) return;
  ++scansWithWalls_;
  readings_.push_back(scan.raysPerReading);
  for (std::size_t s = 0; s < scan.segments.size(); ++s)
  {
    const Segment& segment = scan.segments[s];
    if (segment.rays < kFewestRays) continue;
    const double unbiased = std::sqrt(segment.rays / (segment.rays - 2.0));
    for (int ray = 0; ray < scan.rays(); ++ray)
    {
      if (scan.segmentOfRay[static_cast<std::size_t>(ray)] != static_cast<int>(s)) continue;
      const double range_m = scan.range_m[static_cast<std::size_t>(ray)];
      wallScatter_.add(range_m, unbiased * (range_m - scan.denoisedRange_m(ray)));
    }
  }
}

/** Goes on with the stretch in which the scanner stands, or begins another one. */
void SensorSurvey::follow(const SegmentedScan& scan)
{
  if (stretch_)
  {
    const MatchResult toFirst = matcher_.match(stretch_->first, scan, Guess{}, workspace_);
    const MatchResult step = matcher_.match(stretch_->last, scan, Guess{}, workspace_);
    const bool isSameGrid = stretch_->last.rays() == scan.rays();
    if (isSameGrid && toFirst.usable() && step.usable() && isAtRest(toFirst.T_ref_cur))
    {
      std::vector<double> differences_m;
      for (int ray = 0; ray < scan.rays(); ++ray)
      {
        const auto i = static_cast<std::size_t>(ray);
        const bool bothReturn = scan.isValid(ray) && stretch_->last.isValid(ray);
        differences_m.push_back(bothReturn ? scan.range_m[i] - stretch_->last.range_m[i]
                                           : std::nan(""));
      }
      stretch_->steps.push_back(step.T_ref_cur);
      stretch_->claimed.push_back(step.covariance.diagonal());
      stretch_->differences_m.push_back(std::move(differences_m));
      stretch_->ranges_m.push_back(scan.range_m);
      stretch_->last = scan;
      return;
    }
    finish(*stretch_);
  }
  stretch_ = Stretch{scan, scan, {}, {}, {}, {}};
}

/** Counts a stretch if it is long enough. */
void SensorSurvey::finish(const Stretch& stretch)
{
  if (stretch.steps.size() < kFewestScans) return;
  standingScans_ += static_cast<int>(stretch.steps.size());
  for (std::size_t s = 0; s < stretch.steps.size(); ++s)
  {
    const Pose2& step = stretch.steps[s];
    steps_.emplace_back(step.x_m, step.y_m, step.phi_rad);
    claimed_.push_back(stretch.claimed[s]);
    addDifferences(stretch.ranges_m[s], stretch.differences_m[s]);
  }
}

/** Each difference has the noise of two ranges. */
void SensorSurvey::addDifferences(const std::vector<double>& ranges_m,
                                  const std::vector<double>& differences_m)
{
  double before_m = std::nan("");
  for (std::size_t ray = 0; ray < differences_m.size(); ++ray)
  {
    const double difference_m = differences_m[ray];
    const bool counts = std::abs(difference_m) < kElsewhere_m;
    if (counts) standingScatter_.add(ranges_m[ray], difference_m / std::sqrt(2.0));
    if (counts && std::isfinite(before_m))
    {
      products_m2_ += difference_m * before_m;
      squares_m2_ += (difference_m * difference_m + before_m * before_m) / 2;
    }
    before_m = counts ? difference_m : std::nan("");
  }
}

SensorReport SensorSurvey::report()
{
  if (stretch_) finish(*stretch_);
  stretch_.reset();
  SensorReport report;
  report.scans = scans_;
  report.walls = {wallScatter_.bins(), wallScatter_.noise(),
                  readings_.empty() ? 1 : median(readings_), scansWithWalls_};
  report.halfScans = halfScansOf(oddMinusEven_m_);
  report.rawHalfScans = halfScansOf(rawOddMinusEven_m_);
  report.oddRayDelay = {driving_.slope(), driving_.sigma(), turning_.slope(), turning_.sigma(),
                        turning_.count};
  if (standingScans_ == 0) return report;

  /** Largest correlation of neighbouring rays that counts. Unit: none. Definition: means of ten
   * rays. */
  constexpr double kLargest = 0.9;
  const double correlation = squares_m2_ > 0 ? products_m2_ / squares_m2_ : 0;
  report.standing = {standingScatter_.bins(), standingScatter_.noise(),
                     1 / (1 - std::clamp(correlation, 0.0, kLargest)), standingScans_};
  report.poseScatter_m = rms(steps_, 0, 2);
  report.poseScatter_rad = rms(steps_, 2, 1);
  Eigen::Vector3d claimed = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& variances : claimed_) claimed += variances;
  claimed /= static_cast<double>(claimed_.size());
  report.wholeScan =
      WholeScanOptions{missingSigma(report.poseScatter_m, (claimed.x() + claimed.y()) / 2),
                       missingSigma(report.poseScatter_rad, claimed.z())};
  return report;
}

const SensorReport::Rays& SensorReport::best() const
{
  /** Scans of a standing scanner that tell its noise. Unit: scans. Definition: ten seconds. */
  constexpr int kEnough = 100;
  return standing.scans >= kEnough ? standing : walls;
}

std::string SensorReport::sensorFile() const
{
  /** Least standard deviation that is stated. Definition: the unit in which scanners send ranges.
   */
  constexpr double kLeast_m = 1e-3;
  /** Standard deviation that a statement is rounded up to. Definition: below what is known of it.
   */
  constexpr double kRound_m = 1e-4;
  std::ostringstream file;
  file << "# Noise of a scanner, estimated from " << scans << " of its scans"
       << (standing.scans > 0 ? ", of " + std::to_string(standing.scans) + " while it stood" : "")
       << ".\n[psmks.segmentation]\nrange_sigma_m = "
       << kRound_m * std::ceil(std::max(best().noise.sigma_m, kLeast_m) / kRound_m)
       << "\nrange_sigma_per_metre_m = "
       << kRound_m * std::ceil(best().noise.sigmaPerMetre_m / kRound_m) << '\n';
  if (wholeScan && &best() == &standing)
    file << "\n[psmks.whole_scan]\nsigma_m = "
         << kRound_m * std::round(wholeScan->sigma_m / kRound_m)
         << "\nsigma_deg = " << std::setprecision(2) << radToDeg(wholeScan->sigma_rad) << '\n';
  return file.str();
}
}  // namespace psmks
