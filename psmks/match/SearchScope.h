/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

namespace psmks
{
/** How far from its guess a match may look for the pose. The caller chooses it for every match; the
 *  distances are options of the scheme. */
enum class SearchScope
{
  /** As far as the options allow. The joint scheme tries a grid of poses, up to
   *  JointOptions::wideRadius_m and wideAngle_rad from the guess, where no pose nearer to it
   *  explains the scans, and gives up a guess with a covariance that leaves nothing acceptable. */
  Full,

  /** Without that grid of poses: cheap to refuse, for one of several guesses of which most are
   *  wrong, such as those of keyframes that may show the same place. The joint scheme still looks
   *  for poses that lines vote for within JointOptions::searchRadius_m and searchAngle_rad, and
   *  along walls that leave the place of a guess without covariance open. */
  NearGuess,

  /** The whole window that the covariance of the guess leaves open, to three standard deviations,
   *  however wide, and nothing beyond: for a guess that may be far off and whose covariance says by
   *  how much, such as that of a loop. The best optima of the window are refined, up to twice
   *  JointOptions::refinedHypotheses, and none ends the search, so that places that look alike come
   *  out as MatchResult::ambiguity. */
  WithinCovariance
};
}  // namespace psmks
