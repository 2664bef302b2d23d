/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/Trajectory.h>

#include <optional>
#include <string>

namespace psmks
{
/** The true trajectory of a log.
 *  @throws ProgramError (kInputDamaged) for a file that is missing or no trajectory */
Trajectory readGroundTruth(const std::string& path);

/** The ground truth that lies beside a log under a name that goes with it: of `X.rawlog` those that
 * psmks-simulate writes, `X.gt.tum` and `X.GT.txt`, and that of MRPT's data sets,
 * `X.rawlog.GT.txt`. */
std::optional<std::string> groundTruthBeside(const std::string& log);
}  // namespace psmks
