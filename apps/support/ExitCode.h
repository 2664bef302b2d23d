/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace psmks
{
/** What the programs return to the shell. */
enum ExitCode
{
  kOk = 0,
  kUsage = 1,         //!< a flag, an option or a configuration that cannot be accepted
  kInputDamaged = 2,  //!< input missing, unreadable or corrupt; what was readable is processed
  kNothingToDo = 3,   //!< no usable scan, or no odometry where one is needed
  kEveryMatchFailed = 4
};

/** Ends a program with an exit code and one sentence for the user. */
class ProgramError : public std::runtime_error
{
 public:
  ProgramError(ExitCode code, const std::string& sentence)
      : std::runtime_error(sentence), exitCode(code)
  {
  }

  ExitCode exitCode;
};

/** Runs a program's work. What it throws becomes one sentence on stderr, and the exit code that it
 * carries or kUsage. */
ExitCode exitCodeOf(const std::string& program, const std::function<ExitCode()>& work);
}  // namespace psmks
