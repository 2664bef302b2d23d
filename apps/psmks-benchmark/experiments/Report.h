/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-benchmark/Pictures.h>
#include <apps/psmks-benchmark/experiments/Results.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace psmks
{
/** Writes the experiments as a Markdown page with a description, the tables and the pictures.
 *  @param machine that the times were measured on */
void writeReport(std::ostream& out, const std::vector<DriveResult>& results,
                 const std::vector<Picture>& pictures, const std::string& machine);
}  // namespace psmks
