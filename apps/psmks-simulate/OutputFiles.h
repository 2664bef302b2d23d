/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/support/WorldPicture.h>
#include <psmks/eval/Trajectory.h>
#include <psmks/logs/RawlogWriter.h>
#include <psmks/sim/Simulation.h>

#include <string>

namespace psmks
{
/** The files of a simulated drive: FILE.rawlog, FILE.gt.tum, FILE.GT.txt and FILE.world.png. */
class OutputFiles
{
 public:
  /** Begins the rawlog, so that a mistyped path is told before the work is done.
   *  @throws ProgramError where it does not end in ".rawlog", cannot be written, or one of the
   * files is there and may not be overwritten */
  OutputFiles(const std::string& rawlog, bool overwrite, const RawlogWriter::Options& options);

  /** Scans and ground truth, in the log's own time.
   *  @param rangeSigma_m that the log states
   *  @throws ProgramError naming a file that cannot be written */
  void write(const Recording& recording, double rangeSigma_m);

  /** @throws ProgramError naming a file that cannot be written */
  void write(const WorldPicture& picture) const;

  std::string rawlog() const { return stem_ + ".rawlog"; }
  std::string tum() const { return stem_ + ".gt.tum"; }
  std::string groundTruth() const { return stem_ + ".GT.txt"; }
  std::string picture() const { return stem_ + ".world.png"; }

 private:
  std::string stem_;
  RawlogWriter writer_;
};
}  // namespace psmks
