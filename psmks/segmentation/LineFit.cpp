/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/segmentation/LineFit.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace psmks
{
namespace
{
/** Rays side by side: as many as leave all sums in registers. */
constexpr int kLanes = 2;
using Lanes = Eigen::Array<double, kLanes, 1>;

/* Sums over the rays at the line (r0, phi0), with c = cos(b - phi0), t = tan(b - phi0), residual
 * e = r - r0 / c, and the rows
 *     d r / d r0   =  1 / c
 *     d r / d phi0 = -r0 t / c
 *     d r / d k    =  r0^2 t^2 / c    (a bulge k along^2 of the wall, along = r0 t)
 * all of which are 1/c times a power of t: their products are the moments sum t^k / c^2. */
struct NormalSums
{
  std::array<double, 5> tt{};  // sum of t^k / c^2
  std::array<double, 3> te{};  // sum of e t^k / c
  double ee = 0;
  double lag = 0;  // sum of e of neighbouring rays of the line
};

/** The same lane by lane. */
struct LaneSums
{
  std::array<Lanes, 5> tt;
  std::array<Lanes, 3> te;
  Lanes ee;
  double lag = 0, previous = 0;

  LaneSums()
  {
    tt.fill(Lanes::Zero()), te.fill(Lanes::Zero());
    ee = Lanes::Zero();
  }

  /** Rays that do not count have a and e of 0. */
  void add(const Lanes& a, const Lanes& t, const Lanes& e)
  {
    Lanes product = a * a;
    for (Lanes& sum : tt)
    {
      sum += product;
      product *= t;
    }
    product = a * e;
    for (Lanes& sum : te)
    {
      sum += product;
      product *= t;
    }
    ee += e * e;
    lag += previous * e[0] + e[0] * e[1];
    previous = e[1];
  }

  NormalSums total() const
  {
    NormalSums sums;
    for (std::size_t k = 0; k < tt.size(); ++k) sums.tt[k] = tt[k].sum();
    for (std::size_t k = 0; k < te.size(); ++k) sums.te[k] = te[k].sum();
    sums.ee = ee.sum();
    sums.lag = lag;
    return sums;
  }
};

Eigen::Map<const Lanes> lanes(const std::vector<double>& column, int position)
{
  return Eigen::Map<const Lanes>(column.data() + position);
}

Lanes belongs(const RaySoA& rays, int position, const RayRange& range)
{
  Lanes result;
  for (int k = 0; k < kLanes; ++k)
  {
    const int p = position + k;
    result[k] = (p <= range.last) & (rays.mark[static_cast<std::size_t>(p)] == range.mark);
  }
  return result;
}

/** @tparam kGrows whether the noise does: rows and residuals are then divided by its growth where
 *  the line is, not where the ray is measured, for that would prefer rays that are too short */
template <bool kGrows>
NormalSums accumulate(const RaySoA& rays, const RayRange& range, const LineStart& line)
{
  const double growth_1_m2 = rays.noise.growth_1_m2();
  const double c0 = line.normal.x(), s0 = line.normal.y();
  LaneSums sums;
  for (int p = range.first; p <= range.last; p += kLanes)
  {
    const Lanes cosine = lanes(rays.cosine, p), sine = lanes(rays.sine, p);
    const Lanes counts = belongs(rays, p, range);
    // A ray that does not count may have any direction: 1 in place of its cosine.
    const Lanes inverse = 1 / ((cosine * c0 + sine * s0) * counts + (1 - counts));
    const Lanes t = (sine * c0 - cosine * s0) * inverse;
    const Lanes expected_m = line.r0_m * inverse;
    const Lanes residual_m = lanes(rays.range_m, p) - expected_m;
    Lanes weight = counts;
    if constexpr (kGrows) weight *= (1 + growth_1_m2 * expected_m.square()).rsqrt();
    sums.add(inverse * weight, t, residual_m * weight);
  }
  return sums.total();
}
}  // namespace

LineFit fitLine(const RaySoA& rays, const RayRange& range, const LineStart& start)
{
  const double sigma_m = rays.noise.sigma_m, variance_m2 = sigma_m * sigma_m;
  const NormalSums n = rays.noise.grows() ? accumulate<true>(rays, range, start)
                                          : accumulate<false>(rays, range, start);
  const double r0 = start.r0_m, r2 = r0 * r0;
  const double aa = n.tt[0], ab = -r0 * n.tt[1], bb = r2 * n.tt[2];
  const double ae = n.te[0], be = -r0 * n.te[1];
  const double determinant = aa * bb - ab * ab;
  LineFit fit;
  fit.rays = range.rays;
  if (!(determinant > 0)) return fit;

  const double dr0 = (bb * ae - ab * be) / determinant;
  const double dphi0 = (aa * be - ab * ae) / determinant;
  Eigen::Matrix2d inverse;
  inverse << bb, -ab, -ab, aa;
  const double phi0_rad = std::atan2(start.normal.y(), start.normal.x()) + dphi0;
  fit.line =
      Line::fromNormalForm(start.r0_m + dr0, phi0_rad, inverse * (variance_m2 / determinant));
  fit.normal = fit.line.normal();
  fit.chi2 = std::max(0.0, n.ee - ae * dr0 - be * dphi0) / variance_m2;
  fit.whiteness = n.lag / (variance_m2 * std::sqrt(range.rays));

  // Schur complement of the quadratic term on (r0, phi0)
  const double ag = r2 * n.tt[2], bg = -r0 * r2 * n.tt[3], gg = r2 * r2 * n.tt[4];
  const double ga = (bb * ag - ab * bg) / determinant;
  const double gb = (aa * bg - ab * ag) / determinant;
  const double information = gg - ga * ag - gb * bg;
  if (information > 0)
  {
    fit.curvature_1_m = (r2 * n.te[2] - ga * ae - gb * be) / information;
    fit.curvatureSigma_1_m = sigma_m / std::sqrt(information);
  }
  return fit;
}
}  // namespace psmks
