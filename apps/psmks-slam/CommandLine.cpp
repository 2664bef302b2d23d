/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-slam/CommandLine.h>
#include <apps/psmks-slam/OutputFolder.h>
#include <psmks/matchers/PairMatcher.h>

#include <CLI/CLI.hpp>
#include <algorithm>

namespace psmks
{
namespace
{
constexpr const char* kDescription =
    "Builds the trajectory of a robot and a map from a log by 2D laser scan matching.\n"
    "Every scan gets a pose; where a match fails, odometry carries on.";

constexpr const char* kFooter =
    "Writes summary.json and, unless --outputs chooses, all of\n"
    "  trajectory  trajectory.tum, odometry.tum: the pose of the robot at every scan\n"
    "  matches     matches.csv: every match, with its covariance\n"
    "  graph       graph.g2o: keyframes and the links between them, for g2o, gtsam, graph-slam\n"
    "  grid        map.pgm, map.yaml: occupancy grid, for nav2, map_server, amcl\n"
    "  segments    segments.csv: the line segments of the map\n"
    "  svg         map.svg: the segments as a drawing\n"
    "  picture     map.png: the map as a picture\n"
    "  scene       map.3Dscene: the map for MRPT's viewer\n"
    "  simplemap   map.simplemap: the keyframes for MRPT's programs\n\n"
    "Exit codes: 0 ok; 1 usage or configuration; 2 input missing or damaged (what was read before\n"
    "the damage is saved); 3 no usable scan or odometry; 4 every match failed; 5 an output cannot\n"
    "be written (the others are); 128 + N stopped by signal N (what was done before it is saved).";

/** The names of the registered matchers. The one that keeps its guess is called "odometry" here,
 * for it drives by odometry alone. */
std::vector<std::string> matcherNames()
{
  std::vector<std::string> names = pairMatcherNames();
  std::replace(names.begin(), names.end(), std::string("guess"), std::string("odometry"));
  return names;
}

void addFlags(CLI::App& app, CommandLine& c)
{
  app.add_option("LOG", c.log, "MRPT rawlog or CARMEN log, compressed or not, or ROS 1 bag");
  app.add_option("--sensor-file", c.sensorFile,
                 "options that describe the scanner, see config/sensors; --config overrides them")
      ->type_name("INI");
  app.add_option("-c,--config", c.config, "options, see --print-config")->type_name("INI");
  app.add_option("-m,--matcher", c.matcher, "who estimates the motion between two scans")
      ->type_name("NAME")
      ->check(CLI::IsMember(matcherNames()))
      ->capture_default_str();
  app.add_option("-r,--reference", c.reference, "the scan to match against")
      ->type_name("sequential|keyframe|map")
      ->check(CLI::IsMember({"sequential", "keyframe", "map"}));
  c.logFlags.addTo(app);
  app.add_option("-o,--output", c.output, "folder for the results; default: the log's name + -slam")
      ->type_name("DIR");
  app.add_flag("-w,--overwrite", c.overwrite, "replace results that are there");
  app.add_option("--outputs", c.outputs, "results to write, see below; default: all")
      ->type_name("NAME,...")
      ->delimiter(',')
      ->check(CLI::IsMember(outputNames()))
      ->allow_extra_args(false);
  app.add_flag("--no-picture", c.noPicture, "do not draw map.png, which takes longest");
  app.add_option("--ground-truth", c.groundTruth,
                 "true trajectory: TUM, or lines of 'time x y phi'")
      ->type_name("FILE");
  app.add_option("--relations", c.relations,
                 "true motions: lines of 'from_s to_s x y z roll pitch yaw'")
      ->type_name("FILE");
  app.add_option("--save-rawlog", c.rawlog, "the log with matched motions in place of odometry")
      ->type_name("FILE");
  app.add_option("--save-g2o", c.graph,
                 "the graph of keyframes in the format of g2o, under a name of its own")
      ->type_name("FILE");
  app.add_option("--max-scans", c.maxScans, "stop after so many scans")
      ->type_name("N")
      ->check(CLI::PositiveNumber);
  app.add_option("--set", c.assignments, "one option, over file and defaults; may be repeated")
      ->type_name("STAGE.KEY=VALUE")
      ->allow_extra_args(false);
  app.add_flag("--view", c.view, "show the map in a 3D window");
  app.add_flag("--print-config", c.printConfig, "print all options in effect as an ini file");
  app.add_flag("--print-options", c.printOptions, "print what they mean as Markdown tables");
  app.add_flag("-v,--verbose", c.verbose, "report every match on stderr");
}

void check(CommandLine& commandLine)
{
  if (commandLine.log.empty() && !commandLine.onlyPrints()) throw CLI::RequiredError("LOG");
  auto& outputs = commandLine.outputs;
  if (outputs.empty()) outputs = outputNames();
  if (commandLine.noPicture)
    outputs.erase(std::remove(outputs.begin(), outputs.end(), "picture"), outputs.end());
}
}  // namespace

CommandLineSyntax<CommandLine> commandLineSyntax()
{
  return {{"psmks-slam", PSMKS_VERSION, kDescription, kFooter}, addFlags, check};
}
}  // namespace psmks
