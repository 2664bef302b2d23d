/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-benchmark/experiments/Results.h>
#include <psmks/eval/Table.h>

#include <vector>

namespace psmks
{
/** How far the driver came, how often it turned, stood or bumped, and how odometry drifts. */
Table driveTable(const std::vector<ResultGroup>& groups);

/** The paper's Table 1: matches, way, turns and times, beside the paper's own. */
Table workTable(const std::vector<ResultGroup>& groups);

/** The paper's Table 2 as means over the drives, beside odometry, the drift floor and the paper. */
Table driftTable(const std::vector<ResultGroup>& groups);

/** Whether a method can be relied on: failures, flags, silent errors, drives won. */
Table reliabilityTable(const std::vector<ResultGroup>& groups);

/** One row a drive and method. */
Table runTable(const std::vector<DriveResult>& results);
}  // namespace psmks
