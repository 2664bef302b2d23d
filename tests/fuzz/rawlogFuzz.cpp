/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/logs/RawlogReader.h>
#include <psmks/mrpt/Convert.h>
#include <tests/fuzz/InputFile.h>

/** A rawlog is read to its end or to its damage. Its decoder may crash: it runs in a process of its
 * own. */
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const psmks::test::InputFile file(data, size);
  psmks::RawlogReader reader(file.path());
  psmks::ScanConverter converter;
  for (psmks::LaserFrame frame; reader.next(frame);)
  {
    converter.convert(*frame.scan);
    const psmks::Pose2 mounting = psmks::sensorMounting(*frame.scan).T_robot_sensor;
    if (!mounting.isFinite() || (frame.odometry && !frame.odometry->isFinite())) std::abort();
  }
  reader.remarks();
  if (reader.damage().size() > 400) std::abort();
  return 0;
}
