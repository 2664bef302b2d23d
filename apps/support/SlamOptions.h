/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/mrpt/ObservationSlam.h>

#include <string>

namespace psmks
{
/** Every option of psmks-slam. In files, matching stands in the sections [psmks.<stage>], the rest
 * in [slam.<stage>]; on the command line a stage is enough. */
struct SlamOptions : ObservationSlamOptions
{
  /** @throws OptionError for a file that is missing or holds none of our sections, and for what
   *  loadOptions() refuses */
  void load(const std::string& path);

  /** @param assignment "stage.key=value"
   *  @throws OptionError */
  void set(const std::string& assignment);

  /** All of them, as load() reads them. */
  std::string toIni();

  /** What they mean: a table for every section. */
  std::string toMarkdown();

  /** One list for all stages. */
  std::vector<OptionField> fields();
};
}  // namespace psmks
