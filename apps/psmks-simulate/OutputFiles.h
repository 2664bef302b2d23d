/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/support/Outputs.h>
#include <apps/support/ReplacedFile.h>
#include <apps/support/WorldPicture.h>
#include <psmks/eval/Trajectory.h>
#include <psmks/logs/RawlogWriter.h>
#include <psmks/sim/Simulation.h>

#include <string>

namespace psmks
{
/** The output files of a simulated drive: FILE.rawlog, FILE.gt.tum, FILE.GT.txt and FILE.world.png.
 */
class OutputFiles
{
 public:
  /** Creates the rawlog beside its place, so that a mistyped path is reported before the work is
   * done.
   *  @throws ProgramError if the path does not end in ".rawlog" or cannot be written, or if one
   *      of the files exists and may not be overwritten */
  OutputFiles(const std::string& rawlog, bool overwrite, const RawlogWriter::Options& options);

  /** Writes the scans and the ground truth with the stamps as the log stores them.
   *  @param rangeSigma_m standard deviation of ranges that the log states */
  void write(const Recording& recording, double rangeSigma_m);

  /** Draws the picture of the world. */
  void write(const WorldPicture& picture);

  /** @throws ProgramError (kOutputFailed) naming the files that could not be written */
  void requireComplete() const { outputs_.requireComplete(); }

  std::string rawlog() const { return stem_ + ".rawlog"; }
  std::string tum() const { return stem_ + ".gt.tum"; }
  std::string groundTruth() const { return stem_ + ".GT.txt"; }
  std::string picture() const { return stem_ + ".world.png"; }

 private:
  std::string stem_;
  ReplacedFile rawlogFile_;
  RawlogWriter writer_;
  Outputs outputs_;
};
}  // namespace psmks
