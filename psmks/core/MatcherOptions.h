/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/base/OptionTable.h>
#include <psmks/joint/JointOptions.h>
#include <psmks/paper/PaperOptions.h>
#include <psmks/segmentation/SegmentationOptions.h>

namespace psmks
{
enum class Scheme
{
  Joint,  //!< Gauss-Newton over x, y, theta on line pairs and single rays (docs/derivations.md)
  Paper   //!< alternating orientation search and translation regression (paper, section 2)
};

/** Everything a Matcher can be told. The defaults hold for any 2D scanner. */
struct MatcherOptions
{
  Scheme scheme = Scheme::Joint;
  PreprocessingOptions preprocessing;
  SegmentationOptions segmentation;
  PaperOptions paper;
  JointOptions joint;

  /** Chooses the paper's scheme, its line filter, and segments as short as suit a scheme that
   *  matches nothing else. */
  void choosePaperScheme();

  /** The method of the paper to the letter (config/psmks-paper.ini). */
  static MatcherOptions paperScheme();
};

/** All sections, in the order of the stages: matcher, preprocessing, segmentation, paper, joint. */
OptionTable optionTable(MatcherOptions& options);
}  // namespace psmks
