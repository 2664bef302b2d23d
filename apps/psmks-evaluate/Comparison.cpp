/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-evaluate/Comparison.h>
#include <apps/support/ExitCode.h>
#include <apps/support/GroundTruth.h>
#include <apps/support/UnitHints.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <set>

namespace psmks
{
namespace
{
using std::filesystem::path;

std::string stem(const std::string& file) { return path(file).stem().string(); }

/** The name of the folder of a file, for results that have the same file names in different
 * folders.
 */
std::string folder(const std::string& file) { return path(file).parent_path().filename().string(); }

std::string folderAndStem(const std::string& file) { return folder(file) + '/' + stem(file); }

std::string whole(const std::string& file) { return file; }

bool areDistinct(const std::vector<std::string>& names)
{
  return std::set<std::string>(names.begin(), names.end()).size() == names.size() &&
         std::count(names.begin(), names.end(), "") == 0;
}

std::string noCommonPosesText(const std::string& path, const Trajectory& estimate,
                              const Trajectory& truth)
{
  const std::string sentence = "the ground truth has no pose at the time of any of " + path +
                               (isNumbered(truth) ? "" : stampHint(estimate, truth));
  if (!isNumbered(truth)) return sentence;
  return sentence + "; its stamps are but the numbers of its " + std::to_string(truth.size()) +
         " rows, which go with as many poses or one more, not with " +
         std::to_string(estimate.size());
}
}  // namespace

std::vector<std::string> namesOf(const std::vector<std::string>& paths)
{
  std::vector<std::string> names;
  for (const auto nameOf : {stem, folder, folderAndStem, whole})
  {
    names.clear();
    for (const std::string& file : paths) names.push_back(nameOf(file));
    if (areDistinct(names)) break;
  }
  return names;
}

Trajectory readEstimate(const std::string& path)
{
  try
  {
    const TrajectoryFile file = readTrajectoryFile(path, StampOrder::Any);
    tellRemarks("estimate", path, file);
    return file.trajectory;
  }
  catch (const TrajectoryFileError& error)
  {
    throw ProgramError(kInputDamaged, std::string("estimate ") + error.what());
  }
}

std::vector<CommonPose> requireCommonPoses(const std::string& path, const Trajectory& estimate,
                                           const Trajectory& truth, std::size_t skipped)
{
  auto common = commonPoses(estimate, truth);
  if (common.empty()) throw ProgramError(kNothingToDo, noCommonPosesText(path, estimate, truth));
  if (common.size() <= skipped)
    throw ProgramError(kNothingToDo, "all " + std::to_string(common.size()) +
                                         " poses in common of " + path + " are to be skipped");
  common.erase(common.begin(), common.begin() + static_cast<std::ptrdiff_t>(skipped));
  return common;
}

std::vector<RelationError> requireRelationErrors(const std::string& path,
                                                 const Trajectory& estimate,
                                                 const std::vector<Relation>& relations)
{
  auto errors = relationErrors(estimate, relations);
  if (errors.empty())
    throw ProgramError(kNothingToDo, "no relation is between two poses of " + path);
  return errors;
}
}  // namespace psmks
