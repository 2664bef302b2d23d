/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-slam/SummaryOutput.h>
#include <mrpt/maps/CSimpleMap.h>
#include <psmks/slam/ScanMap.h>

#include <filesystem>
#include <string>

namespace psmks
{
/** The folder that a run's results go to. */
class OutputFolder
{
 public:
  /** Makes the folder.
   *  @throws ProgramError where it cannot be made, or holds files that may not be overwritten */
  OutputFolder(const std::string& path, bool overwrite);

  /** All but the summary.
   *  @param matcher in the map's title
   *  @throws ProgramError naming a file that cannot be written */
  void write(const std::vector<PosedScan>& scans, const ScanMap& map,
             const mrpt::maps::CSimpleMap& keyframes, const std::string& matcher) const;

  /** @throws ProgramError where the file cannot be written */
  void writeSummary(const RunSummary& summary, SlamOptions& options) const;

  std::string file(const std::string& name) const { return (folder_ / name).string(); }

 private:
  std::filesystem::path folder_;
};
}  // namespace psmks
