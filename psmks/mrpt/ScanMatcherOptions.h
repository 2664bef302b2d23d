/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <mrpt/config/CLoadableOptions.h>
#include <mrpt/slam/CICP.h>
#include <psmks/core/MatcherOptions.h>
#include <psmks/geometry/BeamTiming.h>
#include <psmks/mrpt/MapRegistration.h>
#include <psmks/mrpt/PolarView.h>

#include <iosfwd>
#include <string>

namespace psmks
{
/** All options of ScanMatcher: those of the method, those of the alignment and of the view of a
 * map, and those of the scanner's mounting. The defaults hold for any 2D scanner.
 *
 * The options of the alignment of maps, RegistrationOptions, have the names of those fields of
 * mrpt::slam::CICP::TConfigParams that steer the same.
 *
 * In a file every stage has a section of its own: with the section "psmks", the options of the
 * segmentation stand in [psmks.segmentation]. */
struct ScanMatcherOptions : public mrpt::config::CLoadableOptions, public RegistrationOptions
{
  MatcherOptions matcher;
  ViewOptions view;

  /** What an alignment of maps claims of an initial pose that states no covariance: what the result
   *  takes from it, all of it in a failure, has these standard deviations. They are about what
   *  odometry errs from scan to scan, for particle filters draw from them. */
  double guessSigma_m = 0.02;
  double guessSigma_rad = degToRad(0.5);

  /** @name Fields of CICP::TConfigParams without a counterpart
   *  Code that sets them compiles, and they change nothing.
   *  @{ */
  mrpt::slam::TICPAlgorithm ICP_algorithm = mrpt::slam::icpClassic;
  mrpt::slam::TICPCovarianceMethod ICP_covariance_method = mrpt::slam::icpCovFiniteDifferences;
  double thresholdAng = degToRad(0.15);
  bool onlyUniqueRobust = false, doRANSAC = false, use_kernel = true;
  bool skip_cov_calculation = false, skip_quality_calculation = true;
  double kernel_rho = 0.07, covariance_varPoints = 0.0004;
  double Axy_aprox_derivatives = 0.05, LM_initial_lambda = 1e-4;
  /** @} */

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

  /** Reads a file as loadFromConfigFile() does.
   *  @throws OptionError also for a file that is not there, and for one that holds no section
   *  "<section>.<stage>" */
  void loadFromConfigFileName(const std::string& file, const std::string& section);

  /** Writes every option. Loading them gives the same values to the last bit. */
  void saveToConfigFile(mrpt::config::CConfigFileBase& target,
                        const std::string& section) const override;

  /** Every option with its meaning, as ini text for the section "psmks". */
  void dumpToTextStream(std::ostream& out) const override;
};

/** The sections of optionTable(MatcherOptions&), then [map], [view] and [mounting]. */
OptionTable optionTable(ScanMatcherOptions& options);
}  // namespace psmks
