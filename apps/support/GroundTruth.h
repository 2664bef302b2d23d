/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/Relations.h>
#include <psmks/eval/Trajectory.h>

#include <optional>
#include <string>
#include <vector>

namespace psmks
{
/** The true trajectory of a log.
 *  @throws ProgramError (kInputDamaged) for a file that is missing or no trajectory */
Trajectory readGroundTruth(const std::string& path);

/** True motions between the poses of a log.
 *  @throws ProgramError (kInputDamaged) for a file that is missing or holds no relations */
std::vector<Relation> readTrueRelations(const std::string& path);

/** The ground truth that lies beside a log under a name that goes with it: of `X.rawlog`,
 * `X.log.gz` and the like those that psmks-simulate writes, `X.gt.tum` and `X.GT.txt`; a reference
 * of another program, `X.reference.tum`; those of MRPT's data sets, `X.rawlog.GT.txt` and
 * `X_GT.txt`, and that of carmen2rawlog, `X.gt.txt`. */
std::optional<std::string> groundTruthBeside(const std::string& log);

/** The relations that lie beside a log X: `X.relations`. */
std::optional<std::string> relationsBeside(const std::string& log);
}  // namespace psmks
