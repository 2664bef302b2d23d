/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/eval/PathErrors.h>
#include <psmks/eval/Relations.h>
#include <psmks/eval/Trajectory.h>
#include <psmks/eval/TrajectoryError.h>
#include <tests/fuzz/InputFile.h>

#include <functional>

namespace
{
void refusedShortly(const std::function<void()>& read)
{
  try
  {
    read();
  }
  catch (const psmks::TrajectoryFileError& error)
  {
    if (std::string(error.what()).size() > 400) std::abort();
  }
}
}  // namespace

/** A trajectory, or relations, are read and compared with themselves, or refused. */
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const psmks::test::InputFile file(data, size);
  refusedShortly(
      [&file]
      {
        const auto read = psmks::readTrajectoryFile(file.path(), psmks::StampOrder::Any);
        read.remarks();
        psmks::trajectoryError(read.trajectory, read.trajectory);
        psmks::driftErrors(psmks::commonPoses(read.trajectory, read.trajectory), 1);
      });
  refusedShortly([&file] { psmks::readTrajectory(file.path()); });
  refusedShortly([&file] { psmks::readRelations(file.path()); });
  return 0;
}
