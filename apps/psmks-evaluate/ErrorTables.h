/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-evaluate/CommandLine.h>
#include <apps/psmks-evaluate/Comparison.h>
#include <psmks/eval/Table.h>

#include <vector>

namespace psmks
{
/** Makes a table for each measure, with a row for each estimate. All have the same columns. */
std::vector<Table> errorTables(const std::vector<Comparison>& comparisons,
                               const CommandLine& commandLine);
}  // namespace psmks
