/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/logs/CarmenReader.h>
#include <tests/fuzz/InputFile.h>
#include <tests/fuzz/WholeLog.h>

/** A CARMEN log is read to its end. */
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const psmks::test::InputFile file(data, size);
  psmks::CarmenReader reader(file.path());
  psmks::test::readWhole(reader);
  return 0;
}
