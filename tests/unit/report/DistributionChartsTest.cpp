/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/report/DistributionCharts.h>
#include <gtest/gtest.h>
#include <tests/unit/report/ScanPairs.h>

namespace psmks
{
namespace
{
using test::matched;

/** A set with three runs. Matcher a has errors of 1 to 5 cm, matcher b another kind of guess. All
 * bounds are 1 cm and 1 degree. */
PairsSetResult threeRuns()
{
  PairsSetResult set;
  PairsRun a{"a", "zero", {}};
  for (const double error_m : {0.03, 0.01, 0.05, 0.02, 0.04})
    a.records.push_back(matched(0, error_m, 100 * error_m));
  set.runs = {a, {"b", "odometry", a.records}, {"c", "zero", a.records}};
  PairBound bound;
  bound.information.diagonal() << 1e4, 1e4, 1 / (degToRad(1) * degToRad(1));
  set.bounds.assign(100, bound);
  return set;
}

std::vector<std::string> namesOf(const Chart& chart)
{
  std::vector<std::string> names;
  for (const ChartSeries& series : chart.series) names.push_back(series.name);
  return names;
}

/** The limit below which half of the matches are. */
double medianOf(const ChartSeries& series)
{
  for (const Eigen::Vector2d& point : series.points)
    if (point.y() == 50) return point.x();
  return 0;
}
}  // namespace

TEST(DistributionCharts, ShowTheMatchersOfOneGuessAndTheBound)
{
  const std::vector<Chart> charts = distributionCharts(threeRuns(), "zero");
  ASSERT_EQ(charts.size(), 3U);
  EXPECT_EQ(namesOf(charts[0]), (std::vector<std::string>{"a", "c", "bound"}));
  EXPECT_EQ(namesOf(charts[1]), (std::vector<std::string>{"a", "c", "bound"}));
  EXPECT_EQ(namesOf(charts[2]), (std::vector<std::string>{"a", "c"}));
  for (const Chart& chart : charts) EXPECT_TRUE(chart.xRange.logarithmic);
}

TEST(DistributionCharts, GoThroughTheMedianInTheUnitOfTheAxis)
{
  const std::vector<Chart> charts = distributionCharts(threeRuns(), "zero");
  EXPECT_NEAR(medianOf(charts[0].series.front()), 30, 1e-9);
  EXPECT_NEAR(medianOf(charts[1].series.front()), 3, 1e-9);
  EXPECT_NEAR(medianOf(charts[2].series.front()), 1, 1e-9);
  EXPECT_NEAR(medianOf(charts[0].series.back()), 1.1774 * 10, 0.5);
  EXPECT_NEAR(medianOf(charts[1].series.back()), 0.6745, 0.05);
}
}  // namespace psmks
