/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-slam/OutputFolder.h>
#include <fcntl.h>
#include <psmks/draw/MapFiles.h>
#include <psmks/draw/MapPicture.h>
#include <psmks/draw/MapScene.h>
#include <psmks/slam/CsvFiles.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <functional>
#include <ostream>

namespace psmks
{
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

void OutputFolder::write(const std::vector<PosedScan>& scans, const ScanMap& map,
                         const mrpt::maps::CSimpleMap& keyframes, const std::string& matcher)
{
  const auto text = [this](const char* name, const std::function<void(std::ostream&)>& write)
  { outputs_.addText(file(name), write); };
  text("trajectory.tum", [&](std::ostream& out) { writeTum(out, trajectoryOf(scans)); });
  text("odometry.tum", [&](std::ostream& out) { writeTum(out, odometryOf(scans)); });
  text("matches.csv", [&](std::ostream& out) { writeMatchesCsv(out, scans); });
  text("segments.csv", [&](std::ostream& out) { writeSegmentsCsv(out, map); });
  outputs_.add(file("map.png"), [&](const std::string& beside)
               { return saveMapPicture(map, "psmks-slam, matcher " + matcher, beside); });
  outputs_.add(file("map.3Dscene"),
               [&](const std::string& beside) { return saveObject(*makeMapScene(map), beside); });
  outputs_.add(file("map.simplemap"),
               [&](const std::string& beside) { return saveObject(keyframes, beside); });
}

void OutputFolder::writeSummary(const RunSummary& summary, SlamOptions& options)
{
  outputs_.addText(file("summary.json"),
                   [&](std::ostream& out) { writeSummaryJson(out, summary, options); });
}
}  // namespace psmks
