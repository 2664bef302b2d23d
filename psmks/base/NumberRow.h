/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace psmks
{
/** Whether NaN and infinity are numbers of a row. */
enum class NonFinite
{
  Refused,
  Admitted
};

/** The numbers in a line of text.
 *
 * Blanks, tabs and carriage returns separate them. A number is written as in C without a leading
 * plus sign, with a decimal point whatever the locale.
 *  @return nothing if a word of the line is not a number, or not a finite one where others are
 *      refused; no numbers if the line is blank */
std::optional<std::vector<double>> parseNumberRow(std::string_view line,
                                                  NonFinite nonFinite = NonFinite::Refused);
}  // namespace psmks
