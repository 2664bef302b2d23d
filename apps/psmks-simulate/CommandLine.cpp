/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-simulate/CommandLine.h>

#include <CLI/CLI.hpp>

namespace psmks
{
namespace
{
constexpr const char* kDescription =
    "Drives a simulated robot with a laser scanner through a world and writes an MRPT rawlog with\n"
    "its ground truth. The same seed gives the same bytes.";

constexpr const char* kFooter =
    "Beside FILE.rawlog it writes FILE.gt.tum and FILE.GT.txt, the true poses of the robot at its\n"
    "scans (TUM; 'time x y phi' as MRPT's graphslam-engine reads it), and FILE.world.png.\n\n"
    "Exit codes: 0 ok; 1 usage; 2 a world or a route is missing or damaged; 5 an output cannot be\n"
    "written; 128 + N stopped by signal N (what was driven before it is written).";

const CLI::Range kNotNegative(0.0, 1e6);

void addWorldFlags(CLI::App& app, CommandLine& c)
{
  app.add_option("--world", c.world,
                 "a name of --list-worlds, an ActivMedia .map, an MRPT .gridmap[.gz] or an image")
      ->type_name("NAME|FILE");
  app.add_option("--resolution_m", c.resolution_m, "size of a pixel, where the world is an image")
      ->type_name("M")
      ->check(CLI::PositiveNumber);
  app.add_option("--start_x_m", c.startX_m, "where the robot starts; default: the world's place")
      ->type_name("M");
  app.add_option("--start_y_m", c.startY_m)->type_name("M");
  app.add_option("--start_phi_deg", c.startPhi_deg)->type_name("DEG");
  app.add_option("--people", c.people, "so many people walk about")
      ->type_name("N")
      ->check(CLI::Range(0, 1000));
}

void addDriveFlags(CLI::App& app, CommandLine& c)
{
  app.add_option("--driver", c.driver, "default: route where there is one")
      ->type_name("area-center|route")
      ->check(CLI::IsMember({"area-center", "route"}));
  app.add_option("--route", c.route, "points to drive along, 'x y' in metres a line")
      ->type_name("FILE");
  app.add_option("--minutes", c.minutes, "at most; the end of a route ends the drive too")
      ->type_name("M")
      ->check(CLI::Range(0.0, 1440.0))
      ->capture_default_str();
  app.add_option("--seed", c.seed, "of the world, the people, the driver and all noise")
      ->type_name("N")
      ->capture_default_str();
  app.add_option("--wheel_noise", c.wheelNoise, "a wheel's speed is wrong by up to this share")
      ->type_name("SHARE")
      ->check(CLI::Range(0.0, 0.9))
      ->capture_default_str();
}

/** Flags for the rays of the scanner and its maximum range. */
void addScannerFlags(CLI::App& app, CommandLine& c)
{
  app.add_option("--rays", c.rays, "of a scan")
      ->type_name("N")
      ->check(CLI::Range(2, 100000))
      ->capture_default_str();
  app.add_option("--fov_deg", c.fieldOfView_deg, "from the first to the last ray; 360: all round")
      ->type_name("DEG")
      ->check(CLI::Range(1.0, 360.0))
      ->capture_default_str();
  app.add_option("--max_range_m", c.maxRange_m)
      ->type_name("M")
      ->check(CLI::Range(0.1, 1000.0))
      ->capture_default_str();
}

/** Flags for the errors of the ranges. */
void addRangeFaultFlags(CLI::App& app, CommandLine& c)
{
  app.add_option("--range_sigma_m", c.rangeSigma_m, "standard deviation of a range")
      ->type_name("M")
      ->check(kNotNegative)
      ->capture_default_str();
  app.add_option("--quantum_m", c.quantum_m, "ranges are multiples of it; 0: exact")
      ->type_name("M")
      ->check(kNotNegative)
      ->capture_default_str();
  app.add_option("--drop_out_share", c.dropOutShare, "of the returns are lost")
      ->type_name("SHARE")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  app.add_option("--beam_divergence_deg", c.beamDivergence_deg,
                 "width of a beam, which mixes the ranges at edges; 0: none")
      ->type_name("DEG")
      ->check(CLI::Range(0.0, 10.0))
      ->capture_default_str();
  app.add_option("--sweep_s", c.sweep_s, "from the first to the last ray, each from its own pose")
      ->type_name("S")
      ->check(CLI::Range(0.0, 0.1))
      ->capture_default_str();
  app.add_option("--interleaved_turns", c.interleavedTurns,
                 "of the beam that share the rays of a scan, each as long as --sweep_s says")
      ->type_name("N")
      ->check(CLI::Range(1, 8))
      ->capture_default_str();
}

void addMountingFlags(CLI::App& app, CommandLine& c)
{
  app.add_option("--laser_x_m", c.laserX_m, "of the scanner on the robot")
      ->type_name("M")
      ->capture_default_str();
  app.add_option("--laser_y_m", c.laserY_m)->type_name("M")->capture_default_str();
  app.add_option("--laser_phi_deg", c.laserPhi_deg)->type_name("DEG")->capture_default_str();
}

void addOutputFlags(CLI::App& app, CommandLine& c)
{
  app.add_option("-o,--output", c.output, "the rawlog")->type_name("FILE.rawlog");
  app.add_option("--format", c.format, "kind of rawlog")
      ->type_name("actions|observations")
      ->check(CLI::IsMember({"actions", "observations"}))
      ->capture_default_str();
  app.add_flag("-w,--overwrite", c.overwrite, "replace results that are there");
  app.add_flag("--list-worlds", c.listWorlds, "print the worlds that are known by name");
}

void addFlags(CLI::App& app, CommandLine& c)
{
  addWorldFlags(app, c);
  addDriveFlags(app, c);
  addScannerFlags(app, c);
  addRangeFaultFlags(app, c);
  addMountingFlags(app, c);
  addOutputFlags(app, c);
}

void requireWorldAndOutput(const CommandLine& commandLine)
{
  if (commandLine.listWorlds) return;
  if (commandLine.world.empty()) throw CLI::RequiredError("--world");
  if (commandLine.output.empty()) throw CLI::RequiredError("--output");
}
}  // namespace

CommandLineSyntax<CommandLine> commandLineSyntax()
{
  return {
      {"psmks-simulate", PSMKS_VERSION, kDescription, kFooter}, addFlags, requireWorldAndOutput};
}
}  // namespace psmks
