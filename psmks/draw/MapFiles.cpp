/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <mrpt/core/Clock.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>
#include <mrpt/poses/CPosePDFGaussian.h>
#include <mrpt/serialization/CArchive.h>
#include <psmks/draw/MapFiles.h>
#include <psmks/mrpt/Convert.h>

namespace psmks
{
using mrpt::obs::CActionCollection;
using mrpt::obs::CActionRobotMovement2D;
using mrpt::poses::CPose3DPDFGaussian;
using mrpt::poses::CPosePDFGaussian;

void addKeyframe(const PosedScan& scan, const LaserFrame& frame, mrpt::maps::CSimpleMap& map)
{
  const auto pose = CPose3DPDFGaussian::Create();
  pose->copyFrom(toMrpt(scan.T_world_robot));
  map.insert(pose, std::make_shared<mrpt::obs::CSensoryFrame>(frame.observations));
}

bool saveObject(const mrpt::serialization::CSerializable& object, const std::string& path)
{
  GzipOutput file;
  if (!file.open(path, GzipUse::Always)) return false;
  mrpt::serialization::archiveFrom(file) << object;
  return file.close();
}

void MatchedRawlog::write(const PosedScan& scan, const LaserFrame& frame)
{
  CActionRobotMovement2D motion;
  motion.timestamp = mrpt::Clock::fromDouble(frame.stamp_s);
  motion.estimationMethod = CActionRobotMovement2D::emScan2DMatching;
  motion.poseChange = CPosePDFGaussian::Create(toMrpt(scan.T_last_robot));
  CActionCollection actions;
  actions.insert(motion);

  auto archive = mrpt::serialization::archiveFrom(file_);
  archive << actions << frame.observations;
}
}  // namespace psmks
