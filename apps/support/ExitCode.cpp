/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/support/ExitCode.h>
#include <apps/support/StopSignal.h>

#include <iostream>

namespace psmks
{
namespace
{
ExitCode complain(const std::string& program, ExitCode code, const std::exception& error)
{
  std::cerr << program << ": " << error.what() << '\n';
  return code;
}
}  // namespace

ExitCode exitCodeOf(const std::string& program, const std::function<ExitCode()>& work)
{
  try
  {
    return work();
  }
  catch (const ProgramError& error)
  {
    return complain(program, error.exitCode, error);
  }
  catch (const std::exception& error)
  {
    return complain(program, kUsage, error);
  }
}

int runToEnd(const std::string& program, const std::function<ExitCode()>& work)
{
  catchStopSignals();
  const ExitCode exitCode = exitCodeOf(program, work);
  std::cout.flush();
  if (!std::cout) std::cerr << program << ": cannot write to the standard output\n";
  if (isToStop())
  {
    std::cerr << program << ": stopped by " << nameOfSignal(stopSignal()) << '\n';
    return kStoppedBySignal + stopSignal();
  }
  return std::cout || exitCode != kOk ? exitCode : kOutputFailed;
}
}  // namespace psmks
