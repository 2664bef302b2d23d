/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/features/MovableObjects.h>
#include <psmks/features/ScanFeatures.h>
#include <psmks/features/ShortLines.h>
#include <psmks/features/Surfels.h>

namespace psmks
{
void ScanFeatures::build(const SegmentedScan& segmented)
{
  scan = &segmented;
  findUnsegmentedRays();
  findMovableObjects(segmented, movable);
  points.build(segmented, movable);
  lines.clear();
  findDepthEdges(segmented, edges);
  findCircles(segmented, circles, circleOfRay);
  findShortLines(segmented, circleOfRay, lineFeatures);
  lineFeatures.insert(lineFeatures.begin(), segmented.segments.begin(), segmented.segments.end());
  for (const Segment& straight : lineFeatures) lines.emplace_back(straight.line);
  lineOfRay = segmented.segmentOfRay;
  for (std::size_t s = segmented.segments.size(); s < lineFeatures.size(); ++s)
    for (int ray = lineFeatures[s].firstRay; ray <= lineFeatures[s].lastRay; ++ray)
      lineOfRay[static_cast<std::size_t>(ray)] = static_cast<int>(s);
  appendSurfels(segmented, lines, lineOfRay);
  closeHoles();
  surface.build(segmented, lines, lineOfRay, hasSurface, movable);
}

/** Where returns are sparse, the rays without a return between two of one segment belong to its
 * surface. */
void ScanFeatures::closeHoles()
{
  hasSurface = scan->valid;
  if (scan->longestHole() == 0) return;
  for (int ray = 0; ray < scan->rays(); ++ray)
  {
    const int line = scan->segmentOfRay[static_cast<std::size_t>(ray)];
    const int next = scan->isValid(ray) ? scan->nextReturn(ray, 1) : -1;
    if (line == SegmentedScan::kNoSegment || next < 0 ||
        scan->segmentOfRay[static_cast<std::size_t>(next)] != line)
      continue;
    for (int hole = scan->grid.neighbour(ray, 1); hole != next;
         hole = scan->grid.neighbour(hole, 1))
    {
      lineOfRay[static_cast<std::size_t>(hole)] = line;
      hasSurface[static_cast<std::size_t>(hole)] = 1;
    }
  }
}

void ScanFeatures::findUnsegmentedRays()
{
  unsegmentedRays.clear();
  const std::uint8_t* valid = scan->valid.data();
  const int *segment = scan->segmentOfRay.data(), rays = scan->rays();
  for (int ray = 0; ray < rays; ++ray)
    if (valid[ray] && segment[ray] == SegmentedScan::kNoSegment) unsegmentedRays.push_back(ray);
}
}  // namespace psmks
