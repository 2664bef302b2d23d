/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/core/Matcher.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace
{
/** A room of 8 m x 6 m, seen from a place between its walls. */
psmks::Scan roomFrom(double x_m, double y_m)
{
  psmks::Scan scan;
  scan.grid = psmks::BeamGrid::centered(2 * psmks::kPi, 360);
  for (int i = 0; i < scan.grid.count(); ++i)
  {
    const Eigen::Vector2d u = scan.grid.direction(i);
    const double wallX_m = std::copysign(4, u.x()), wallY_m = std::copysign(3, u.y());
    scan.range_m.push_back(std::min((wallX_m - x_m) / u.x(), (wallY_m - y_m) / u.y()));
  }
  return scan;
}
}  // namespace

int main()
{
  const psmks::Matcher matcher;
  psmks::MatcherWorkspace workspace;
  const psmks::MatchResult match = matcher.match(roomFrom(0, 0), roomFrom(0.3, 0.1), {}, workspace);
  std::cout << match.report() << '\n';
  const bool right = std::hypot(match.T_ref_cur.x_m - 0.3, match.T_ref_cur.y_m - 0.1) < 1e-3;
  return match.usable() && right ? 0 : 1;
}
