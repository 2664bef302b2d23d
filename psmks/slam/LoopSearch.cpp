/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/slam/LocalView.h>
#include <psmks/slam/LoopSearch.h>
#include <psmks/slam/Overlap.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace psmks
{
namespace
{
/** What the poses of the scans of a local map leave open beside each other. Evidence: the map of
 * Acapulco is 0.34 m off with 3 to 4 cm; with 10 cm that of fr079 is 0.050 m in place of 0.042. */
constexpr double kFitting_m = 0.04;

/** Two places farther apart are two, each to be searched. Evidence: the map of Freiburg campus is
 * 0.39 m off with 2 m, 0.48 with 4 and 8 m; that of Acapulco 0.29, 0.34 and 1.61 m. */
constexpr double kAnotherPlace_m = 2;

bool contains(const std::vector<std::size_t>& indices, std::size_t index)
{
  return std::find(indices.begin(), indices.end(), index) != indices.end();
}

/** Where a place is, seen from the robot. */
Eigen::Vector2d position_m(const KeyframeMap::UncertainKeyframe& place)
{
  return place.T_keyframe_cur.pose.inverse().translation();
}

bool areApart(const KeyframeMap::UncertainKeyframe& a, const KeyframeMap::UncertainKeyframe& b)
{
  return (position_m(a) - position_m(b)).norm() > kAnotherPlace_m;
}

/** Whether nothing stands between the robot and a position. */
bool isInSight(const Eigen::Vector2d& position_m, const Scan& view)
{
  const double index = view.grid.index(std::atan2(position_m.y(), position_m.x()));
  const int ray = static_cast<int>(std::lround(index)) % view.grid.count();
  return !isReturn(view, ray) || view.range_m[static_cast<std::size_t>(ray)] > position_m.norm();
}

/** Whether all places say the same of where the robot is. Where they do not, some of them look
 * alike and are not what they are taken for. */
bool agree(const std::vector<LoopSearch::Recognised>& places)
{
  /** How far poses may be apart that mean the same. Evidence: what the places themselves may be
   * apart, for the map is not settled; far below the distance of things that look alike. */
  constexpr double kSame_m = 0.5, kSame_rad = degToRad(5);
  const Pose2& first = places.front().T_world_cur;
  return std::all_of(places.begin(), places.end(),
                     [&first](const LoopSearch::Recognised& place)
                     {
                       const Pose2 apart = first.inverse() * place.T_world_cur;
                       return apart.translation().norm() < kSame_m &&
                              std::abs(apart.phi_rad) < kSame_rad;
                     });
}

/** The link by a match of views, the scans of which do not fit each other better than that. */
void widen(ReferenceMatch& match, const Eigen::Matrix3d& guess)
{
  const double turned_rad = kFitting_m / kLeftOpenLever_m;
  const Eigen::Matrix3d fitting =
      Eigen::Vector3d(kFitting_m * kFitting_m, kFitting_m * kFitting_m, turned_rad * turned_rad)
          .asDiagonal();
  match.T_ref_cur.covariance += fitting;
  match.information = informationBeyond(guess + fitting, match.T_ref_cur.covariance);
}
}  // namespace

std::vector<ReferenceMatch> LoopSearch::links(const std::vector<PosedScan>& scans,
                                              std::size_t index, std::size_t keyframe,
                                              const UncertainPose& T_keyframe_cur,
                                              const KeyframeMap& map, PosedScanMatcher& matcher)
{
  std::vector<ReferenceMatch> links;
  std::vector<Place> places = map.possiblePlaces();
  if (places.empty() || policy_.loopPlaces() == 0) return links;
  searches_.resize(scans.size(), 0);
  Here here{scans, index, {index}, {}, matcher};
  const double open_m = kFitting_m - leftOpen_m(T_keyframe_cur.covariance);
  for (const std::size_t member : map.localMap(keyframe, open_m)) here.members.push_back(member);
  here.view = localView(scans, here.members, scans[index].T_world_robot.pose);
  std::vector<Recognised> recognised;
  for (const Place& place : choose(std::move(places), here.view))
    recognise(place, map.localMap(place.keyframe, kFitting_m), here, recognised);
  if (recognised.empty() || !agree(recognised)) return links;
  std::fill(searches_.begin(), searches_.end(), 0);
  for (Recognised& place : recognised) linkTo(std::move(place), here, links);
  return links;
}

/** How late a place is searched: what was searched in vain or is out of sight comes later. */
double LoopSearch::urgency(const Place& place, const Scan& view) const
{
  const double share = place.T_keyframe_cur.pose.translation().norm() /
                       policy_.loopReach_m(place.T_keyframe_cur.covariance);
  return share + searches_[place.keyframe] + (isInSight(position_m(place), view) ? 0 : 1);
}

/** The places to search, most urgent first. They and all beside them count as searched. */
std::vector<LoopSearch::Place> LoopSearch::choose(std::vector<Place> places, const Scan& view)
{
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < places.size(); ++i) order.emplace_back(urgency(places[i], view), i);
  std::sort(order.begin(), order.end());
  std::vector<Place> chosen;
  for (const auto& [urgency, i] : order)
  {
    const Place& place = places[i];
    const bool isAnother =
        std::all_of(chosen.begin(), chosen.end(),
                    [&place](const Place& other) { return areApart(other, place); });
    if (isAnother && chosen.size() < policy_.loopPlaces()) chosen.push_back(place);
  }
  for (const Place& place : places)
    for (const Place& searched : chosen)
      if (!areApart(place, searched))
      {
        ++searches_[place.keyframe];
        break;
      }
  return chosen;
}

