/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/segmentation/CollinearityStatistic.h>
#include <psmks/segmentation/LineFilters.h>
#include <psmks/segmentation/LineFit.h>
#include <psmks/segmentation/NoiseCorrelation.h>
#include <psmks/segmentation/NoiseEstimate.h>
#include <psmks/segmentation/Preprocessing.h>
#include <psmks/segmentation/RangeRounding.h>
#include <psmks/segmentation/Segmentation.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace psmks
{
namespace
{
/** Rays from which the extended filter is started. Unit: rays. Evidence: started from 4 rays the
 * NEES of its lines is above 1,000, from 9 it is 2.3; the paper's authors start from 9. */
constexpr int kEkfStartRays = 9;

/** Distance of a line from the scanner below which it is no segment, in standard deviations of a
 * range. Unit: standard deviations. Evidence: measured. */
constexpr double kLeastDistance = 5;

/** A covariance is widened where chi2 per degree of freedom exceeds 1 by so many of its standard
 * deviations. Unit: standard deviations. Evidence: measured. */
constexpr double kSignificance = 3;

/** A line is examined for a cut where the correlation of its neighbouring residuals exceeds so many
 * standard deviations. Unit: standard deviations. Evidence: measured. */
constexpr double kNotWhite = 2.5;

/** Range noise from the header of the scan, else from the options. */
RangeNoise statedNoise(const Scan& scan, const SegmentationOptions& options)
{
  return {scan.rangeSigma_m > 0 ? scan.rangeSigma_m : options.rangeSigma_m,
          options.rangeSigmaPerMetre_m};
}

/** Adds the variance of rounding to the noise, and subtracts from the ranges what rounding has
 * added to them on average. */
void allowForRounding(SegmentedScan& scan, RaySoA& rays)
{
  const RangeRounding rounding = findRounding(rays);
  if (!(rounding.step_m > 0)) return;
  scan.rangeNoise = rounding.addedTo(scan.rangeNoise);
  for (double& range_m : scan.range_m)
    if (range_m > rounding.overshoot_m) range_m -= rounding.overshoot_m;
  rays.load(scan);
}

/** The line of the marked rays by the paper's extended filter.
 *
 * The filter linearises at its estimate, so that its start has to be good: kEkfStartRays rays, or
 * all rays of a shorter line.
 *  @return `otherwise` where the rays do not fix a line */
Line extendedFilterLine(const RaySoA& rays, const RayRange& range, const Line& otherwise)
{
  const int startRays = std::min(kEkfStartRays, range.rays);
  PolarLineFilter filter(rays.noise);
  LineInformation seed;
  bool started = false;
  for (int p = range.first; p <= range.last; ++p)
  {
    if (rays.mark[static_cast<std::size_t>(p)] != range.mark) continue;
    if (started)
    {
      filter.update(rays.measured(p));
      continue;
    }
    seed.addMoments(rays.moments[static_cast<std::size_t>(p)]);
    started = seed.rays() >= startRays && filter.start(seed);
  }
  return started ? filter.line() : otherwise;
}

/** Fits a line to the rays of a run, and replaces it by the extended filter's line if the options
 * choose that filter. */
LineFit fitRun(const RaySoA& rays, const LineRun& run, int mark, const SegmentationOptions& options)
{
  LineInformation::Solution s{};
  if (!run.sums.solve(s)) return {};
  const RayRange range{run.first, run.last, mark, run.sums.rays()};
  const double r0_m = 1 / std::sqrt(s.u0 * s.u0 + s.u1 * s.u1);
  LineFit fit = fitLine(rays, range, {r0_m * Eigen::Vector2d(s.u0, s.u1), r0_m});
  if (options.filter == LineFilter::Ekf)
  {
    fit.line = extendedFilterLine(rays, range, fit.line);
    fit.normal = fit.line.normal();
  }
  return fit;
}

/** Standard deviation of a range in the middle of a segment. */
double middleSigma_m(const Segment& segment, const SegmentedScan& scan)
{
  const double first_m = scan.range_m[static_cast<std::size_t>(segment.firstRay)];
  const double last_m = scan.range_m[static_cast<std::size_t>(segment.lastRay)];
  return scan.rangeNoise.sigmaAt_m(0.5 * (first_m + last_m));
}

/** Whether a line bulges significantly and by more than the noise. Long real walls are never quite
 * straight, and a sagitta below the standard deviation of a range does no harm.
 *  @param sigma_m standard deviation of a range
 *  @param gate standard deviations of the curvature that are significant */
bool isCurved(const LineFit& fit, double length_m, double sigma_m, double gate)
{
  // A curve k along^2 over a chord of this length bulges by k (length / 2)^2.
  const double sagitta_m = std::abs(fit.curvature_1_m) * length_m * length_m / 4;
  return std::abs(fit.curvature_1_m) > gate * fit.curvatureSigma_1_m && sagitta_m > sigma_m;
}

/** Variance of the distance of a line at its best known point, the anchor of AnchoredLine. */
double offsetVariance_m2(const Line& line)
{
  const auto& P = line.covariance;
  return P(1, 1) > 0 ? P(0, 0) - P(0, 1) * P(0, 1) / P(1, 1) : P(0, 0);
}

/** Whether a fit is good enough for a segment: enough rays, not too near, not too noisy, well known
 * and straight. */
bool isSegment(const LineFit& fit, const Segment& segment, const SegmentedScan& scan,
               const SegmentationOptions& options)
{
  if (fit.rays < options.minRays) return false;
  const Line& line = segment.line;
  if (!line.covariance.allFinite() || !(line.r0_m > kLeastDistance * scan.rangeNoise.sigma_m))
    return false;
  if (fit.chi2 > options.maxReducedChi2 * (fit.rays - 2)) return false;
  if (offsetVariance_m2(line) > options.maxOffsetSigma_m * options.maxOffsetSigma_m) return false;
  if (line.covariance(1, 1) > options.maxAngleSigma_rad * options.maxAngleSigma_rad) return false;
  return !isCurved(fit, segment.length_m(), middleSigma_m(segment, scan), options.curvatureGate);
}

/** Factor of a line's covariance: chi2 per degree of freedom where the residuals are significantly
 * larger than the noise, else 1. */
double covarianceScale(const LineFit& fit)
{
  const double dof = std::max(1, fit.rays - 2);
  const double reduced = fit.chi2 / dof;
  return reduced > 1 + kSignificance * std::sqrt(2 / dof) ? reduced : 1;
}

Segment makeSegment(const LineFit& fit, int firstRay, int lastRay, const SegmentedScan& scan)
{
  Segment segment;
  segment.line = fit.line;
  segment.line.covariance *= covarianceScale(fit);
  segment.firstRay = firstRay;
  segment.lastRay = lastRay;
  segment.rays = fit.rays;
  segment.sigma_m = middleSigma_m(segment, scan) * std::sqrt(fit.chi2 / std::max(1, fit.rays - 2));
  const auto endAt = [&](int ray) -> Eigen::Vector2d
  {
    const Eigen::Vector2d direction = scan.grid.direction(ray);
    const double cosine = fit.normal.dot(direction);
    return (cosine > 0 ? fit.line.r0_m / cosine : std::numeric_limits<double>::infinity()) *
           direction;
  };
  segment.firstEnd_m = endAt(firstRay);
  segment.lastEnd_m = endAt(lastRay);
  return segment;
}

/** Turns the runs of the line growing into segments of the scan. */
class Finish
{
 public:
  Finish(const LineGrowing& lines, const SegmentationOptions& options, RaySoA& rays,
         SegmentedScan& scan)
      : lines_(lines), options_(options), rays_(rays), scan_(scan)
  {
  }

  void run()
  {
    int mark = 0;
    for (const LineRun& run : lines_.runs()) finish(run, mark++);
    scan_.raysPerReading = correlation_.raysPerReading();
    for (Segment& segment : scan_.segments) segment.line.covariance *= scan_.raysPerReading;
  }

 private:
  /** Makes a run into a segment, or into several, or into none: a run that is two lines is cut,
   * rays that graze the line are dropped, and what is no segment stays single rays.
   *  @param mark of the run's rays: the index of the run it came from */
  void finish(const LineRun& run, int mark)
  {
    const LineFit fit = fitRun(rays_, run, mark, options_);
    LineRun left, right;
    if (fit.whiteness > kNotWhite && lines_.cut(run, mark, left, right))
    {
      finish(left, mark);
      finish(right, mark);
      return;
    }
    if (LineRun trimmed = run; trimGrazing(fit.normal, mark, trimmed))
    {
      finish(trimmed, mark);
      return;
    }
    const Segment segment = makeSegment(fit, rays_.ray(run.first), rays_.ray(run.last), scan_);
    if (!isSegment(fit, segment, scan_, options_)) return;
    setSegmentOfRays(run, mark, static_cast<int>(scan_.segments.size()));
    scan_.segments.push_back(segment);
    correlation_.add(fit);
  }

  /** Drops rays that graze the line from both ends of a run, because the errors of their bearings
   * dominate there. At least the fewest rays of a segment are left.
   *  @return whether a ray was dropped */
  bool trimGrazing(const Eigen::Vector2d& normal, int mark, LineRun& run)
  {
    const auto grazes = [&](int position)
    { return normal.dot(scan_.grid.direction(rays_.ray(position))) < options_.minIncidenceCosine; };
    const LineRun whole = run;
    while (run.last - run.first >= options_.minRays && grazes(run.first)) ++run.first;
    while (run.last - run.first >= options_.minRays && grazes(run.last)) --run.last;
    if (run.first == whole.first && run.last == whole.last) return false;
    drop(whole.first, run.first - 1, mark, run);
    drop(run.last + 1, whole.last, mark, run);
    return true;
  }

  /** Takes the rays between two positions (both included) that carry the mark out of a run. */
  void drop(int first, int last, int mark, LineRun& run)
  {
    for (int p = first; p <= last; ++p)
    {
      int& own = rays_.mark[static_cast<std::size_t>(p)];
      if (own != mark) continue;
      own = SegmentedScan::kNoSegment;
      run.sums.removeMoments(rays_.moments[static_cast<std::size_t>(p)]);
    }
  }

  /** Enters the index of a new segment for its rays in the scan. */
  void setSegmentOfRays(const LineRun& run, int mark, int segment)
  {
    const int *marks = rays_.mark.data(), *rayOf = rays_.rayOf.data();
    int* segmentOfRay = scan_.segmentOfRay.data();
    for (int p = run.first; p <= run.last; ++p)
      if (marks[p] == mark) segmentOfRay[rayOf[p]] = segment;
  }

  const LineGrowing& lines_;
  const SegmentationOptions& options_;
  RaySoA& rays_;
  SegmentedScan& scan_;
  NoiseCorrelation correlation_;
};

/** SegmentedScan::returnSpacing of a cleaned scan.
 *  @param spacings storage */
int usualSpacing(const SegmentedScan& scan, std::vector<int>& spacings)
{
  spacings.clear();
  std::size_t beside = 0;
  for (int ray = 0, before = -1; ray < scan.rays(); ++ray)
  {
    if (!scan.isValid(ray)) continue;
    if (before >= 0)
    {
      spacings.push_back(ray - before);
      beside += ray - before == 1;
    }
    before = ray;
  }
  if (2 * beside >= spacings.size()) return 1;
  const auto median = spacings.begin() + static_cast<std::ptrdiff_t>(spacings.size() / 2);
  std::nth_element(spacings.begin(), median, spacings.end());
  return *median;
}
}  // namespace

void segmentScan(const Scan& scan, const PreprocessingOptions& preprocessing,
                 const SegmentationOptions& options, SegmentationBuffers& buffers,
                 SegmentedScan& result, const ScannerNoise& scanner)
{
  cleanScan(scan, preprocessing, result);
  medianFilter(preprocessing.medianWindow, buffers.scratch, result);
  RaySoA& rays = buffers.rays;
  result.rangeNoise = statedNoise(scan, options);
  rays.load(result);
  if (options.estimateRangeSigma && scan.rangeSigma_m <= 0) allowForRounding(result, rays);
  result.shownNoise = options.estimateRangeSigma ? shownNoise(rays, buffers.scratch) : rays.noise;
  result.showsMoreNoise = result.shownNoise != rays.noise;
  if (scanner.isBelieved()) rays.noise = result.shownNoise;
  result.rangeNoise = rays.noise;
  if (result.grid.closed()) rays.startAt(result, strongestBreak(rays));
  result.returnSpacing = usualSpacing(result, buffers.spacings);
  if (result.longestHole() > 0) rays.closeHoles(result.longestHole());
  rays.computeMoments();

  LineGrowing lines(options, rays, buffers.runs);
  lines.grow();
  lines.contestCorners();
  lines.mergeCollinear();
  Finish(lines, options, rays, result).run();
}
}  // namespace psmks
