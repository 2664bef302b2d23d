/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace psmks
{
/** The numbers of a line of text, separated by blanks, with a decimal point in every locale;
 * nothing where one word of it is no finite number. The CR of a CRLF is a blank. */
std::optional<std::vector<double>> parseNumberRow(std::string_view line);
}  // namespace psmks
