/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <mrpt/opengl/COpenGLScene.h>
#include <psmks/slam/ScanMap.h>

namespace psmks
{
/** A map as a scene for MRPT's viewers: grid, points, segments, path, and the robot at its end. */
mrpt::opengl::COpenGLScene::Ptr makeMapScene(const ScanMap& map);
}  // namespace psmks
