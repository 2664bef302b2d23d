/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <mrpt/config/CLoadableOptions.h>
#include <psmks/core/MatcherOptions.h>
#include <psmks/mrpt/PolarView.h>

#include <iosfwd>
#include <string>

namespace psmks
{
/** All options of ScanMatcher: those of the matcher, and what MRPT's maps and mountings need.
 *
 * Files hold each stage in a section of its own: with the section "psmks", segmentation stands in
 * [psmks.segmentation]. */
struct ScanMatcherOptions : public mrpt::config::CLoadableOptions
{
  MatcherOptions matcher;
  ViewOptions view;

  /** Scanners tilted further out of the plane cannot be matched. */
  double maxTilt_rad = degToRad(5);

  /** Time in which the beam goes once round; 0: as the log states, or unknown. A robot that turns
   * while the beam sweeps distorts the scan, see straightenSweep(). */
  double beamTurn_s = 0;

  /** Options that the file does not name keep their values.
   *  @throws OptionError as loadOptions() does; nothing is changed then */
  void loadFromConfigFile(const mrpt::config::CConfigFileBase& source,
                          const std::string& section) override;

  /** Writes every option; loading gives the same values to the last bit. */
  void saveToConfigFile(mrpt::config::CConfigFileBase& target,
                        const std::string& section) const override;

  /** Every option with its meaning, as ini text for the section "psmks". */
  void dumpToTextStream(std::ostream& out) const override;
};

/** The sections of the matcher's options (optionTable(MatcherOptions&)), then view and mounting. */
OptionTable optionTable(ScanMatcherOptions& options);
}  // namespace psmks
