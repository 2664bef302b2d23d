/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-slam/SummaryOutput.h>
#include <mrpt/maps/CSimpleMap.h>
#include <psmks/slam/ScanMap.h>

#include <filesystem>
#include <string>

namespace psmks
{
/** The folder of the results of a run. */
class OutputFolder
{
 public:
  /** Creates the folder.
   *  @throws ProgramError if it cannot be created, or has files that may not be overwritten */
  OutputFolder(const std::string& path, bool overwrite);

  /** Writes all results except the summary.
   *  @param matcher name for the title of the map
   *  @throws ProgramError naming a file that cannot be written */
  void write(const std::vector<PosedScan>& scans, const ScanMap& map,
             const mrpt::maps::CSimpleMap& keyframes, const std::string& matcher) const;

  /** Writes the summary.
   *  @throws ProgramError if it cannot be written */
  void writeSummary(const RunSummary& summary, SlamOptions& options) const;

  std::string file(const std::string& name) const { return (folder_ / name).string(); }

 private:
  std::filesystem::path folder_;
};
}  // namespace psmks
