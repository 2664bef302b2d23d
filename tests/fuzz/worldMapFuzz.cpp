/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/sim/MapFile.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>

/** An ActivMedia map is read, or refused with a short text. */
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  std::istringstream text(std::string(data, data + size));
  try
  {
    psmks::readMapFile(text);
  }
  catch (const psmks::MapFileError& error)
  {
    if (std::string(error.what()).size() > 400) std::abort();
  }
  return 0;
}
