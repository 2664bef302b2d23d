/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */

/** \file
 * Example 5: MRPT's map builder on psmks.
 *
 * psmks::MapBuilder stands where CMetricMapBuilderICP stood and fills the maps that an ini file of
 * icp-slam asks for. Without arguments the program takes an ini file and a log that Debian's
 * mrpt-common installs; with them, INI LOG. It prints where the robot ends, the size of the map,
 * and how many cells of 5 cm all scans fill: fewer mean a sharper map. */

#include <mrpt/config/CConfigFile.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/obs/CRawlog.h>
#include <mrpt/serialization/CArchive.h>
#include <psmks/eval/OccupiedCells.h>
#include <psmks/mrpt/MapBuilder.h>

#include <cstdio>
#include <exception>
#include <string>

using mrpt::obs::CActionCollection;
using mrpt::obs::CObservation;
using mrpt::obs::CRawlog;
using mrpt::obs::CSensoryFrame;

void buildMap(const std::string& ini, const std::string& log)
{
  psmks::MapBuilder builder;
  builder.loadOptions(mrpt::config::CConfigFile(ini), "MappingApplication");
  builder.initialize();

  mrpt::io::CFileGZInputStream file(log);
  auto archive = mrpt::serialization::archiveFrom(file);
  CActionCollection::Ptr action;
  CSensoryFrame::Ptr frame;
  CObservation::Ptr observation;
  std::size_t entry = 0;
  while (CRawlog::getActionObservationPairOrObservation(archive, action, frame, observation, entry))
    if (observation)
      builder.processObservation(observation);
    else
      builder.processActionObservation(*action, *frame);

  const auto pose = builder.getCurrentPoseEstimation()->getMeanVal();
  psmks::OccupiedCells cells;
  for (const psmks::PosedScan& scan : builder.scans()) cells.add(scan.scan, scan.T_world_sensor());
  std::printf("%zu scans, %u of them in the map, %zu cells\n", builder.scans().size(),
              builder.getCurrentlyBuiltMapSize(), static_cast<std::size_t>(cells.count()));
  std::printf("the robot ends at x %.2f m, y %.2f m, phi %.1f deg\n", pose.x(), pose.y(),
              psmks::radToDeg(pose.yaw()));
}

int main(int argc, char** argv)
{
  const std::string ini =
      argc > 1 ? argv[1] : "/usr/share/mrpt/config_files/icp-slam/icp-slam_demo_classic.ini";
  const std::string log =
      argc > 2 ? argv[2]
               : "/usr/share/mrpt/datasets/2006-01ENE-21-SENA_Telecom Faculty_one_loop_only.rawlog";
  try
  {
    buildMap(ini, log);
    return 0;
  }
  catch (const std::exception& e)
  {
    std::fprintf(stderr, "%s\n", e.what());
    return 1;
  }
}
