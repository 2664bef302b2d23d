/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <mrpt/config/CConfigFileBase.h>
#include <psmks/base/OptionTable.h>

#include <string>

namespace psmks
{
/** Reads options from an MRPT configuration file. The options of a stage stand in the section
 *  "<section>.<stage>": with the section "psmks", those of the segmentation stand in
 *  [psmks.segmentation]. Options that the file does not name keep their values. Sections that do
 *  not begin with "<section>." are ignored, so other programs may share the file. A file that does
 *  not exist is, for MRPT, one without sections: nothing is set.
 *
 *  @throws OptionError that quotes section, key, value and what is allowed: for a section or a key
 *  that the table does not have, for a key in the section "<section>" itself, and for text that is
 *  no value of its option. Options that stand before it in the file are then already set. */
void loadOptions(OptionTable& table, const mrpt::config::CConfigFileBase& file,
                 const std::string& section);

/** Whether a file holds options of any stage: a section that begins with "<section>.". */
bool hasStages(const mrpt::config::CConfigFileBase& file, const std::string& section);

/** Writes every option. loadOptions() from the file, or from the same object in memory, gives the
 *  same values to the last bit. */
void saveOptions(const OptionTable& table, mrpt::config::CConfigFileBase& file,
                 const std::string& section);
}  // namespace psmks
