/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/core/LineFit.h>

#include <cmath>

namespace psmks
{
namespace
{
/* Sums over the rays at the line (r0, phi0), with c = cos(b - phi0), s = sin(b - phi0),
 * residual e = r - r0 / c, and the rows
 *     a = d r / d r0   =  1 / c
 *     b = d r / d phi0 = -r0 s / c^2
 *     g = d r / d k    =  (r0 s / c)^2 / c   (a bulge k along^2 of the wall, along = r0 tan) */
struct NormalSums
{
  double aa = 0, ab = 0, bb = 0, ae = 0, be = 0, ee = 0;
  double ag = 0, bg = 0, gg = 0, ge = 0;
  double lag = 0;  // sum of e of neighbouring rays of the line
  int rays = 0;
};

NormalSums accumulate(const SegmentedScan& scan, const RayRange& range, const Line& line)
{
  const double c0 = std::cos(line.phi0_rad), s0 = std::sin(line.phi0_rad), r0 = line.r0_m;
  const double* cosines = scan.grid.cosines();
  const double* sines = scan.grid.sines();
  NormalSums sum;
  double previous = 0;
  for (int k = 0, ray = range.first; k < range.count; ++k, ++ray)
  {
    if (ray == scan.rays()) ray = 0;
    const auto i = static_cast<std::size_t>(ray);
    if (scan.segmentOfRay[i] != range.mark) continue;
    const double a = 1 / (cosines[i] * c0 + sines[i] * s0);
    const double along = r0 * (sines[i] * c0 - cosines[i] * s0) * a;
    const double b = -along * a;
    const double g = along * along * a;
    const double e = scan.range_m[i] - r0 * a;
    sum.aa += a * a, sum.ab += a * b, sum.bb += b * b, sum.ae += a * e, sum.be += b * e;
    sum.ee += e * e;
    sum.ag += a * g, sum.bg += b * g, sum.gg += g * g, sum.ge += g * e;
    sum.lag += e * previous;
    previous = e;
    ++sum.rays;
  }
  return sum;
}
}  // namespace

LineFit fitLine(const SegmentedScan& scan, const RayRange& range, const Line& start, double sigma_m)
{
  const double variance_m2 = sigma_m * sigma_m;
  const NormalSums n = accumulate(scan, range, start);
  const double determinant = n.aa * n.bb - n.ab * n.ab;
  LineFit fit;
  fit.rays = n.rays;
  if (!(determinant > 0)) return fit;

  const double dr0 = (n.bb * n.ae - n.ab * n.be) / determinant;
  const double dphi0 = (n.aa * n.be - n.ab * n.ae) / determinant;
  Eigen::Matrix2d inverse;
  inverse << n.bb, -n.ab, -n.ab, n.aa;
  fit.line = Line::fromNormalForm(start.r0_m + dr0, start.phi0_rad + dphi0,
                                  inverse * (variance_m2 / determinant));
  fit.chi2 = std::max(0.0, n.ee - n.ae * dr0 - n.be * dphi0) / variance_m2;
  fit.whiteness = n.lag / (variance_m2 * std::sqrt(n.rays));

  // Schur complement of the quadratic term on (r0, phi0)
  const double ga = (n.bb * n.ag - n.ab * n.bg) / determinant;
  const double gb = (n.aa * n.bg - n.ab * n.ag) / determinant;
  const double information = n.gg - ga * n.ag - gb * n.bg;
  if (information > 0)
  {
    fit.curvature_1_m = (n.ge - ga * n.ae - gb * n.be) / information;
    fit.curvatureSigma_1_m = sigma_m / std::sqrt(information);
  }
  return fit;
}
}  // namespace psmks
