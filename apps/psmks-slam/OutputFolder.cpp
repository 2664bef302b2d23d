/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-slam/OutputFolder.h>
#include <apps/support/TextFile.h>
#include <psmks/draw/MapPicture.h>
#include <psmks/draw/MapScene.h>
#include <psmks/slam/CsvFiles.h>

namespace psmks
{
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
                         const mrpt::maps::CSimpleMap& keyframes, const std::string& matcher) const
{
  writeTextFile(file("trajectory.tum"), [&](auto& out) { writeTum(out, trajectoryOf(scans)); });
  writeTextFile(file("odometry.tum"), [&](auto& out) { writeTum(out, odometryOf(scans)); });
  writeTextFile(file("matches.csv"), [&](auto& out) { writeMatchesCsv(out, scans); });
  writeTextFile(file("segments.csv"), [&](auto& out) { writeSegmentsCsv(out, map); });
  requireWritten(saveMapPicture(map, "psmks-slam, matcher " + matcher, file("map.png")),
                 file("map.png"));
  requireWritten(makeMapScene(map)->saveToFile(file("map.3Dscene")), file("map.3Dscene"));
  requireWritten(keyframes.saveToFile(file("map.simplemap")), file("map.simplemap"));
}

void OutputFolder::writeSummary(const RunSummary& summary, SlamOptions& options) const
{
  writeTextFile(file("summary.json"), [&](auto& out) { writeSummaryJson(out, summary, options); });
}
}  // namespace psmks
