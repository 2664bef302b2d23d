/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/sim/Frontage.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
Frontage::Frontage(const Eigen::Vector2d& a_m, const Eigen::Vector2d& b_m)
    : T_world_a_{a_m.x(), a_m.y(), std::atan2(b_m.y() - a_m.y(), b_m.x() - a_m.x())},
      length_m_((b_m - a_m).norm())
{
}

void Frontage::drawInto(World& world) const
{
  std::vector<Feature> sorted = features_;
  std::sort(sorted.begin(), sorted.end(),
            [](const Feature& a, const Feature& b) { return a.centre_m < b.centre_m; });
  double here_m = 0;
  for (const Feature& feature : sorted)
  {
    const double begin_m = feature.centre_m - feature.width_m / 2;
    const double end_m = feature.centre_m + feature.width_m / 2, depth_m = feature.depth_m;
    world.addWall({at(here_m, 0), at(begin_m, 0)});
    if (depth_m != 0) world.addWall({at(begin_m, 0), at(begin_m, depth_m)});
    if (feature.hasBack) world.addWall({at(begin_m, depth_m), at(end_m, depth_m)});
    if (depth_m != 0) world.addWall({at(end_m, depth_m), at(end_m, 0)});
    here_m = end_m;
  }
  world.addWall({at(here_m, 0), at(length_m_, 0)});
}
}  // namespace psmks
