/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <docs/pictures/Pictures.h>
#include <psmks/paper/Projection.h>

namespace psmks
{
Figure projectionFigure(const ExamplePair& pair)
{
  DenoisedRays rays;
  rays.assign(pair.current);
  Projection projection;
  projectScan(rays, pair.current, pair.result.T_ref_cur, pair.reference, projection);

  ChartSeries visible{
      "current rays, visible from the reference", {}, ChartSeries::Style::Points, kBlue};
  ChartSeries hidden{"hidden, or seen from behind", {}, ChartSeries::Style::Points, kVermillion};
  ChartSeries outside{"outside its field of view", {}, ChartSeries::Style::Points, kGreen};
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    const RayMark mark = projection.mark[i];
    ChartSeries& series = mark == RayMark::Visible       ? visible
                          : mark == RayMark::OutsideView ? outside
                                                         : hidden;
    series.points.emplace_back(projection.x_m[i], projection.y_m[i]);
  }

  Chart chart = planChart("The current scan, projected to the viewpoint of the reference scan");
  chart.xRange = {-4, 16};
  chart.yRange = {-14, 12};
  chart.series = {
      segmentLines("segments of the reference scan", pair.reference, Pose2(), kDarkGrey),
      visible,
      hidden,
      outside,
      scannerMark("reference scanner", Pose2(), 1, kBlack),
      scannerMark("current scanner", pair.result.T_ref_cur, 1, kBlue)};

  Figure figure;
  figure.columns = 1;
  figure.panelWidth_px = 1000;
  figure.panelHeight_px = 1000;
  figure.panels = {chart};
  return figure;
}
}  // namespace psmks
