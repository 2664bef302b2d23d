/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-benchmark/experiments/MethodRun.h>

#include <functional>
#include <string>
#include <vector>

namespace psmks
{
/** The results of all methods on one drive. */
struct DriveResult
{
  DrivePlan plan;
  double distance_m = 0, turns = 0, longestStandstill_s = 0;
  int collisions = 0;
  std::vector<std::pair<Method, MethodFigures>> methods;  //!< in the order of the command line

  /** The result of a method; null if it was not run. */
  const MethodFigures* find(const std::string& methodKey) const;
};

DriveResult summarise(const Drive& drive, const std::vector<MethodRun>& runs);

/** The drives in one kind of world with one maximum range of the laser. */
struct ResultGroup
{
  std::string site;
  double maxRange_m = 0;
  std::vector<DriveResult> drives;
};

/** Groups drives, in the order of their first drives. */
std::vector<ResultGroup> grouped(const std::vector<DriveResult>& results);

/** The mean and the range of a value over drives. */
struct Spread
{
  double mean = 0, smallest = 0, largest = 0;
};

/** The spread over the drives on which the method was run. */
Spread spread(const ResultGroup& group, const std::string& methodKey,
              const std::function<double(const MethodFigures&)>& figure);

Spread spread(const ResultGroup& group, const std::function<double(const DriveResult&)>& figure);
}  // namespace psmks
