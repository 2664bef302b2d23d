/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <mrpt/config/CLoadableOptions.h>
#include <psmks/core/MatcherOptions.h>
#include <psmks/geometry/BeamTiming.h>
#include <psmks/mrpt/PolarView.h>

#include <iosfwd>
#include <string>

namespace psmks
{
/** All options of ScanMatcher: those of the method, those of the view of a map, and those of the
 *  scanner's mounting. The defaults hold for any 2D scanner.
 *
 * In a file every stage has a section of its own: with the section "psmks", the options of the
 * segmentation stand in [psmks.segmentation]. */
struct ScanMatcherOptions : public mrpt::config::CLoadableOptions
{
  MatcherOptions matcher;
  ViewOptions view;

  /** A scan whose scanner is tilted further out of the horizontal plane is not matched. */
  double maxTilt_rad = degToRad(5);

  /** When the scanner casts its rays; a time of 0 = as the log states, else unknown. A robot that
   *  moves while the beam sweeps distorts the scan, see Deskewer. Used by toMountedScan(), that is
   *  by ObservationSlam and by the programs that read logs; ScanMatcher, which knows no motion,
   * does not use it. */
  BeamTiming beam;

  /** Reads the options that the file names; the others keep their values.
   *  @throws OptionError as loadOptions() of ConfigFile.h does; nothing is changed then */
  void loadFromConfigFile(const mrpt::config::CConfigFileBase& source,
                          const std::string& section) override;

  /** Writes every option. Loading them gives the same values to the last bit. */
  void saveToConfigFile(mrpt::config::CConfigFileBase& target,
                        const std::string& section) const override;

  /** Every option with its meaning, as ini text for the section "psmks". */
  void dumpToTextStream(std::ostream& out) const override;
};

/** The sections of optionTable(MatcherOptions&), then [view] and [mounting]. */
OptionTable optionTable(ScanMatcherOptions& options);
}  // namespace psmks
