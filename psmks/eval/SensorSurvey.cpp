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
  follow(current_);
}

/** The residuals of the rays on walls, each by itself and odd ones against even ones. */
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
    double sums_m[2] = {0, 0};
    int counts[2] = {0, 0};
    for (int ray = 0; ray < scan.rays(); ++ray)
    {
      if (scan.segmentOfRay[static_cast<std::size_t>(ray)] != static_cast<int>(s)) continue;
      const double range_m = scan.range_m[static_cast<std::size_t>(ray)];
      const double residual_m = range_m - scan.denoisedRange_m(ray);
      wallScatter_.add(range_m, unbiased * residual_m);
      sums_m[ray % 2] += residual_m;
      ++counts[ray % 2];
    }
    if (counts[0] > 0 && counts[1] > 0)
      oddMinusEven_m_.push_back(sums_m[1] / counts[1] - sums_m[0] / counts[0]);
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
  if (!oddMinusEven_m_.empty())
  {
    report.oddMinusEven_m = median(oddMinusEven_m_);
    std::vector<double> apart_m = oddMinusEven_m_;
    for (double& value_m : apart_m) value_m = std::abs(value_m - report.oddMinusEven_m);
    report.oddMinusEvenSigma_m =
        kNormalRatio * median(apart_m) / std::sqrt(static_cast<double>(apart_m.size()));
  }
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
