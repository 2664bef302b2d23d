/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/base/OptionTable.h>

#include <string>
#include <vector>

namespace psmks
{
/** An option as it is written on a command line: "section.key=value". */
struct Assignment
{
  std::string section, key, value;
};

/** Splits the text of an option.
 *  @throws OptionError if it has another form; the text quotes it */
Assignment parseAssignment(const std::string& text);

/** Sets options one after the other.
 *  @throws OptionError for a text of another form, and as OptionTable::set() */
void assignOptions(OptionTable& table, const std::vector<std::string>& assignments);
}  // namespace psmks
