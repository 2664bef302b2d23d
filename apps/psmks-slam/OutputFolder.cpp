/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-slam/OutputFolder.h>
#include <apps/support/Summary.h>
#include <fcntl.h>
#include <psmks/draw/MapFiles.h>
#include <psmks/draw/MapPicture.h>
#include <psmks/draw/MapScene.h>
#include <psmks/draw/MapSvg.h>
#include <psmks/slam/CsvFiles.h>
#include <psmks/slam/G2oFile.h>
#include <psmks/slam/MapServerFiles.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <functional>
#include <ostream>

namespace psmks
{
namespace
{
/** Writes a text file into the folder. */
void writeText(OutputFolder& folder, const char* name,
               const std::function<void(std::ostream&)>& write)
{
  folder.outputs().addText(folder.file(name), write);
}

void writeTrajectories(OutputFolder& folder, RunResults& results)
{
  const auto& scans = results.scans();
  writeText(folder, "trajectory.tum",
            [&](std::ostream& out) { writeTum(out, trajectoryOf(scans)); });
  writeText(folder, "odometry.tum", [&](std::ostream& out) { writeTum(out, odometryOf(scans)); });
}

void writeMatches(OutputFolder& folder, RunResults& results)
{
  writeText(folder, "matches.csv",
            [&](std::ostream& out) { writeMatchesCsv(out, results.scans()); });
}

void writeSegments(OutputFolder& folder, RunResults& results)
{
  writeText(folder, "segments.csv",
            [&](std::ostream& out) { writeSegmentsCsv(out, results.scanMap()); });
}

void writeGraphFile(OutputFolder& folder, RunResults& results)
{
  writeText(folder, "graph.g2o", [&](std::ostream& out) { writeGraph(out, results.keyframes()); });
}

void writeGrid(OutputFolder& folder, RunResults& results)
{
  const OccupancyGrid grid = makeOccupancyGrid(results.scans(), results.options().preprocessing);
  writeText(folder, "map.pgm", [&](std::ostream& out) { writeMapServerPicture(out, grid); });
  writeText(folder, "map.yaml",
            [&](std::ostream& out) { writeMapServerYaml(out, grid, "map.pgm"); });
}

void writeSvg(OutputFolder& folder, RunResults& results)
{
  writeText(folder, "map.svg",
            [&](std::ostream& out) { writeMapSvg(out, results.scanMap(), results.title()); });
}

void writePicture(OutputFolder& folder, RunResults& results)
{
  folder.outputs().add(folder.file("map.png"), [&](const std::string& beside)
                       { return saveMapPicture(results.scanMap(), results.title(), beside); });
}

void writeScene(OutputFolder& folder, RunResults& results)
{
  folder.outputs().add(folder.file("map.3Dscene"), [&](const std::string& beside)
                       { return saveObject(*makeMapScene(results.scanMap()), beside); });
}

void writeSimplemap(OutputFolder& folder, RunResults& results)
{
  folder.outputs().add(folder.file("map.simplemap"), [&](const std::string& beside)
                       { return saveObject(results.observations(), beside); });
}

/** A result that may be chosen. */
struct Output
{
  const char* name;
  void (*write)(OutputFolder&, RunResults&);
};

constexpr Output kOutputs[] = {{"trajectory", writeTrajectories}, {"matches", writeMatches},
                               {"graph", writeGraphFile},         {"grid", writeGrid},
                               {"segments", writeSegments},       {"svg", writeSvg},
                               {"picture", writePicture},         {"scene", writeScene},
                               {"simplemap", writeSimplemap}};
}  // namespace

std::vector<std::string> outputNames()
{
  std::vector<std::string> names;
  for (const Output& output : kOutputs) names.emplace_back(output.name);
  return names;
}

void writeGraph(std::ostream& out, const KeyframeMap& keyframes)
{
  writeG2o(out, keyframes.graph(), keyframes.scansOfNodes());
}

OutputFolder::OutputFolder(const std::string& path, bool overwrite) : folder_(path)
{
  create();
  lock();
  if (!overwrite && !std::filesystem::is_empty(folder_))
    throw ProgramError(
        kUsage, "the output folder '" + path + "' holds files, add --overwrite or name another");
}

OutputFolder::~OutputFolder()
{
  std::error_code ignored;
  for (auto folder = created_.rbegin(); folder != created_.rend(); ++folder)
    std::filesystem::remove(*folder, ignored);  // removes none that holds a file
  if (descriptor_ >= 0) close(descriptor_);
}

/** Creates the folder, and notes which ones were not there. */
void OutputFolder::create()
{
  std::error_code error;
  std::filesystem::path missing = std::filesystem::absolute(folder_).lexically_normal();
  if (missing.filename().empty()) missing = missing.parent_path();
  for (; !std::filesystem::exists(missing, error) && missing.has_relative_path();
       missing = missing.parent_path())
    created_.insert(created_.begin(), missing);
  std::filesystem::create_directories(folder_, error);
  if (error || !std::filesystem::is_directory(folder_))
    throw ProgramError(kUsage, "cannot make the output folder '" + folder_.string() + "'");
}

/** Locks the folder itself, so that no file is left behind, whatever ends the program. Where a file
 * system knows no locks, there is none. */
void OutputFolder::lock()
{
  descriptor_ = open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor_ >= 0 && flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    throw ProgramError(kUsage,
                       "the output folder '" + folder_.string() + "' is in use by another run");
}

void OutputFolder::write(RunResults& results, const std::vector<std::string>& chosen,
                         const std::function<void(double)>& progress)
{
  double written = 0;
  for (const Output& output : kOutputs)
  {
    if (std::find(chosen.begin(), chosen.end(), output.name) == chosen.end()) continue;
    output.write(*this, results);
    progress(++written / static_cast<double>(chosen.size()));
  }
}

void OutputFolder::writeSummary(const RunSummary& summary, SlamOptions& options)
{
  outputs_.addText(file("summary.json"),
                   [&](std::ostream& out) { writeSummaryJson(out, summary, options); });
}
}  // namespace psmks
