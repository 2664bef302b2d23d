/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-simulate/OutputFiles.h>
#include <apps/support/Overwriting.h>
#include <apps/support/TextFile.h>

#include <filesystem>

namespace psmks
{
namespace
{
std::string stemOf(const std::string& rawlog)
{
  std::filesystem::path path(rawlog);
  if (path.extension() != ".rawlog")
    throw ProgramError(kUsage, "'" + rawlog + "' does not end in .rawlog");
  return path.replace_extension().string();
}

Trajectory truthOf(const Recording& recording)
{
  Trajectory truth;
  for (const auto& scan : recording.scans)
    truth.push_back({RawlogWriter::loggedStamp_s(scan.simulated.scan.stamp_s), scan.T_world_robot});
  return truth;
}
}  // namespace

OutputFiles::OutputFiles(const std::string& rawlog, bool overwrite,
                         const RawlogWriter::Options& options)
    : stem_(stemOf(rawlog)), writer_(options)
{
  for (const auto& file : {this->rawlog(), tum(), groundTruth(), picture()})
    requireReplaceable(file, overwrite);
  requireWritten(writer_.open(this->rawlog()), this->rawlog());
}

void OutputFiles::write(const Recording& recording, double rangeSigma_m)
{
  for (const auto& recorded : recording.scans)
  {
    Scan scan = recorded.simulated.scan;
    scan.rangeSigma_m = rangeSigma_m;
    writer_.write(scan, recorded.T_start_odometry);
  }
  const Trajectory truth = truthOf(recording);
  writeTextFile(tum(), [&](auto& out) { writeTum(out, truth); });
  writeTextFile(groundTruth(), [&](auto& out) { writeMrptGroundTruth(out, truth); });
}

void OutputFiles::write(const WorldPicture& worldPicture) const
{
  requireWritten(saveWorldPicture(worldPicture, picture()), picture());
}
}  // namespace psmks
