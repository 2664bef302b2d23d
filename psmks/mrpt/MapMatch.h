/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/joint/JointOptions.h>
#include <psmks/match/Guess.h>
#include <psmks/match/MatchResult.h>
#include <psmks/mrpt/MapPoints.h>
#include <psmks/mrpt/MapRegistration.h>
#include <psmks/mrpt/SurfaceField.h>

#include <functional>
#include <optional>

namespace psmks
{
/** A match of two maps, such as the points of one scan and a map that many scans were added to.
 *
 *  1. The points of the current map are registered to the surfaces of the reference from the guess
 *     (MapRegistration).
 *  2. Unless they explain most of the points, another way to match proposes a pose, the points are
 *     registered from there too, and the likelier registration counts.
 *  3. It is accepted if enough points are explained, as far as the reference shows surfaces there:
 *     points where it shows none speak neither for it nor against it.
 *
 *  Poses and covariances are of the current map in the frame of the reference. */
class MapMatch
{
 public:
  /** Finds a pose of the current map in the frame of the reference, or none. */
  using Proposer = std::function<std::optional<Pose2>()>;

  /** @param limits the least score and number of associations, and when a direction is open, as in
   *  the joint scheme
   *  @param openCovariance positive definite: what the result takes from a guess that states no
   *  covariance, all of it in a failure, has this one */
  MapMatch(const RegistrationOptions& options, const JointOptions& limits,
           const Eigen::Matrix3d& openCovariance)
      : options_(options), limits_(limits), openCovariance_(openCovariance)
  {
  }

  /** Matches two maps. Bad data never throws.
   *
   *  - `score` is the share of the covered points that are explained, `associations` their number,
   *    `hypotheses` the number of registrations.
   *  - An empty map, or a guess that is not finite, gives InvalidInput.
   *  - Fewer explained points than `min_associations` give TooFewAssociations, a score below
   *    `accept_score` gives NoImprovement.
   *
   *  @param reference its part about the guess is enough
   *  @param guess its covariance, if any, is positive definite
   *  @param field memory, kept from match to match
   *  @param propose asked at most once */
  MatchResult match(const MapPoints& reference, const MapPoints& current, const Guess& guess,
                    SurfaceField& field, const Proposer& propose) const;

 private:
  Registration bestRegistration(MapRegistration& registration, const Guess& guess,
                                const Proposer& propose, MatchResult& result) const;
  void conclude(const Registration& best, const Guess& guess, double pointSigma_m,
                MatchResult& result) const;

  const RegistrationOptions& options_;
  const JointOptions& limits_;
  Eigen::Matrix3d openCovariance_;
};
}  // namespace psmks
