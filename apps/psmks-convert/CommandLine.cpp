/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-convert/CommandLine.h>

#include <CLI/CLI.hpp>
#include <filesystem>

namespace psmks
{
namespace
{
constexpr const char* kDescription =
    "Converts logs and maps. INPUT's content and the ending of OUTPUT's name say from what to "
    "what:\n"
    "  rawlog or CARMEN log  to  .rawlog, .log or .clf (CARMEN), .pairs (scan pairs)\n"
    "  ActivMedia .map       to  .csv (its walls as segments)\n"
    "  the noise of a log's scanner, with --sensor-report, to .ini (a sensor file) and a picture\n"
    "Inputs may be gzipped; .log.gz, .clf.gz and .pairs.gz are written gzipped, rawlogs always.";

constexpr const char* kFooter =
    "Examples:\n"
    "  psmks-convert fr079.log.gz fr079.rawlog\n"
    "  psmks-convert drive.rawlog drive.log.gz --sensor FRONT\n"
    "  psmks-convert drive.log drive.pairs.gz --ground-truth drive.tum --every 4\n"
    "  psmks-convert office.map office.csv\n"
    "  psmks-convert standing.log.gz my-scanner.ini --sensor-report\n\n"
    "A rawlog holds actions and sensory frames in turn, or with --observations loose "
    "observations.\n"
    "A pair's true motion is that of the ground truth, its guess that of the odometry.\n\n"
    "Exit codes: 0 ok; 1 usage; 2 input missing or damaged (what was read before the damage is\n"
    "converted); 3 nothing to convert; 5 the output cannot be written; 128 + N stopped by signal "
    "N\n"
    "(what was read before it is converted).";

void addFlags(CLI::App& app, CommandLine& c)
{
  app.add_option("INPUT", c.input, "MRPT rawlog, CARMEN log or ActivMedia map")->required();
  app.add_option("OUTPUT", c.output, "the file to write; --sensor-report needs none");
  app.add_flag("--sensor-report", c.sensorReport,
               "print what the scans of a log tell of their scanner's noise; OUTPUT.ini gets a "
               "sensor file, and a picture beside it");
  app.add_flag("-w,--overwrite", c.overwrite, "replace a file that is there");
  app.add_flag("--observations", c.observations, "write a rawlog of observations");
  app.add_option("--ground-truth", c.groundTruth,
                 "for pairs: the robot's true trajectory, TUM or lines of 'time x y phi'")
      ->type_name("FILE");
  app.add_option("--every", c.every, "for pairs: of every so many scans take one")
      ->type_name("N")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--max-scans", c.maxScans, "stop after so many scans")
      ->type_name("N")
      ->check(CLI::PositiveNumber);
  c.logFlags.addTo(app);
}

void check(const CommandLine& commandLine)
{
  const OutputKind kind = commandLine.outputKind();
  if (commandLine.sensorReport)
  {
    if (!commandLine.output.empty() && kind != OutputKind::Sensor)
      throw CLI::ValidationError(
          "OUTPUT", "'" + commandLine.output + "' does not end in .ini, as a sensor file does");
    return;
  }
  if (commandLine.output.empty()) throw CLI::RequiredError("OUTPUT");
  if (kind == OutputKind::Sensor)
    throw CLI::ValidationError("OUTPUT", "a sensor file needs --sensor-report");
  if (kind == OutputKind::Unknown)
    throw CLI::ValidationError("OUTPUT", "'" + commandLine.output +
                                             "' ends neither in .rawlog, .log, .clf, .pairs nor "
                                             ".csv");
  if (kind == OutputKind::Pairs && commandLine.groundTruth.empty())
    throw CLI::ValidationError("OUTPUT", "pairs need --ground-truth");
}
}  // namespace

OutputKind CommandLine::outputKind() const
{
  std::filesystem::path path = output;
  if (path.extension() == ".gz") path.replace_extension();
  const std::string ending = path.extension().string();
  if (ending == ".rawlog") return OutputKind::Rawlog;
  if (ending == ".log" || ending == ".clf") return OutputKind::Carmen;
  if (ending == ".pairs") return OutputKind::Pairs;
  if (ending == ".ini") return OutputKind::Sensor;
  return ending == ".csv" ? OutputKind::Segments : OutputKind::Unknown;
}

CommandLineSyntax<CommandLine> commandLineSyntax()
{
  return {{"psmks-convert", PSMKS_VERSION, kDescription, kFooter}, addFlags, check};
}
}  // namespace psmks
