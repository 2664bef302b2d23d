/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

namespace psmks
{
/** What the programs return to the shell. */
enum ExitCode
{
  kOk = 0,
  kUsage = 1,         //!< a flag, an option or a configuration that cannot be accepted
  kInputDamaged = 2,  //!< input missing, unreadable or corrupt; what was readable is processed
  kNothingToDo = 3,   //!< no usable scan
  kEveryMatchFailed = 4
};
}  // namespace psmks
