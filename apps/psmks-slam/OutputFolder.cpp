/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-slam/OutputFolder.h>
#include <apps/support/ExitCode.h>
#include <psmks/mrpt/CsvFiles.h>
#include <psmks/mrpt/MapPicture.h>
#include <psmks/mrpt/MapScene.h>

#include <fstream>

namespace psmks
{
namespace
{
void require(bool written, const std::string& path)
{
  if (!written) throw ProgramError(kUsage, "cannot write '" + path + "'");
}

template <class Write>
void writeText(const std::string& path, Write write)
{
  std::ofstream file(path);
  write(file);
  file.close();
  require(!file.fail(), path);
}

std::string pictureTitle(const Summary& summary)
{
  return "psmks-slam, matcher " + summary.matcher;
}
}  // namespace

OutputFolder::OutputFolder(const std::string& path, bool overwrite) : folder_(path)
{
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error || !std::filesystem::is_directory(folder_))
    throw ProgramError(kUsage, "cannot make the output folder '" + path + "'");
  if (!overwrite && !std::filesystem::is_empty(folder_))
    throw ProgramError(
        kUsage, "the output folder '" + path + "' holds files, add --overwrite or name another");
}

void OutputFolder::write(const std::vector<PosedScan>& scans, const ScanMap& map,
                         const mrpt::maps::CSimpleMap& keyframes, const Summary& summary,
                         SlamOptions& options) const
{
  writeText(file("trajectory.tum"), [&](auto& out) { writeTum(out, trajectoryOf(scans)); });
  writeText(file("odometry.tum"), [&](auto& out) { writeTum(out, odometryOf(scans)); });
  writeText(file("matches.csv"), [&](auto& out) { writeMatchesCsv(out, scans); });
  writeText(file("segments.csv"), [&](auto& out) { writeSegmentsCsv(out, map); });
  require(saveMapPicture(map, pictureTitle(summary), file("map.png")), file("map.png"));
  require(makeMapScene(map)->saveToFile(file("map.3Dscene")), file("map.3Dscene"));
  require(keyframes.saveToFile(file("map.simplemap")), file("map.simplemap"));
  writeText(file("summary.json"), [&](auto& out) { writeSummaryJson(out, summary, options); });
}
}  // namespace psmks
