/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-simulate/GridmapSurroundings.h>

namespace psmks
{
Hit GridmapSurroundings::cast(const Eigen::Vector2d& origin_m, const Eigen::Vector2d& direction,
                              double maxRange_m, double time_s) const
{
  const auto reading = map_.cast(origin_m, direction, maxRange_m);
  const double freeRange_m = reading ? reading->range_m : maxRange_m;
  const Hit person = people_.cast(origin_m, direction, freeRange_m, time_s);
  if (person.object != Hit::kNothing)
    return {person.range_m, map_.columns() * map_.rows() + person.object};
  return reading ? Hit{reading->range_m, reading->cell} : Hit{maxRange_m, Hit::kNothing};
}

double GridmapSurroundings::clearance_m(const Eigen::Vector2d& point_m, double limit_m,
                                        double time_s) const
{
  return people_.clearance_m(point_m, map_.clearance_m(point_m, limit_m), time_s);
}

World GridmapSurroundings::drawn() const
{
  World world = people_;
  for (const auto& middle_m : map_.outline_m()) world.addPoint(middle_m);
  return world;
}
}  // namespace psmks
