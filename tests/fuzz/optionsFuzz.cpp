/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <mrpt/config/CConfigFileMemory.h>
#include <psmks/core/MatcherOptions.h>
#include <psmks/mrpt/ConfigFile.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

/** A file of options is loaded, and what was loaded is valid, or it is refused with a short text.
 */
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  mrpt::config::CConfigFileMemory file;
  file.setContent(std::string(data, data + size));
  psmks::MatcherOptions options;
  psmks::OptionTable table = psmks::optionTable(options);
  try
  {
    psmks::loadOptions(table, file, "psmks");
    table.validate();
  }
  catch (const psmks::OptionError& error)
  {
    if (std::string(error.what()).size() > 2000) std::abort();
  }
  return 0;
}
