/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/slam/LocalView.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace psmks
{
namespace
{
/** A piece of a surface between two neighbouring returns, in the frame of the view. */
struct Piece
{
  Eigen::Vector2d from_m, to_m;  //!< counter-clockwise, as the scanner saw them
};

/** Whether two neighbouring returns lie on one surface. */
bool areJoined(const Eigen::Vector2d& a_m, const Eigen::Vector2d& b_m, double spacing_m)
{
  /** How far apart returns on one surface are at most, besides the spacing of the rays. Definition:
   * three standard deviations of a noisy range. */
  constexpr double kGap_m = 0.1;

  /** The same in spacings of the rays: a surface at a slant. Unit: spacings. Definition: a slant of
   * 20 degrees to the rays. */
  constexpr double kSpacings = 3;
  return (b_m - a_m).norm() < kGap_m + kSpacings * spacing_m;
}

void addPieces(const PosedScan& posed, const Pose2& T_world_view, std::vector<Piece>& pieces)
{
  const Scan& scan = posed.scan;
  const Pose2 T_view_sensor = T_world_view.inverse() * posed.T_world_sensor();
  for (int ray = 0; ray < scan.grid.count(); ++ray)
  {
    const int next = scan.grid.neighbour(ray, 1);
    if (next < 0 || !isReturn(scan, ray) || !isReturn(scan, next)) continue;
    const double range_m = scan.range_m[static_cast<std::size_t>(ray)];
    const Eigen::Vector2d a_m = range_m * scan.grid.direction(ray);
    const Eigen::Vector2d b_m =
        scan.range_m[static_cast<std::size_t>(next)] * scan.grid.direction(next);
    if (areJoined(a_m, b_m, range_m * scan.grid.increment_rad()))
      pieces.push_back({T_view_sensor * a_m, T_view_sensor * b_m});
  }
}

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

/** What the rays of a view meet of one scan. */
class SeenSurfaces
{
 public:
  explicit SeenSurfaces(const BeamGrid& grid)
      : grid_(grid), rays_(static_cast<std::size_t>(grid.count()))
  {
  }

  void clear() { std::fill(rays_.begin(), rays_.end(), Ray()); }

  void add(const Piece& piece)
  {
    const bool showsFront = cross(piece.from_m, piece.to_m) > 0;
    const Eigen::Vector2d& a_m = showsFront ? piece.from_m : piece.to_m;
    const Eigen::Vector2d& b_m = showsFront ? piece.to_m : piece.from_m;
    const Eigen::Vector2d along_m = b_m - a_m;
    const double area_m2 = cross(a_m, along_m);
    const double first = grid_.index(std::atan2(a_m.y(), a_m.x()));
    double last = grid_.index(std::atan2(b_m.y(), b_m.x()));
    if (last < first) last += grid_.count();
    for (int i = static_cast<int>(std::ceil(first)); i <= static_cast<int>(std::floor(last)); ++i)
    {
      const int ray = (i + grid_.count()) % grid_.count();
      meet(ray, area_m2 / cross(grid_.direction(ray), along_m), showsFront);
    }
  }

  /** Gives the rays that have no return yet those of this scan. */
  void fill(Scan& view) const
  {
    for (std::size_t i = 0; i < rays_.size(); ++i)
    {
      if (view.valid[i] || !std::isfinite(rays_[i].nearest_m) || view.range_m[i] != 0) continue;
      view.range_m[i] = rays_[i].nearest_m;
      view.valid[i] = rays_[i].showsFront ? 1 : 0;
    }
  }

 private:
  struct Ray
  {
    double nearest_m = std::numeric_limits<double>::infinity();
    bool showsFront = false;
  };

  void meet(int ray, double range_m, bool showsFront)
  {
    Ray& seen = rays_[static_cast<std::size_t>(ray)];
    if (range_m > 0 && range_m < seen.nearest_m) seen = {range_m, showsFront};
  }

  BeamGrid grid_;
  std::vector<Ray> rays_;
};

Scan emptyView(const Scan& like)
{
  Scan view;
  const double rays = 2 * kPi / like.grid.increment_rad();
  view.grid = BeamGrid::centered(2 * kPi, static_cast<int>(std::lround(rays)));
  const auto count = static_cast<std::size_t>(view.grid.count());
  view.range_m.assign(count, 0);
  view.valid.assign(count, 0);
  view.rangeSigma_m = like.rangeSigma_m;
  view.stamp_s = like.stamp_s;
  return view;
}
}  // namespace

Scan localView(const std::vector<PosedScan>& scans, const std::vector<std::size_t>& members,
               const Pose2& T_world_view)
{
  if (members.empty()) return {};
  Scan view = emptyView(scans[members.front()].scan);
  std::vector<Piece> pieces;
  SeenSurfaces surfaces(view.grid);
  for (const std::size_t member : members)
  {
    pieces.clear();
    addPieces(scans[member], T_world_view, pieces);
    surfaces.clear();
    for (const Piece& piece : pieces) surfaces.add(piece);
    surfaces.fill(view);
  }
  return view;
}
}  // namespace psmks
