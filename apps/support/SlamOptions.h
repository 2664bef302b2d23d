/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/mrpt/ObservationSlam.h>

#include <string>

namespace psmks
{
/** All options of psmks-slam. In files, the options of matching are in sections [psmks.<stage>],
 * the other ones in [slam.<stage>]. On the command line the stage is enough. */
struct SlamOptions : ObservationSlamOptions
{
  /** Reads options from an ini file.
   *  @throws OptionError if the file is missing, has none of these sections, or for what
   *      loadOptions() refuses */
  void load(const std::string& path);

  /** Sets one option.
   *  @param assignment "stage.key=value"
   *  @throws OptionError if it has another form, or for an unknown option or a value that it
   *      does not accept */
  void set(const std::string& assignment);

  /** All options as the text of a file that load() reads. */
  std::string toIni();

  /** The meaning of all options, with a table for each section. */
  std::string toMarkdown();

  /** The options of all stages. */
  std::vector<OptionField> fields();
};
}  // namespace psmks
