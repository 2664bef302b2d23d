/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/base/NumberRow.h>
#include <psmks/eval/Trajectory.h>

#include <string>
#include <vector>

namespace psmks
{
/** A line of a text file of numbers that is neither blank nor a comment. */
struct NumberRow
{
  int line = 0;                 //!< its number in the file, from 1
  std::vector<double> numbers;  //!< empty if one word of the line is not a number
};

/** Reads the rows of numbers of a text file, see parseNumberRow(). A comment begins with '#' or '%'
 * and ends with its line; blank lines are skipped.
 *  @param content what a row stands for, such as "pose", for the message of the error
 *  @throws TrajectoryFileError if the file cannot be read or has no row */
std::vector<NumberRow> readNumberRows(const std::string& path, const std::string& content,
                                      NonFinite nonFinite = NonFinite::Refused);

/** Refuses a row.
 *  @throws TrajectoryFileError always; the text gives file, line and reason */
[[noreturn]] void refuse(const std::string& path, const NumberRow& row, const std::string& reason);
}  // namespace psmks
