/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/support/ExitCode.h>
#include <apps/support/GroundTruth.h>

#include <filesystem>

namespace psmks
{
Trajectory readGroundTruth(const std::string& path)
{
  try
  {
    return readTrajectory(path);
  }
  catch (const TrajectoryFileError& error)
  {
    throw ProgramError(kInputDamaged, std::string("ground truth ") + error.what());
  }
}

std::optional<std::string> groundTruthBeside(const std::string& log)
{
  const std::string stem = std::filesystem::path(log).replace_extension().string();
  for (const std::string& path : {stem + ".gt.tum", stem + ".GT.txt", log + ".GT.txt"})
    if (std::filesystem::is_regular_file(path)) return path;
  return std::nullopt;
}
}  // namespace psmks
