/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <docs/pictures/Pictures.h>

#include <cmath>

namespace psmks
{
namespace
{
constexpr double kShownSigmas = 20;  // one standard deviation, some millimetres, could not be seen
constexpr double kMargin_m = 0.5;    // beyond both ends of a segment: a line goes on there

/** The band of some standard deviations about the line of a segment, seen from end to end: narrow
 * where the line is known best, wide where its angle makes it uncertain. */
void addBand(const Segment& segment, ChartSeries& series)
{
  constexpr int kSteps = 20;
  const Eigen::Vector2d normal = segment.line.normal(), along(-normal.y(), normal.x());
  const double from_m = along.dot(segment.firstEnd_m) - kMargin_m;
  const double to_m = along.dot(segment.lastEnd_m) + kMargin_m;
  for (const int side : {-1, 1})
  {
    for (int i = 0; i <= kSteps; ++i)
    {
      const double along_m = from_m + (to_m - from_m) * i / kSteps;
      const double sigma_m = std::sqrt(segment.line.distanceVariance_m2(along_m));
      series.points.push_back((segment.line.r0_m + side * kShownSigmas * sigma_m) * normal +
                              along_m * along);
    }
    series.points.emplace_back(std::nan(""), std::nan(""));
  }
}
}  // namespace

Figure segmentFigure(const ExamplePair& pair)
{
  Chart chart = planChart("Segments of a scan");
  chart.xRange = {-1, 10};
  chart.yRange = {-2.5, 4};
  chart.series.push_back(rayPoints("ends of rays", pair.reference, Pose2(), kGrey));
  ChartSeries bands{
      "20 standard deviations of the line", {}, ChartSeries::Style::ThinLine, kVermillion};
  for (const Segment& segment : pair.reference.segments) addBand(segment, bands);
  chart.series.push_back(bands);
  chart.series.push_back(segmentLines("segments", pair.reference, Pose2(), kBlue));
  chart.series.push_back(scannerMark("scanner", Pose2(), 0.5, kBlack));

  Figure figure;
  figure.columns = 1;
  figure.panelWidth_px = 1000;
  figure.panelHeight_px = 720;
  figure.panels = {chart};
  return figure;
}
}  // namespace psmks
