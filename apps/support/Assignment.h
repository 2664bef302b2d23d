/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/base/OptionTable.h>

#include <string>
#include <vector>

namespace psmks
{
/** An option as one writes it on a command line: "section.key=value". */
struct Assignment
{
  std::string section, key, value;
};

/** @throws OptionError that quotes a text of another form */
Assignment parseAssignment(const std::string& text);

/** Sets one option after the other.
 *  @throws OptionError for a text of another form, and as OptionTable::set() */
void assignOptions(OptionTable& table, const std::vector<std::string>& assignments);
}  // namespace psmks
