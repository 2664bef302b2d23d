/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-benchmark/experiments/Results.h>
#include <psmks/eval/Table.h>

#include <vector>

namespace psmks
{
/** The drives: their lengths, turns, collisions and standstills, and the drift of odometry. */
Table driveTable(const std::vector<ResultGroup>& groups);

/** Table 1 of the paper with numbers of matches and times, beside the values of the paper. */
Table workTable(const std::vector<ResultGroup>& groups);

/** Table 2 of the paper as means over the drives, beside odometry, the bound of the drift and the
 * values of the paper. */
Table driftTable(const std::vector<ResultGroup>& groups);

/** The reliability of the methods: failures, flags, silent errors, drives in which they are better
 * than others. */
Table reliabilityTable(const std::vector<ResultGroup>& groups);

/** A table with a row for each drive and method. */
Table runTable(const std::vector<DriveResult>& results);
}  // namespace psmks
