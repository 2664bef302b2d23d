/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace psmks
{
/** The exit codes of the programs. */
enum ExitCode
{
  kOk = 0,
  kUsage = 1,         //!< a flag, an option or a configuration that cannot be accepted
  kInputDamaged = 2,  //!< input is missing or damaged; what could be read is processed
  kNothingToDo = 3,   //!< there is no usable scan, or no odometry although it is needed
  kEveryMatchFailed = 4,
  kOutputFailed = 5,      //!< an output could not be written; the others were
  kStoppedBySignal = 128  //!< plus the number of the signal: what was done before it is saved
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

/** Runs the work of a program. An exception becomes one sentence on stderr.
 *  @return what the work returns; after an exception the exit code of a ProgramError, else
 *      kUsage */
ExitCode exitCodeOf(const std::string& program, const std::function<ExitCode()>& work);

/** Runs a program from its first to its last byte of output: catches the signals that ask it to
 * stop, does the work, and makes sure that stdout took everything.
 *  @return as exitCodeOf(); kOutputFailed if stdout did not; kStoppedBySignal and the number of the
 *      signal if one asked to stop */
int runToEnd(const std::string& program, const std::function<ExitCode()>& work);
}  // namespace psmks
