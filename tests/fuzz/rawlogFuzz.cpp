/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/logs/RawlogReader.h>
#include <tests/fuzz/InputFile.h>
#include <tests/fuzz/WholeLog.h>

/** A rawlog is read to its end or to its damage. Its decoder may crash: it runs in a process of its
 * own. */
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const psmks::test::InputFile file(data, size);
  psmks::RawlogReader reader(file.path());
  psmks::test::readWhole(reader);
  return 0;
}
