/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <cstddef>

namespace psmks
{
/** The number of calls of operator new in this program so far. */
std::size_t allocationCount();
}  // namespace psmks
