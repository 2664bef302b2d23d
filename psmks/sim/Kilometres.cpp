/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/sim/Box.h>
#include <psmks/sim/Frontage.h>
#include <psmks/sim/Kilometres.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace psmks
{
namespace
{
constexpr double kBetweenCorridors_m = 14;  // between the middles of neighbouring corridors
constexpr double kBeyondCorridors_m = 3;    // a hall begins so far before the middle of its first
constexpr double kNarrowHall_m = 9, kWideHall_m = 20;
constexpr double kToDeadEnd_m = 1.5;  // from the ends of the route to the walls behind them

/** How one corridor leads to the next: through a hall on the right or on the left. */
struct Hall
{
  double low_m, high_m;  //!< its extent in y
  double begin_m;        //!< x of the side where the corridors end
  double width_m;        //!< from there on, negative to the left

  Eigen::Vector2d corner(double share, bool isHigh) const
  {
    return {begin_m + share * width_m, isHigh ? high_m : low_m};
  }
};

/** Corridors one above the other, which are joined by halls in turns on the right and left. */
class KilometresBuilder
{
 public:
  explicit KilometresBuilder(unsigned seed)
      : random_(seed), length_m_(draw(60, 100)), corridors_(corridorsFor(seed))
  {
  }

  Site build()
  {
    for (int corridor = 0; corridor < corridors_; ++corridor) addCorridor(corridor);
    addEnd(0, false);
    addEnd(corridors_ - 1, (corridors_ - 1) % 2 == 0);
    const Route thereAndBack = route();
    const Eigen::Vector2d start_m = thereAndBack.front();
    return {world_, {start_m.x(), start_m.y(), 0}, thereAndBack};
  }

 private:
  double draw(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

  /** As many as a way of 1, 2, 3, 4 or 5 km needs, for successive seeds. */
  int corridorsFor(unsigned seed) const
  {
    constexpr unsigned kLengths = 5;
    constexpr double kThroughHall_m = kBetweenCorridors_m + (kNarrowHall_m + kWideHall_m) / 2;
    const double way_m = kShortestWay_m * (1 + (seed + kLengths - 1) % kLengths);
    return 1 + static_cast<int>(std::ceil((way_m - length_m_) / (length_m_ + kThroughHall_m)));
  }

  static double middle_m(int corridor) { return corridor * kBetweenCorridors_m; }

  /** Adds recessed doors and pilasters at places that do not repeat. */
  void decorate(Frontage& frontage, double margin_m)
  {
    for (double at_m = margin_m + draw(0, 6); at_m < frontage.length_m() - margin_m;
         at_m += draw(2.5, 9))
    {
      if (draw(0, 1) < 0.6)
        frontage.add({at_m, draw(0.9, 1.3), draw(0.1, 0.35)});
      else
        frontage.add({at_m, draw(0.3, 0.7), -draw(0.08, 0.25)});
    }
    frontage.drawInto(world_);
  }

  void addCorridor(int corridor)
  {
    constexpr double kMargin_m = 1.5;
    const double half_m = draw(0.9, 1.4), y_m = middle_m(corridor);
    Frontage below({0, y_m - half_m}, {length_m_, y_m - half_m});
    Frontage above({length_m_, y_m + half_m}, {0, y_m + half_m});
    decorate(below, kMargin_m);
    decorate(above, kMargin_m);
    halfWidths_m_.push_back(half_m);
    if (corridor > 0) addHall(corridor - 1);
  }

  /** The wall across the beginning or the end of a corridor. */
  void addEnd(int corridor, bool isRight)
  {
    const double half_m = halfWidths_m_[static_cast<std::size_t>(corridor)];
    const double x_m = isRight ? length_m_ : 0;
    world_.addWall({{x_m, middle_m(corridor) - half_m}, {x_m, middle_m(corridor) + half_m}});
  }

  /** Adds the hall from a corridor to the next one. */
  void addHall(int corridor)
  {
    const bool isRight = corridor % 2 == 0;
    const double width_m = draw(kNarrowHall_m, kWideHall_m);
    widths_m_.push_back(width_m);
    const Hall hall{middle_m(corridor) - kBeyondCorridors_m,
                    middle_m(corridor + 1) + kBeyondCorridors_m, isRight ? length_m_ : 0,
                    isRight ? width_m : -width_m};
    addWalls(hall, isRight);
    addMouths(hall, corridor, isRight);
    addPillars(hall);
  }

  /** The three sides of a hall where no corridor ends. */
  void addWalls(const Hall& hall, bool isRight)
  {
    constexpr double kMargin_m = 1;
    const bool first = !isRight;  // counterclockwise, so that the hall is on the left
    std::vector<Eigen::Vector2d> corners{hall.corner(0, first), hall.corner(1, first),
                                         hall.corner(1, !first), hall.corner(0, !first)};
    for (std::size_t i = 0; i + 1 < corners.size(); ++i)
    {
      Frontage side(corners[i], corners[i + 1]);
      decorate(side, kMargin_m);
    }
  }

  /** The side of a hall where two corridors end. */
  void addMouths(const Hall& hall, int corridor, bool isRight)
  {
    Frontage side(hall.corner(0, isRight), hall.corner(0, !isRight));
    for (const int c : {corridor, corridor + 1})
    {
      const double y_m = middle_m(c);
      const double along_m = isRight ? hall.high_m - y_m : y_m - hall.low_m;
      side.add({along_m, 2 * halfWidths_m_[static_cast<std::size_t>(c)], 0, false});
    }
    side.drawInto(world_);
  }

  /** Pillars and benches in a hall, clear of the way through it. */
  void addPillars(const Hall& hall)
  {
    constexpr double kClear_m = 1.3;
    const int pieces = static_cast<int>(draw(5, 12));
    for (int piece = 0; piece < pieces; ++piece)
    {
      const Eigen::Vector2d place_m(hall.begin_m + draw(0.1, 0.9) * hall.width_m,
                                    draw(hall.low_m + 1, hall.high_m - 1));
      const Eigen::Vector2d size_m(draw(0.3, 1.0), draw(0.3, 0.6));
      const double turn_rad = draw(0, kPi);
      if (distanceToWay_m(hall, place_m) > kClear_m) world_.addBox(place_m, size_m, turn_rad);
    }
  }

  /** From a point of a hall to the way through it, which has three straight parts. */
  static double distanceToWay_m(const Hall& hall, const Eigen::Vector2d& point_m)
  {
    const double across_m = std::abs(point_m.x() - hall.corner(0.5, false).x());
    const double below_m = std::abs(point_m.y() - (hall.low_m + kBeyondCorridors_m));
    const double above_m = std::abs(point_m.y() - (hall.high_m - kBeyondCorridors_m));
    return std::min({across_m, below_m, above_m});
  }

  /** Through the middles of all corridors and halls, and the same way back. */
  Route route() const
  {
    Route there{{kToDeadEnd_m, 0}};
    for (int corridor = 0; corridor + 1 < corridors_; ++corridor)
    {
      const double half_m = widths_m_[static_cast<std::size_t>(corridor)] / 2;
      const double x_m = corridor % 2 == 0 ? length_m_ + half_m : -half_m;
      there.emplace_back(x_m, middle_m(corridor));
      there.emplace_back(x_m, middle_m(corridor + 1));
    }
    const double end_m = (corridors_ - 1) % 2 == 0 ? length_m_ - kToDeadEnd_m : kToDeadEnd_m;
    there.emplace_back(end_m, middle_m(corridors_ - 1));
    Route thereAndBack = there;
    thereAndBack.insert(thereAndBack.end(), there.rbegin() + 1, there.rend());
    return thereAndBack;
  }

  std::mt19937_64 random_;
  double length_m_;
  int corridors_;
  World world_;
  std::vector<double> halfWidths_m_;  //!< of the corridors
  std::vector<double> widths_m_;      //!< of the halls, in x
};
}  // namespace

//          +------------------------------------   28 m    the third corridor
//     +----+   ---------------------------------
//     | hall   .
//     |      +--------------------------------+-------+
//     |                                        pillars |  14 m
//     +------+-------------------------------+    .    |
//                                            |  hall   |
//     +--------------------------------------+         |
//     | start                                          |   0 m
//     +--------------------------------------+---------+
//     0                                   60 to 100 m
Site makeKilometres(unsigned seed) { return KilometresBuilder(seed).build(); }
}  // namespace psmks
