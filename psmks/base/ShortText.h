/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <string>
#include <string_view>

namespace psmks
{
/** The beginning of a text from a file, to quote it in a message: at most 60 characters, of which
 * control characters are shown as '?', and "..." where there are more. */
std::string shortText(std::string_view text);
}  // namespace psmks
