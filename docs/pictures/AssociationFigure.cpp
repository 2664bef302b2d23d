/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <docs/pictures/Pictures.h>
#include <psmks/features/ScanFeatures.h>
#include <psmks/joint/LinePairing.h>

namespace psmks
{
namespace
{
/** From the anchor of each current line to the reference line that it is paired with. */
ChartSeries pairLinks(const JointProblem& problem, const Pose2& T_ref_cur)
{
  std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> links;
  for (const LinePairTerm& pair : problem.linePairs)
  {
    const Eigen::Vector2d anchor_m = T_ref_cur * pair.curAnchor_m;
    const double distance_m = pair.refNormal.dot(anchor_m) - pair.refDistance_m;
    links.emplace_back(anchor_m, anchor_m - distance_m * pair.refNormal);
  }
  ChartSeries series = lineSegments("paired", links);
  series.style = ChartSeries::Style::Line;
  series.rgb = kVermillion;
  return series;
}

Chart associationChart(const std::string& title, const ExamplePair& pair, const Pose2& T_ref_cur,
                       const PairingGates& gates)
{
  ScanFeatures reference, current;
  reference.build(pair.reference);
  current.build(pair.current);
  JointProblem problem;
  associateFeatures(reference, current, T_ref_cur, gates, problem);

  Chart chart =
      planChart(title + ": " + std::to_string(problem.linePairs.size()) + " pairs of lines");
  chart.xRange = {-0.5, 6};
  chart.yRange = {-1.5, 3.5};
  chart.series = {segmentLines("reference segments", pair.reference, Pose2(), kBlack),
                  segmentLines("current segments", pair.current, T_ref_cur, kBlue),
                  pairLinks(problem, T_ref_cur), scannerMark("", Pose2(), 0.5, kBlack),
                  scannerMark("", T_ref_cur, 0.5, kBlue)};
  return chart;
}
}  // namespace

Figure associationFigure(const ExamplePair& pair)
{
  const JointOptions options = MatcherOptions().joint;
  const PairingGates first{options.distanceGate_m, options.angleGate_rad, options.singleRayWeight};
  Figure figure;
  figure.panelHeight_px = 640;
  figure.panels = {associationChart("At the guess", pair, pair.guess.T_ref_cur, first),
                   associationChart("At the result", pair, pair.result.T_ref_cur, first)};
  return figure;
}
}  // namespace psmks
