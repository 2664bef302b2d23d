/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <BuildInfo.h>
#include <apps/psmks-benchmark/Machine.h>

#include <fstream>

namespace psmks
{
namespace
{
/** The model of the first processor that Linux reports. */
std::string processorModel()
{
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
  {
    const auto colon = line.find(": ");
    if (line.rfind("model name", 0) == 0 && colon != std::string::npos)
      return line.substr(colon + 2);
  }
  return "unknown processor";
}

std::string singleSpaced(const std::string& text)
{
  std::string result;
  for (const char c : text)
    if (c != ' ' || (!result.empty() && result.back() != ' ')) result += c;
  return result.substr(0, result.find_last_not_of(' ') + 1);
}
}  // namespace

Machine Machine::present()
{
  return {processorModel(), PSMKS_COMPILER, singleSpaced(PSMKS_FLAGS), PSMKS_BUILD_TYPE,
          PSMKS_COMMIT};
}

std::string Machine::line() const
{
  return processor + "; " + compiler + ", " + buildType + " (" + flags + "); psmks " + commit;
}
}  // namespace psmks
