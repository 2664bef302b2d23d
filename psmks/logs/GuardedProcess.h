/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <cstddef>
#include <functional>

namespace psmks
{
/** Makes a process that was just forked fit for work that may crash: limits the memory that it may
 * take beside what it has, and detaches it from what concerns its parent alone, the signals of the
 * terminal, output, and dumps of crashes. It ends with its parent. */
void guardProcess(std::size_t memory_bytes);

/** Lets a guarded process be ended once it has worked for five seconds of its own time from now on,
 * which is a hundred times what a large image takes to decode. */
void limitWorkingTime();

/** Whether some work, done in a guarded process of its own, ends without a crash, an exception, or
 * more memory or time than it may take. This process does none of it. */
bool endsWell(std::size_t memory_bytes, const std::function<void()>& work);
}  // namespace psmks
