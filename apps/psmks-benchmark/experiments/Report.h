/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-benchmark/Pictures.h>
#include <apps/psmks-benchmark/experiments/Results.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace psmks
{
/** The experiments as a Markdown page: what was done, the tables, the pictures.
 *  @param machine what the times depend on */
void writeReport(std::ostream& out, const std::vector<DriveResult>& results,
                 const std::vector<Picture>& pictures, const std::string& machine);
}  // namespace psmks
