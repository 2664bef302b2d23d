/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/eval/Figure.h>
#include <tests/support/ScratchFolder.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace psmks
{
namespace
{
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/** Tests of pictures that are drawn in a scratch folder; they are skipped without gnuplot. */
class ChartFile : public testing::Test
{
 protected:
  void SetUp() override
  {
    std::string reason;
    if (!save(Chart(), path("empty.png"), &reason) &&
        reason.find("cannot be run") != std::string::npos)
      GTEST_SKIP() << reason;
    ASSERT_EQ(reason, "");
  }

  std::string path(const std::string& name) const { return folder_.path(name); }

  std::string saved(const Chart& chart, const std::string& name) const
  {
    std::string reason;
    EXPECT_TRUE(save(chart, path(name), &reason)) << reason;
    return bytesOf(name);
  }

  std::string bytesOf(const std::string& name) const
  {
    std::ifstream in(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  const test::ScratchFolder folder_;
};

/** A big-endian number of a PNG's header: width at 16, height at 20. */
int pngNumber(const std::string& png, std::size_t at)
{
  int number = 0;
  for (std::size_t i = at; i < at + 4; ++i)
    number = 256 * number + static_cast<unsigned char>(png.at(i));
  return number;
}

Chart zigzag()
{
  Chart chart;
  chart.title = "A zigzag";
  chart.xLabel = "distance [m]";
  chart.yLabel = "error [cm]";
  chart.series = {{"zig", {{0, 0}, {1, 1}, {2, 0}, {3, 1}}}};
  return chart;
}

HeatMap quilt()
{
  HeatMap map;
  map.title = "A quilt";
  map.xLabel = "d, m";
  map.yLabel = "a, deg";
  map.valueLabel = "success, %";
  map.x = {0.5, 1, 2};
  map.y = {0, 10};
  map.value = (Eigen::MatrixXd(2, 3) << 51, 52, 53, 61, kNaN, 63).finished();
  map.valueMax = 100;
  return map;
}

/** Strokes of all curves of an SVG. */
std::ptrdiff_t strokes(const std::string& svg)
{
  std::ptrdiff_t count = 0;
  for (std::size_t at = svg.find("<path"); at != std::string::npos; at = svg.find("<path", at + 1))
    count += std::count(svg.begin() + static_cast<std::ptrdiff_t>(at),
                        svg.begin() + static_cast<std::ptrdiff_t>(svg.find("/>", at)), 'M');
  return count;
}
}  // namespace

TEST_F(ChartFile, IsAPngOfTheStatedSize)
{
  const std::string png = saved(zigzag(), "chart.png");
  ASSERT_EQ(png.substr(1, 3), "PNG");
  EXPECT_EQ(pngNumber(png, 16), 1000);
  EXPECT_EQ(pngNumber(png, 20), 700);
}

TEST_F(ChartFile, IsAnSvgWhereThePathSaysSo)
{
  const std::string svg = saved(zigzag(), "chart.svg");
  for (const char* text : {"<svg", "A zigzag", "distance [m]", "error [cm]", "zig"})
    EXPECT_NE(svg.find(text), std::string::npos) << text;
}

TEST_F(ChartFile, PanelsStandInRows)
{
  Figure figure;
  figure.title = "Five panels";
  figure.panels.assign(5, zigzag());
  figure.columns = 3;
  figure.panelWidth_px = 400;
  figure.panelHeight_px = 300;
  ASSERT_TRUE(save(figure, path("figure.png")));
  const std::string png = bytesOf("figure.png");
  EXPECT_EQ(pngNumber(png, 16), 1200);
  EXPECT_EQ(pngNumber(png, 20), 600);
}

TEST_F(ChartFile, TextsMeanNothingToGnuplotOrAShell)
{
  const std::string trap = path("trap");
  const std::string touch = "`touch " + trap + "`'; system('touch " + trap + "') #";
  Chart chart = zigzag();
  chart.title = touch + "\n!touch " + trap + "\n";
  chart.xLabel = "$(touch " + trap + ") \\";
  chart.yLabel = "@x_{1}^2 \"quoted\"";
  chart.series[0].name = touch;
  const std::string svg = saved(chart, "it's a `trap`.svg");
  EXPECT_FALSE(std::filesystem::exists(trap));
  EXPECT_NE(svg.find("$(touch " + trap + ") \\"), std::string::npos);
  EXPECT_NE(svg.find("@x_{1}^2"), std::string::npos);
}

TEST_F(ChartFile, APointThatIsNotFiniteBreaksTheLine)
{
  Chart broken = zigzag();
  broken.series[0].points[1] = {kNaN, 1};
  const std::ptrdiff_t whole = strokes(saved(zigzag(), "whole.svg"));
  EXPECT_EQ(strokes(saved(broken, "broken.svg")), whole + 1);

  Chart walls = zigzag();
  walls.series = {lineSegments("walls", {{{0, 0}, {1, 1}}, {{2, 0}, {3, 1}}, {{0, 1}, {3, 0}}})};
  EXPECT_EQ(strokes(saved(walls, "walls.svg")), whole + 2);
}

TEST_F(ChartFile, ASeriesWithoutPointsIsLeftOut)
{
  Chart chart = zigzag();
  chart.series.push_back({"nothing", {}});
  chart.series.push_back({"nowhere", {{kNaN, kNaN}}});
  const std::string svg = saved(chart, "chart.svg");
  EXPECT_NE(svg.find("zig"), std::string::npos);
  EXPECT_EQ(svg.find("nothing"), std::string::npos);
  EXPECT_EQ(svg.find("nowhere"), std::string::npos);
}

TEST_F(ChartFile, AColourIsKept)
{
  Chart chart = zigzag();
  chart.series[0].rgb = 0x00ab0c;
  const std::string svg = saved(chart, "chart.svg");
  EXPECT_NE(svg.find("rgb(  0, 171,  12)"), std::string::npos);
}

TEST_F(ChartFile, ALogarithmicAxisGivesEveryDecadeTheSameWidth)
{
  Chart chart = zigzag();
  chart.series = {{"decades", {{1, 0}, {10, 1}, {100, 2}}}};
  chart.xRange = {1, 100, true};
  const std::string svg = saved(chart, "chart.svg");
  for (const char* tic : {"<text>1<", "<text>10<", "<text>100<"})
    EXPECT_NE(svg.find(tic), std::string::npos) << tic;
  EXPECT_EQ(svg.find("<text>50<"), std::string::npos);
}

TEST_F(ChartFile, ALogarithmicAxisLeavesOutWhatIsNotPositive)
{
  Chart chart = zigzag();
  chart.series = {{"some", {{0, 0}, {-1, 0}, {1, 1}, {10, 2}}}, {"none", {{0, 0}, {-1, 0}}}};
  chart.xRange.logarithmic = true;
  const std::string svg = saved(chart, "chart.svg");
  EXPECT_NE(svg.find("some"), std::string::npos);
  EXPECT_EQ(svg.find("none</"), std::string::npos);
}

TEST_F(ChartFile, NothingPositiveIsAnEmptyLogarithmicChart)
{
  Chart chart = zigzag();
  chart.series = {{"none", {{0, 0}}}};
  chart.xRange.logarithmic = chart.yRange.logarithmic = true;
  EXPECT_NE(saved(chart, "chart.svg").find("A zigzag"), std::string::npos);
}

TEST_F(ChartFile, AHeatMapShowsANumberInEveryCellThatHasOne)
{
  //  10 | 61  -  63
  //   0 | 51 52 53
  //      0.5  1  2
  HeatMap map = quilt();
  Figure figure;
  figure.panels = {map};
  figure.columns = 1;
  const std::string svg = svgText(figure);
  for (const char* text : {"A quilt", "d, m", "a, deg", "success, %", "<text>51<", "<text>52<",
                           "<text>53<", "<text>61<", "<text>63<"})
    EXPECT_NE(svg.find(text), std::string::npos) << text;
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

TEST_F(ChartFile, AChartBesideAHeatMapIsDrawnAsAlone)
{
  Figure figure;
  figure.panels = {quilt(), zigzag()};
  const std::string beside = svgText(figure);
  figure.panels = {zigzag(), zigzag()};
  const std::string twice = svgText(figure);
  const auto lastPanel = [](const std::string& svg)
  { return svg.substr(svg.rfind("gnuplot_plot_")).substr(std::string("gnuplot_plot_1").size()); };
  EXPECT_EQ(lastPanel(beside), lastPanel(twice));
}

TEST_F(ChartFile, TheSvgTextIsTheSvgFile)
{
  Figure figure;
  figure.panels = {zigzag()};
  ASSERT_TRUE(save(figure, path("figure.svg")));
  EXPECT_EQ(svgText(figure), bytesOf("figure.svg"));
}

TEST_F(ChartFile, AFolderThatDoesNotExistIsNamed)
{
  std::string reason;
  EXPECT_FALSE(save(zigzag(), path("missing/chart.png"), &reason));
  EXPECT_EQ(reason, path("missing/chart.png") + ": cannot be written");
}

TEST(Chart, WithoutGnuplotThereIsAReason)
{
  const test::ScratchFolder folder;
  const std::string before = std::getenv("PATH");
  setenv("PATH", "/nonexistent", 1);
  std::string reason;
  EXPECT_FALSE(save(zigzag(), folder.path("chart.png"), &reason));
  setenv("PATH", before.c_str(), 1);
  EXPECT_EQ(reason,
            folder.path("chart.png") + ": gnuplot cannot be run: No such file or directory");
}
}  // namespace psmks
