/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <mrpt/config/CConfigFileBase.h>
#include <psmks/base/OptionTable.h>

#include <string>

namespace psmks
{
/** Reads options from an MRPT configuration file: those of stage X from its section "<section>.X",
 *  e.g. [psmks.segmentation] for the section "psmks". Options that the file does not name keep
 * their values; sections outside the prefix are none of ours.
 *
 *  @throws OptionError for a section or key under the prefix that the table does not have, and for
 * a value that is no value of its option; the options before it in the file are then set already */
void loadOptions(OptionTable& table, const mrpt::config::CConfigFileBase& file,
                 const std::string& section);

/** Writes every option; loadOptions() of the same file, or of the same object in memory, gives the
 *  same values to the last bit. */
void saveOptions(const OptionTable& table, mrpt::config::CConfigFileBase& file,
                 const std::string& section);
}  // namespace psmks
