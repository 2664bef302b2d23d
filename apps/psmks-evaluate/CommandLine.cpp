/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-evaluate/CommandLine.h>

#include <CLI/CLI.hpp>

namespace psmks
{
namespace
{
constexpr const char* kDescription =
    "Holds estimated trajectories against a ground truth, or against relations: true motions\n"
    "between places, as of Kuemmerle et al., Autonomous Robots 27 (2009).";

constexpr const char* kFooter =
    "Of a ground truth, interpolated to the stamps of the estimate, the tables show the errors\n"
    "  poses, first laid over    the first common poses lie on each other\n"
    "  poses, aligned            the least sum of squared distances, without scale\n"
    "  steps                     of the motions from pose to pose of the ground truth\n"
    "  over 10 m                 of the motions over 10 m of the true path: 'over 1 m' is per "
    "metre\n"
    "and of relations those of all, of those that span little time, and of the rest. A trajectory\n"
    "is TUM ('stamp x y z qx qy qz qw') or 'stamp x y phi', in m and rad; a relation 'from_s to_s\n"
    "x y z roll pitch yaw'; '#' and '%' begin comments. Stamps of an estimate may go backwards;\n"
    "of a ground truth they may be the numbers of its rows.\n\n"
    "Examples:\n"
    "  psmks-evaluate --estimate out/trajectory.tum --ground-truth drive.gt.tum --plot errors.png\n"
    "  psmks-evaluate --estimate psmks.tum icp.tum --relations fr079.relations --csv errors.csv\n\n"
    "Exit codes: 0 ok; 1 usage; 2 a file is missing or damaged; 3 an estimate has nothing in "
    "common\n"
    "with what it is held against; 5 an output cannot be written.";

void addInputFlags(CLI::App& app, CommandLine& c)
{
  app.add_option("-e,--estimate", c.estimates, "trajectories; several are compared")
      ->type_name("FILE")
      ->required();
  app.add_option("-g,--ground-truth", c.groundTruth, "the true trajectory")->type_name("FILE");
  app.add_option("-r,--relations", c.relations, "true motions between poses")->type_name("FILE");
}

void addMeasureFlags(CLI::App& app, CommandLine& c)
{
  app.add_option("--skip_poses", c.skippedPoses, "leave out the first N poses with a true one")
      ->type_name("N")
      ->capture_default_str();
  const auto setLimit_deg = [&c](double limit_deg) { c.limit.rotation_rad = degToRad(limit_deg); };
  app.add_option("--within_m", c.limit.translation_m, "errors below both limits are counted")
      ->type_name("M")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option_function<double>("--within_deg", setLimit_deg, "the other of the limits")
      ->type_name("DEG")
      ->check(CLI::PositiveNumber)
      ->default_str("2");
  app.add_option("--drift_lengths_m", c.driftLengths_m, "of true path, to measure motions over")
      ->type_name("M")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--short_span_s", c.shortSpan_s, "relations that span less are shown apart")
      ->type_name("S")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
}

void addOutputFlags(CLI::App& app, CommandLine& c)
{
  c.files.addFlags(app);
  app.add_option("--plot", c.plot, "draw paths and errors")
      ->type_name("FILE.png|FILE.svg")
      ->check(CLI::Validator(
          [](const std::string& path)
          {
            const bool isPicture = path.size() > 4 && (path.rfind(".png") == path.size() - 4 ||
                                                       path.rfind(".svg") == path.size() - 4);
            return isPicture ? "" : "'" + path + "' ends neither in .png nor in .svg";
          },
          ""));
}

void addFlags(CLI::App& app, CommandLine& c)
{
  addInputFlags(app, c);
  addMeasureFlags(app, c);
  addOutputFlags(app, c);
}

void check(CommandLine& commandLine)
{
  if (commandLine.groundTruth.empty() && commandLine.relations.empty())
    throw CLI::RequiredError("--ground-truth or --relations");
  commandLine.files.check();
  if (!commandLine.plot.empty()) requireCreatable("--plot", commandLine.plot);
}
}  // namespace

CommandLineSyntax<CommandLine> commandLineSyntax()
{
  return {{"psmks-evaluate", PSMKS_VERSION, kDescription, kFooter}, addFlags, check};
}
}  // namespace psmks
