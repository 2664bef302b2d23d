/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/segmentation/CollinearityStatistic.h>
#include <psmks/segmentation/LineFilters.h>
#include <psmks/segmentation/LineFit.h>
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
constexpr int kEkfStartRays = 9;

/** The scan's own or the option's. */
RangeNoise statedNoise(const Scan& scan, const SegmentationOptions& options)
{
  return {scan.rangeSigma_m > 0 ? scan.rangeSigma_m : options.rangeSigma_m,
          options.rangeSigmaPerMetre_m};
}

/** Counts rounding as noise, and takes off what it adds to the ranges. */
void allowForRounding(SegmentedScan& scan, RaySoA& rays)
{
  const RangeRounding rounding = findRounding(rays);
  if (!(rounding.step_m > 0)) return;
  scan.rangeNoise = rounding.addedTo(scan.rangeNoise);
  for (double& range_m : scan.range_m)
    if (range_m > rounding.overshoot_m) range_m -= rounding.overshoot_m;
  rays.load(scan);
}

/** The line of the marked rays by the paper's filter, or `otherwise` where it does not start. It
 * linearises at its estimate: it starts from as many rays as the paper's authors take for a seed,
 * or from all of a shorter line. */
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

/** The line of a run's rays by the filter that the options choose. */
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

/** A bulge that is both significant and larger than the noise: long real walls are never quite
 *  straight, and a sagitta within the noise does no harm. */
bool isCurved(const LineFit& fit, double length_m, double sigma_m, double gate)
{
  const double sagitta_m = std::abs(fit.curvature_1_m) * length_m * length_m / 4;
  return std::abs(fit.curvature_1_m) > gate * fit.curvatureSigma_1_m && sagitta_m > sigma_m;
}

/** Variance of the distance of the line at its best known point. */
double offsetVariance_m2(const Line& line)
{
  const auto& P = line.covariance;
  return P(1, 1) > 0 ? P(0, 0) - P(0, 1) * P(0, 1) / P(1, 1) : P(0, 0);
}

bool isSegment(const LineFit& fit, const Segment& segment, const SegmentedScan& scan,
               const SegmentationOptions& options)
{
  if (fit.rays < options.minRays) return false;
  const Line& line = segment.line;
  if (!line.covariance.allFinite() || !(line.r0_m > 5 * scan.rangeNoise.sigma_m)) return false;
  if (fit.chi2 > options.maxReducedChi2 * (fit.rays - 2)) return false;
  if (offsetVariance_m2(line) > options.maxOffsetSigma_m * options.maxOffsetSigma_m) return false;
  if (line.covariance(1, 1) > options.maxAngleSigma_rad * options.maxAngleSigma_rad) return false;
  return !isCurved(fit, segment.length_m(), middleSigma_m(segment, scan), options.curvatureGate);
}

/** Widens a covariance where the residuals are significantly larger than the noise. */
double covarianceScale(const LineFit& fit)
{
  constexpr double kSignificance = 3;
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

/** Turns runs into segments. */
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
  }

 private:
  /** @param mark of the run's rays: the index of the run it came from */
  void finish(const LineRun& run, int mark)
  {
    constexpr double kNotWhite = 2.5;
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
    tellRays(run, mark, static_cast<int>(scan_.segments.size()));
    scan_.segments.push_back(segment);
  }

  /** Takes rays that graze the line off both ends: bearing errors dominate there. False where none
   *  does, or where too few would be left. */
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

  /** Rays that no longer belong to a run. */
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

  void tellRays(const LineRun& run, int mark, int segment)
  {
    const int *marks = rays_.mark.data(), rays = rays_.rays;
    int* segmentOfRay = scan_.segmentOfRay.data();
    for (int p = run.first, ray = rays_.ray(p); p <= run.last; ++p, ++ray)
    {
      if (ray == rays) ray = 0;
      if (marks[p] == mark) segmentOfRay[ray] = segment;
    }
  }

  const LineGrowing& lines_;
  const SegmentationOptions& options_;
  RaySoA& rays_;
  SegmentedScan& scan_;
};
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
  rays.computeMoments();

  LineGrowing lines(options, rays, buffers.runs);
  lines.grow();
  lines.contestCorners();
  lines.mergeCollinear();
  Finish(lines, options, rays, result).run();
}
}  // namespace psmks
