/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/segmentation/LineFit.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace psmks
{
namespace
{
/** How many rays are summed side by side. Unit: rays. Definition: width of the vectors in the code;
 * with two of them all sums stay in registers. */
constexpr int kLanes = 2;
using Lanes = Eigen::Array<double, kLanes, 1>;

/** Sums over the rays from which the normal equations of a line (r0, phi0) are made.
 *
 * With c = cos(b - phi0), t = tan(b - phi0) and the residual e = r - r0 / c, the derivatives are
 *     d r / d r0   =  1 / c
 *     d r / d phi0 = -r0 t / c
 *     d r / d k    =  r0^2 t^2 / c    (a bulge of the wall by k along^2, where along = r0 t)
 * Each is 1/c times a power of t, so that the products of any two are moments sum t^k / c^2. */
struct NormalSums
{
  std::array<double, 5> tt{};  //!< sums of t^k / c^2 for k = 0 to 4
  std::array<double, 3> te{};  //!< sums of e t^k / c for k = 0 to 2
  double ee = 0;               //!< sum of e^2
  double lag = 0;              //!< sum of the products of the residuals of neighbouring rays
};

/** NormalSums while they are summed, one sum per lane. */
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

  /** Adds the rays of all lanes.
   *  @param a 1 / c times the root of the weight; 0 for a ray that does not belong to the line
   *  @param t tan(b - phi0)
   *  @param e residual times the root of the weight; 0 for a ray that does not belong to the line
   */
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

/** 1 for the positions that belong to the line, else 0. */
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

/** Sums the rays of a range at a line.
 *  @tparam kGrows whether the noise grows with the range. Rows and residuals are then divided by
 * the growth at the range of the line. Dividing by the growth at the measured range would prefer
 * rays that were measured too short. */
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
    // A ray that does not belong to the line may have any direction; 1 stands for its cosine.
    const Lanes inverse = 1 / ((cosine * c0 + sine * s0) * counts + (1 - counts));
    const Lanes t = (sine * c0 - cosine * s0) * inverse;
    const Lanes expected_m = line.r0_m * inverse;
    const Lanes residual_m = lanes(rays.range_m, p) - expected_m;
    // NOLINTNEXTLINE(performance-unnecessary-copy-initialization): changed where noise grows.
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

  // The curvature after (r0, phi0) have explained what they can: its Schur complement.
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
