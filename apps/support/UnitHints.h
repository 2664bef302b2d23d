/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/CommonPoses.h>
#include <psmks/eval/Trajectory.h>
#include <psmks/slam/PosedScan.h>

#include <string>
#include <vector>

namespace psmks
{
/** What in a log looks like another unit than metres, seconds and radians, and where the path of
 * the scans and that of the odometry are far from as long as each other. Each hint is a sentence
 * without a full stop. */
std::vector<std::string> unitHints(const std::vector<PosedScan>& scans);

/** Whether a truth is in another unit of length than an estimate, or its headings are in degrees;
 * see unitHints(). */
std::vector<std::string> unitHints(const std::vector<CommonPose>& common);

/** Whether the stamps of two trajectories without common poses are in different units of time, as a
 * part of a sentence; empty where they are not. */
std::string stampHint(const Trajectory& estimate, const Trajectory& truth);
}  // namespace psmks
