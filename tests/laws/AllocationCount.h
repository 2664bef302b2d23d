/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <cstddef>

namespace psmks
{
/** How often operator new has been called in this program so far. */
std::size_t allocationCount();
}  // namespace psmks
