/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <string>

namespace psmks
{
/** An option as one writes it on a command line: "section.key=value". */
struct Assignment
{
  std::string section, key, value;
};

/** @throws OptionError that quotes a text of another form */
Assignment parseAssignment(const std::string& text);
}  // namespace psmks
