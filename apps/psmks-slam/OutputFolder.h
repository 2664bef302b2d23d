/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-slam/SummaryOutput.h>
#include <apps/support/Outputs.h>
#include <mrpt/maps/CSimpleMap.h>
#include <psmks/slam/ScanMap.h>

#include <filesystem>
#include <string>
#include <vector>

namespace psmks
{
/** The folder of the results of a run. While it is open, no other run can use it. */
class OutputFolder
{
 public:
  /** Creates the folder and locks it.
   *  @throws ProgramError if it cannot be created, is used by another run, or has files that may
   * not be overwritten */
  OutputFolder(const std::string& path, bool overwrite);

  /** Removes the folders that it created and that are still empty. */
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /** Writes all results except the summary; those that can be written, see outputs().
   *  @param matcher name for the title of the map */
  void write(const std::vector<PosedScan>& scans, const ScanMap& map,
             const mrpt::maps::CSimpleMap& keyframes, const std::string& matcher);

  /** Writes the summary. */
  void writeSummary(const RunSummary& summary, SlamOptions& options);

  /** What could not be written so far. */
  Outputs& outputs() { return outputs_; }

  std::string file(const std::string& name) const { return (folder_ / name).string(); }

 private:
  void create();
  void lock();

  std::filesystem::path folder_;
  std::vector<std::filesystem::path> created_;  //!< folders, the outer ones first
  int descriptor_ = -1;                         //!< of the folder, which holds the lock
  Outputs outputs_;
};
}  // namespace psmks
