/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <mrpt/opengl/COpenGLScene.h>
#include <psmks/slam/ScanMap.h>

namespace psmks
{
/** Makes a scene of a map for MRPT's viewers, with a grid, the points, the segments, the path, and
 * a robot at its end. */
mrpt::opengl::COpenGLScene::Ptr makeMapScene(const ScanMap& map);
}  // namespace psmks
