/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/Trajectory.h>

#include <string>
#include <vector>

namespace psmks
{
/** A line of a text file of numbers. */
struct NumberRow
{
  int line = 0;                 //!< in the file, from 1
  std::vector<double> numbers;  //!< empty where something else stands among them
};

/** The lines of a file but for those that are empty or only a comment; '#' and '%' begin one.
 *  @throws TrajectoryFileError where the file cannot be read or has no such line: it "holds no
 *          <content>" */
std::vector<NumberRow> readNumberRows(const std::string& path, const std::string& content);

/** @throws TrajectoryFileError naming file, line and reason */
[[noreturn]] void refuse(const std::string& path, const NumberRow& row, const std::string& reason);
}  // namespace psmks
