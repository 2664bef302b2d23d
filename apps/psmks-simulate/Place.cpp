/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-simulate/GridmapSurroundings.h>
#include <apps/psmks-simulate/Place.h>
#include <apps/support/ExitCode.h>
#include <psmks/logs/GuardedProcess.h>
#include <psmks/sim/MapFile.h>
#include <psmks/sim/People.h>
#include <psmks/sim/WorldIndex.h>
#include <psmks/sim/Worlds.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace psmks
{
namespace
{
bool endsIn(const std::string& text, const std::string& ending)
{
  return text.size() >= ending.size() &&
         text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

bool isSiteName(const std::string& name)
{
  const auto names = siteNames();
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::ifstream openInput(const std::string& path)
{
  std::ifstream file(path);
  if (!file) throw ProgramError(kInputDamaged, "'" + path + "': no such file, or not to be read");
  return file;
}

Site readSite(const std::string& path)
{
  std::ifstream file = openInput(path);
  try
  {
    return readMapFile(file);
  }
  catch (const MapFileError& error)
  {
    throw ProgramError(kInputDamaged, "'" + path + "': " + error.what());
  }
}

Route readRouteFile(const std::string& path)
{
  std::ifstream file = openInput(path);
  try
  {
    return readRoute(file);
  }
  catch (const std::runtime_error& error)
  {
    throw ProgramError(kInputDamaged, "'" + path + "': " + error.what());
  }
}

/** A pose at the first point of a route that faces the second point. */
Pose2 startOf(const Route& route)
{
  const Eigen::Vector2d way_m = route[1] - route[0];
  return {route[0].x(), route[0].y(), std::atan2(way_m.y(), way_m.x())};
}

/** Chooses the start pose of the robot, which has to be known before people are placed. */
void placeRobot(const CommandLine& c, Place& place)
{
  if (!c.route.empty()) place.route = readRouteFile(c.route);
  if (c.driver == "area-center") place.route.clear();
  Pose2& start = place.T_world_start;
  if (!place.route.empty()) start = startOf(place.route);
  start.x_m = c.startX_m.value_or(start.x_m);
  start.y_m = c.startY_m.value_or(start.y_m);
  if (c.startPhi_deg) start.phi_rad = wrapAngle(degToRad(*c.startPhi_deg));
}

Place placeOf(const CommandLine& c, Site site)
{
  Place place;
  place.T_world_start = site.T_world_start;
  place.route = site.route.value_or(Route());
  placeRobot(c, place);
  const WorldIndex still(site.world);
  for (auto& person : peopleAround(still, place.T_world_start.translation(), c.people, c.seed))
    site.world.addMovingObject(std::move(person));
  place.contents = std::to_string(site.world.walls().size()) + " walls, " +
                   std::to_string(site.world.points().size()) + " points";
  place.drawn = site.world;
  place.surroundings = std::make_unique<WorldIndex>(std::move(site.world));
  return place;
}

Place placeOf(const CommandLine& c, GridmapRanges map)
{
  std::ostringstream contents;
  contents << map.columns() << " x " << map.rows() << " cells of " << map.cell_m() << " m";
  Place place;
  place.contents = contents.str();
  const Eigen::Vector2d start_m = map.roomiestPlace_m();
  place.T_world_start = {start_m.x(), start_m.y(), 0};
  placeRobot(c, place);
  auto surroundings = std::make_unique<GridmapSurroundings>(std::move(map));
  for (auto& person :
       peopleAround(*surroundings, place.T_world_start.translation(), c.people, c.seed))
    surroundings->add(std::move(person));
  place.drawn = surroundings->drawn();
  place.surroundings = std::move(surroundings);
  return place;
}

/** Memory that a grid map may take: a thousand times its file, which is how much gzip makes of it,
 * but at least 64 MB and at most 1 GB. */
std::size_t mapMemory_bytes(const std::string& path)
{
  constexpr std::size_t kTimes = 1000, kLeast = std::size_t{1} << 26, kMost = std::size_t{1} << 30;
  std::error_code ignored;
  const std::size_t file_bytes = std::filesystem::file_size(path, ignored);
  return file_bytes > kMost / kTimes ? kMost : std::max(kLeast, kTimes * file_bytes);
}

/** Reads a map, which MRPT decodes: first in a process of its own, for one that is damaged can
 * crash its decoder. */
GridmapRanges readGridmap(const std::string& path, std::optional<double> pixel_m)
{
  if (endsIn(path, ".gridmap") || endsIn(path, ".gridmap.gz"))
  {
    if (!endsWell(mapMemory_bytes(path), [&path] { loadGridmap(path); }))
      throw GridmapError("'" + path + "' is no MRPT grid map, or is damaged");
    return loadGridmap(path);
  }
  if (!pixel_m)
    throw ProgramError(kUsage, "'" + path + "' is an image by its name, add --resolution_m");
  return loadImageAsGridmap(path, *pixel_m);
}

/** Loads a world of any kind. */
Place makePlace(const CommandLine& c)
{
  if (isSiteName(c.world)) return placeOf(c, makeSite(c.world, c.seed));
  if (!std::filesystem::exists(c.world))
    throw ProgramError(kInputDamaged, "'" + c.world + "' is no file and no world of --list-worlds");
  if (endsIn(c.world, ".map")) return placeOf(c, readSite(c.world));
  try
  {
    return placeOf(c, readGridmap(c.world, c.resolution_m));
  }
  catch (const GridmapError& error)
  {
    throw ProgramError(kInputDamaged, error.what());
  }
}

void requireSpace(const Place& place, double robotRadius_m)
{
  const Eigen::Vector2d start_m = place.T_world_start.translation();
  if (place.surroundings->clearance_m(start_m, robotRadius_m, 0) >= robotRadius_m) return;
  std::ostringstream sentence;
  sentence << "the robot does not fit in at its start, x " << start_m.x() << " m, y " << start_m.y()
           << " m";
  throw ProgramError(kUsage, sentence.str());
}
}  // namespace

Place loadPlace(const CommandLine& commandLine, double robotRadius_m)
{
  Place place = makePlace(commandLine);
  requireSpace(place, robotRadius_m);
  return place;
}
}  // namespace psmks
