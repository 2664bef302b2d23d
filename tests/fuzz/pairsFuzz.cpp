/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/eval/PairsFile.h>
#include <tests/fuzz/InputFile.h>

/** A file of scan pairs is read to its end, or refused with a short text. */
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const psmks::test::InputFile file(data, size);
  try
  {
    psmks::PairsReader reader(file.path());
    for (psmks::ScanPair pair; reader.read(pair);) continue;
  }
  catch (const psmks::PairsFileError& error)
  {
    if (std::string(error.what()).size() > 400) std::abort();
  }
  return 0;
}
