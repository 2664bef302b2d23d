/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/support/SlamOptions.h>
#include <apps/support/Summary.h>

#include <iosfwd>

namespace psmks
{
/** For people. */
void printSummary(std::ostream& out, const Summary& summary);

/** For programs: everything, with the options and the versions it was made by. */
void writeSummaryJson(std::ostream& out, const Summary& summary, SlamOptions& options);
}  // namespace psmks
