/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/motion/OdometryNoise.h>
#include <psmks/slam/ReferencePolicy.h>

#include <string>
#include <vector>

namespace psmks
{
/** A way to follow a robot: a matcher and what it is matched against. */
struct Method
{
  std::string name;     //!< for tables: "joint keyframe"
  std::string key;      //!< for programs: "joint-keyframe"
  std::string matcher;  //!< see makePairMatcher()
  ReferenceOptions reference;
};

/** Scan matching to the paper's letter: each match a trigger away from the last, no second try. */
Method paperMethod();

/** All that the experiments compare: the paper's, ours with every policy, and MRPT's ICP. Odometry
 * is no method: every table holds it. */
std::vector<Method> experimentMethods();
}  // namespace psmks
