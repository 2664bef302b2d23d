/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/base/OptionTable.h>
#include <psmks/core/WholeScanErrors.h>
#include <psmks/joint/JointOptions.h>
#include <psmks/paper/PaperOptions.h>
#include <psmks/segmentation/SegmentationOptions.h>

namespace psmks
{
enum class Scheme
{
  Joint,  //!< Gauss-Newton over x, y, phi on line pairs and single rays (docs/derivations.md)
  Paper   //!< alternating orientation search and translation regression (paper, section 2)
};

/** All options of a Matcher. The defaults work for the scanners that psmks was measured with, from
 * 4 m to 80 m of range and from 1 degree to 0.25 degrees between rays; docs/options.md lists units,
 *  ranges and meanings. */
struct MatcherOptions
{
  Scheme scheme = Scheme::Joint;
  PreprocessingOptions preprocessing;
  SegmentationOptions segmentation;
  PaperOptions paper;
  JointOptions joint;
  WholeScanOptions wholeScan;

  /** Chooses the paper's scheme, its line filter, and segments as short as suit a scheme that
   *  matches nothing else. */
  void choosePaperScheme();

  /** Holds every option against the range that optionTable() states, and those that depend on each
   *  other against each other: `max_range_m` is 0 or above `min_range_m`, `agreed_score` is at most
   *  `confident_score`, and `unobservable_sigma_m` at least the joint `weak_direction_sigma_m`.
   *  @throws OptionError for the first that is not accepted, quoting option, value and constraint
   */
  void validate() const;

  /** The method of the paper to the letter (config/psmks-paper.ini). */
  static MatcherOptions paperScheme();
};

/** All sections, in the order of the stages: matcher, preprocessing, segmentation, paper, joint,
 * whole_scan. */
OptionTable optionTable(MatcherOptions& options);
}  // namespace psmks