/** Finds out whether the view of the scan shows a place.
 *  @param members scans of the place; those that the view of the scan shows are left out, for a
 * place is not matched against itself */
void LoopSearch::recognise(const Place& place, std::vector<std::size_t> members, Here& here,
                           std::vector<Recognised>& recognised) const
{
  const auto isHere = [&here](std::size_t member) { return contains(here.members, member); };
  members.erase(std::remove_if(members.begin(), members.end(), isHere), members.end());
  if (members.empty()) return;
  const Pose2& T_world_keyframe = here.scans[place.keyframe].T_world_robot.pose;
  ReferenceMatch match =
      here.matcher.matchViews(place.keyframe, localView(here.scans, members, T_world_keyframe),
                              here.view, place.T_keyframe_cur);
  if (!policy_.isLink(match.result) || match.result.ambiguity) return;
  widen(match, place.T_keyframe_cur.covariance);
  const Pose2 T_world_cur = T_world_keyframe * match.T_ref_cur.pose;
  recognised.push_back({std::move(match), T_world_cur, std::move(members)});
}

/** Links the scan to keyframes of a place that saw the same, else to the place as a whole. */
void LoopSearch::linkTo(Recognised place, Here& here, std::vector<ReferenceMatch>& links) const
{
  const std::vector<ReferenceMatch> direct =
      matchesAt(place.T_world_cur, std::move(place.members), here);
  if (direct.empty())
    links.push_back(std::move(place.match));
  else
    links.insert(links.end(), direct.begin(), direct.end());
}

/** Matches the scan itself against the nearest keyframes of a place that saw enough of it. */
std::vector<ReferenceMatch> LoopSearch::matchesAt(const Pose2& T_world_cur,
                                                  std::vector<std::size_t> members,
                                                  Here& here) const
{
  /** Most of these matches. Unit: matches. Evidence: with four the same maps come about. */
  constexpr std::size_t kMost = 2;
  const auto seenFrom = [&](std::size_t member)
  { return here.scans[member].T_world_robot.pose.inverse() * T_world_cur; };
  const auto isNearer = [&](std::size_t a, std::size_t b)
  { return policy_.normalizedDistance(seenFrom(a)) < policy_.normalizedDistance(seenFrom(b)); };
  std::sort(members.begin(), members.end(), isNearer);
  const PosedScan& current = here.scans[here.index];
  std::vector<ReferenceMatch> matches;
  for (const std::size_t member : members)
  {
    const PosedScan& keyframe = here.scans[member];
    const Pose2 T_ref_cur = seenFrom(member);
    const Pose2 ofSensors = keyframe.T_robot_sensor.inverse() * T_ref_cur * current.T_robot_sensor;
    if (matches.size() == kMost || !policy_.isWithinReach(T_ref_cur) ||
        !policy_.overlapsEnough(overlap(keyframe.scan, current.scan, ofSensors)))
      continue;
    ReferenceMatch match = here.matcher.match(
        here.scans, member, here.index, {T_ref_cur, vagueCovariance()}, SearchScope::NearGuess);
    if (policy_.isLink(match.result) && !match.result.ambiguity)
      matches.push_back(std::move(match));
  }
  return matches;
}
}  // namespace psmks
