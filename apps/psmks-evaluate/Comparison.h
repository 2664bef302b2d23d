/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/CommonPoses.h>
#include <psmks/eval/Relations.h>
#include <psmks/eval/Trajectory.h>

#include <string>
#include <vector>

namespace psmks
{
/** An estimated trajectory with the truth about it. */
struct Comparison
{
  std::string name;
  Trajectory estimate;
  std::vector<CommonPose> common;        //!< empty without a ground truth
  std::vector<RelationError> relations;  //!< empty without relations
};

/** Short names that distinguish files. They are the names without folder and extension if these
 * differ, else the names of their folders ("icp" of "out/icp/trajectory.tum"), else the whole
 * paths. */
std::vector<std::string> namesOf(const std::vector<std::string>& paths);

/** Reads an estimated trajectory.
 *  @throws ProgramError (kInputDamaged) if the file is missing or damaged */
Trajectory readEstimate(const std::string& path);

/** The poses of an estimate for which the truth is known.
 *  @param skipped number of first common poses that are left out
 *  @throws ProgramError (kNothingToDo) if none remain */
std::vector<CommonPose> requireCommonPoses(const std::string& path, const Trajectory& estimate,
                                           const Trajectory& truth, std::size_t skipped);
std::vector<RelationError> requireRelationErrors(const std::string& path,
                                                 const Trajectory& estimate,
                                                 const std::vector<Relation>& relations);
}  // namespace psmks
