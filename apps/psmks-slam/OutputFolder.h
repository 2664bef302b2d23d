/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-slam/RunResults.h>
#include <apps/psmks-slam/SummaryOutput.h>
#include <apps/support/Outputs.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace psmks
{
/** The names of the results that may be chosen, in the order in which they are written. */
std::vector<std::string> outputNames();

/** Writes the graph of keyframes in the format of g2o. */
void writeGraph(std::ostream& out, const KeyframeMap& keyframes);

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

  /** Writes results; those that can be written, see outputs().
   *  @param chosen of outputNames()
   *  @param progress called with the share that is written, 0 to 1 */
  void write(RunResults& results, const std::vector<std::string>& chosen,
             const std::function<void(double)>& progress);

  /** Writes the summary. */
  void writeSummary(const RunSummary& summary, SlamOptions& options);

  /** What could not be written so far. */
  Outputs& outputs() { return outputs_; }

  std::string path() const { return folder_.string(); }
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
