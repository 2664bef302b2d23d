/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/Relations.h>
#include <psmks/eval/Trajectory.h>

#include <optional>
#include <string>
#include <vector>

namespace psmks
{
/** Tells on stderr what a user should know of a trajectory file.
 *  @param kind of the file, such as "ground truth" */
void tellRemarks(const std::string& kind, const std::string& path, const TrajectoryFile& file);

/** Reads the true trajectory of a log, and tells the remarks on it.
 *  @throws ProgramError (kInputDamaged) if the file is missing or is not a trajectory */
Trajectory readGroundTruth(const std::string& path);

/** Reads true motions between the poses of a log.
 *  @throws ProgramError (kInputDamaged) if the file is missing or has no relations */
std::vector<Relation> readTrueRelations(const std::string& path);

/** Finds the ground truth of a log by its name, in the same folder. For `X.rawlog`, `X.log.gz` and
 * the like these are the files of psmks-simulate, `X.gt.tum` and `X.GT.txt`; the reference of
 * another program, `X.reference.tum`; those of the data sets of MRPT, `X.rawlog.GT.txt` and
 * `X_GT.txt`; and that of carmen2rawlog, `X.gt.txt`.
 *  @return nothing if there is no such file */
std::optional<std::string> groundTruthBeside(const std::string& log);

/** Finds the relations of a log X, `X.relations` in the same folder.
 *  @return nothing if there is no such file */
std::optional<std::string> relationsBeside(const std::string& log);
}  // namespace psmks
