/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/support/ExitCode.h>
#include <apps/support/GroundTruth.h>

#include <cerrno>
#include <filesystem>
#include <iostream>

namespace psmks
{
namespace
{
/** Calls `read` for a file.
 *  @throws ProgramError (kInputDamaged) if it refuses the file */
template <class Read>
auto readInput(const std::string& kind, const std::string& path, Read read)
{
  try
  {
    return read(path);
  }
  catch (const TrajectoryFileError& error)
  {
    throw ProgramError(kInputDamaged, kind + " " + error.what());
  }
}

/** The name X of a log "X.rawlog", "X.log" or "X.log.gz". */
std::string stemOf(const std::string& log)
{
  std::filesystem::path path = log;
  if (path.extension() == ".gz") path.replace_extension();
  return path.replace_extension().string();
}

std::optional<std::string> firstFile(const std::vector<std::string>& paths)
{
  for (const std::string& path : paths)
    if (std::filesystem::is_regular_file(path)) return path;
  return std::nullopt;
}
}  // namespace

void tellRemarks(const std::string& kind, const std::string& path, const TrajectoryFile& file)
{
  for (const std::string& remark : file.remarks())
    std::cerr << program_invocation_short_name << ": " << kind << " '" << path << "': " << remark
              << '\n';
}

Trajectory readGroundTruth(const std::string& path)
{
  const TrajectoryFile truth =
      readInput("ground truth", path, [](const auto& file) { return readTrajectoryFile(file); });
  tellRemarks("ground truth", path, truth);
  return truth.trajectory;
}

std::vector<Relation> readTrueRelations(const std::string& path)
{
  return readInput("relations", path, readRelations);
}

std::optional<std::string> groundTruthBeside(const std::string& log)
{
  const std::string stem = stemOf(log);
  return firstFile({stem + ".gt.tum", stem + ".GT.txt", stem + ".reference.tum", log + ".GT.txt",
                    stem + "_GT.txt", stem + ".gt.txt"});
}

std::optional<std::string> relationsBeside(const std::string& log)
{
  return firstFile({stemOf(log) + ".relations"});
}
}  // namespace psmks
