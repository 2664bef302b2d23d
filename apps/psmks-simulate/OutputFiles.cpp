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
    : stem_(stemOf(rawlog)), rawlogFile_(this->rawlog()), writer_(options)
{
  for (const auto& file : {this->rawlog(), tum(), groundTruth(), picture()})
    requireReplaceable(file, overwrite);
  requireCreated(writer_.open(rawlogFile_.beside()), this->rawlog());
}

void OutputFiles::write(const Recording& recording, double rangeSigma_m)
{
  for (const auto& recorded : recording.scans)
  {
    Scan scan = recorded.simulated.scan;
    scan.rangeSigma_m = rangeSigma_m;
    writer_.write(scan, recorded.T_start_odometry);
  }
  outputs_.note(this->rawlog(), writer_.close() && rawlogFile_.moveIntoPlace());
  const Trajectory truth = truthOf(recording);
  outputs_.addText(tum(), [&](std::ostream& out) { writeTum(out, truth); });
  outputs_.addText(groundTruth(), [&](std::ostream& out) { writeMrptGroundTruth(out, truth); });
}

void OutputFiles::write(const WorldPicture& worldPicture)
{
  outputs_.add(picture(),
               [&](const std::string& beside) { return saveWorldPicture(worldPicture, beside); });
}
}  // namespace psmks
