/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/logs/CarmenReader.h>
#include <psmks/mrpt/Convert.h>
#include <tests/fuzz/InputFile.h>

/** A CARMEN log is read to its end; every scan has bearings, a mounting and odometry that are
 * finite.
 */
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const psmks::test::InputFile file(data, size);
  psmks::CarmenReader reader(file.path());
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
