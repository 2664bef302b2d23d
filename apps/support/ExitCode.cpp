/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/support/ExitCode.h>

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
}  // namespace psmks
