/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/motion/OdometryNoise.h>
#include <psmks/slam/ReferencePolicy.h>

#include <string>
#include <vector>

namespace psmks
{
/** A method of following a robot: a matcher and a policy of reference scans. */
struct Method
{
  std::string name;     //!< name in tables, such as "joint keyframe"
  std::string key;      //!< name for programs, such as "joint-keyframe"
  std::string matcher;  //!< see makePairMatcher()
  ReferenceOptions reference;
};

/** Scan matching exactly as in the paper: a match each time the robot has moved far enough, without
 * a second attempt. */
Method paperMethod();

/** All methods that the experiments compare: that of the paper, ours with all policies, and MRPT's
 * ICP. Odometry is not one of them, for all tables have it. */
std::vector<Method> experimentMethods();
}  // namespace psmks
