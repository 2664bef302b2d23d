/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/segmentation/LineInformation.h>
#include <tests/support/RandomNumbers.h>

#include <Eigen/LU>
#include <vector>

namespace psmks
{
namespace
{
MeasuredRay rayOf(double bearing_rad, double range_m)
{
  return {std::cos(bearing_rad), std::sin(bearing_rad), range_m, 1 / range_m};
}

std::vector<MeasuredRay> exactRays(const Line& line, int count)
{
  std::vector<MeasuredRay> rays;
  for (int i = 0; i < count; ++i)
  {
    const double bearing_rad = line.phi0_rad + degToRad(4.0 * i - 30);
    rays.push_back(rayOf(bearing_rad, line.rangeAt_m(bearing_rad)));
  }
  return rays;
}

std::vector<MeasuredRay> noisyRays(test::RandomNumbers& random, int count)
{
  std::vector<MeasuredRay> rays;
  for (const MeasuredRay& ray : exactRays({2, 0.7, {}}, count))
    rays.push_back(rayOf(std::atan2(ray.sine, ray.cosine), ray.range_m + random.normal(0.01)));
  return rays;
}

LineInformation sumsOf(const std::vector<MeasuredRay>& rays)
{
  LineInformation sums;
  for (const MeasuredRay& ray : rays) sums.add(ray);
  return sums;
}

LineInformation::Solution solutionOf(const LineInformation& sums)
{
  LineInformation::Solution solution{};
  EXPECT_TRUE(sums.solve(solution));
  return solution;
}

void expectSame(const LineInformation::Solution& a, const LineInformation::Solution& b)
{
  EXPECT_NEAR(a.u0, b.u0, 1e-10);
  EXPECT_NEAR(a.u1, b.u1, 1e-10);
  EXPECT_NEAR(a.chi2, b.chi2, 1e-10);
  EXPECT_NEAR(a.p00, b.p00, 1e-10);
  EXPECT_NEAR(a.p01, b.p01, 1e-10);
  EXPECT_NEAR(a.p11, b.p11, 1e-10);
}
}  // namespace

TEST(LineInformation, ExactRaysGiveTheirLineBack)
{
  for (const Line& line : {Line{2, 0.3, {}}, Line{0.2, -3.1, {}}, Line{25, 1.6, {}}})
  {
    const LineInformation::Solution s = solutionOf(sumsOf(exactRays(line, 15)));
    EXPECT_NEAR(s.line(1).r0_m, line.r0_m, 1e-9 * line.r0_m);
    EXPECT_NEAR(s.line(1).phi0_rad, line.phi0_rad, 1e-9);
    EXPECT_NEAR(s.chi2, 0, 1e-10 * line.r0_m * line.r0_m);
  }
}

TEST(LineInformation, AreTheWeightedLeastSquaresOfTheExplicitSums)
{
  test::RandomNumbers random(11);
  SCOPED_TRACE(random.seedText());
  const std::vector<MeasuredRay> rays = noisyRays(random, 15);
  Eigen::Matrix2d M = Eigen::Matrix2d::Zero();
  Eigen::Vector2d v = Eigen::Vector2d::Zero();
  for (const MeasuredRay& ray : rays)
  {
    const Eigen::Vector2d e(ray.cosine, ray.sine);
    const double w = std::pow(ray.range_m, 4);
    M += w * e * e.transpose();
    v += w * e / ray.range_m;
  }
  const Eigen::Matrix2d inverse = M.inverse();
  const Eigen::Vector2d u = inverse * v;
  double chi2 = 0;
  for (const MeasuredRay& ray : rays)
    chi2 += std::pow(ray.range_m, 4) *
            std::pow(1 / ray.range_m - u.dot(Eigen::Vector2d(ray.cosine, ray.sine)), 2);

  const LineInformation::Solution s = solutionOf(sumsOf(rays));
  expectSame(s, {u.x(), u.y(), inverse(0, 0), inverse(0, 1), inverse(1, 1), chi2});
  const Eigen::Vector2d e(std::cos(0.4), std::sin(0.4));
  EXPECT_NEAR(s.inverseRange(e.x(), e.y()), u.dot(e), 1e-12);
  EXPECT_NEAR(s.inverseRangeVariance(e.x(), e.y()), e.dot(inverse * e), 1e-12);
}

// The covariance of (r0, phi0) is that of u through the derivative of (1/|u|, atan2(u)).
TEST(LineInformation, TheLineCarriesThePropagatedCovariance)
{
  test::RandomNumbers random(14);
  SCOPED_TRACE(random.seedText());
  const LineInformation::Solution s = solutionOf(sumsOf(noisyRays(random, 15)));
  constexpr double h = 1e-6, kVariance_m2 = 1e-4;
  const auto lineAt = [&](double du0, double du1) -> Eigen::Vector2d
  {
    const double u0 = s.u0 + du0, u1 = s.u1 + du1;
    return {1 / std::hypot(u0, u1), std::atan2(u1, u0)};
  };
  Eigen::Matrix2d J, P;
  J << (lineAt(h, 0) - lineAt(-h, 0)) / (2 * h), (lineAt(0, h) - lineAt(0, -h)) / (2 * h);
  P << s.p00, s.p01, s.p01, s.p11;
  const Eigen::Matrix2d expected = kVariance_m2 * J * P * J.transpose();
  EXPECT_LT((s.line(kVariance_m2).covariance - expected).norm(), 1e-6 * expected.norm());
}

TEST(LineInformation, ARemovedRayWasNeverThere)
{
  test::RandomNumbers random(12);
  SCOPED_TRACE(random.seedText());
  const std::vector<MeasuredRay> rays = noisyRays(random, 12);
  LineInformation sums = sumsOf(rays);
  const LineInformation::Moments outlier = LineInformation::moments(rayOf(0.5, 9));
  sums.addMoments(outlier);
  sums.removeMoments(outlier);
  EXPECT_EQ(sums.rays(), 12);
  expectSame(solutionOf(sums), solutionOf(sumsOf(rays)));
}

TEST(LineInformation, SumsOfTwoPiecesAreTheSumsOfTheWhole)
{
  test::RandomNumbers random(13);
  SCOPED_TRACE(random.seedText());
  const std::vector<MeasuredRay> rays = noisyRays(random, 16);
  const std::vector<MeasuredRay> left(rays.begin(), rays.begin() + 7);
  const std::vector<MeasuredRay> right(rays.begin() + 7, rays.end());
  LineInformation joined = sumsOf(left);
  joined += sumsOf(right);
  EXPECT_EQ(joined.rays(), 16);
  expectSame(solutionOf(joined), solutionOf(sumsOf(rays)));
}

TEST(LineInformation, FewerThanTwoDirectionsFixNoLine)
{
  LineInformation sums;
  LineInformation::Solution s{};
  EXPECT_FALSE(sums.solve(s));
  sums.add(rayOf(0.3, 2));
  EXPECT_FALSE(sums.solve(s));
  sums.add(rayOf(0.3, 2.1));
  EXPECT_FALSE(sums.solve(s)) << "the same bearing again";
  sums.add(rayOf(0.31, 2));
  EXPECT_TRUE(sums.solve(s));
}
}  // namespace psmks
