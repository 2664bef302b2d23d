/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/CommonPoses.h>
#include <psmks/eval/Relations.h>
#include <psmks/eval/Trajectory.h>

#include <string>
#include <vector>

namespace psmks
{
/** An estimated trajectory and what is known of the truth about it. */
struct Comparison
{
  std::string name;
  Trajectory estimate;
  std::vector<CommonPose> common;        //!< empty without a ground truth
  std::vector<RelationError> relations;  //!< empty without relations
};

/** Short names that tell files apart: without folder and extension where that is enough, else with
 * the folder that they lie in ("icp" of "out/icp/trajectory.tum"), else as they are. */
std::vector<std::string> namesOf(const std::vector<std::string>& paths);

/** @throws ProgramError for a file that is missing or damaged (kInputDamaged) */
Trajectory readEstimate(const std::string& path);

/** What an estimate has in common with the truth.
 *  @param skipped common poses that are left out, from the first on
 *  @throws ProgramError (kNothingToDo) where that is nothing */
std::vector<CommonPose> requireCommonPoses(const std::string& path, const Trajectory& estimate,
                                           const Trajectory& truth, std::size_t skipped);
std::vector<RelationError> requireRelationErrors(const std::string& path,
                                                 const Trajectory& estimate,
                                                 const std::vector<Relation>& relations);
}  // namespace psmks
