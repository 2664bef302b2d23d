/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/features/FreeStanding.h>
#include <psmks/features/Patches.h>
#include <psmks/features/ScanFeatures.h>
#include <psmks/features/ShortLines.h>

namespace psmks
{
void ScanFeatures::build(const SegmentedScan& segmented)
{
  scan = &segmented;
  findSingles();
  findFreeStanding(segmented, movable);
  points.build(segmented, movable);
  lines.clear();
  findCircles(segmented, circles, circleOfRay);
  findShortLines(segmented, circleOfRay, straights);
  straights.insert(straights.begin(), segmented.segments.begin(), segmented.segments.end());
  for (const Segment& straight : straights) lines.emplace_back(straight.line);
  lineOfRay = segmented.segmentOfRay;
  for (std::size_t s = segmented.segments.size(); s < straights.size(); ++s)
    for (int ray = straights[s].firstRay; ray <= straights[s].lastRay; ++ray)
      lineOfRay[static_cast<std::size_t>(ray)] = static_cast<int>(s);
  appendPatches(segmented, lines, lineOfRay);
  surface.build(segmented, lines, lineOfRay, movable);
}

void ScanFeatures::findSingles()
{
  singles.clear();
  const std::uint8_t* valid = scan->valid.data();
  const int *segment = scan->segmentOfRay.data(), rays = scan->rays();
  for (int ray = 0; ray < rays; ++ray)
    if (valid[ray] && segment[ray] == SegmentedScan::kNoSegment) singles.push_back(ray);
}
}  // namespace psmks
