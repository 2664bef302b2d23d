/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/PairsFile.h>
#include <psmks/match/Guess.h>

#include <random>
#include <string>
#include <vector>

namespace psmks
{
constexpr const char* kZeroGuess = "zero";
constexpr const char* kOdometryGuess = "odometry";

/** The guesses of the matches of a set of pairs. */
struct Guesses
{
  std::string name;
  std::vector<Guess> ofPair;  //!< one for each pair, in their order
};

/** Guesses of no motion without a covariance, which are starting points only. */
Guesses zeroGuesses(const std::vector<ScanPair>& pairs);

/** The odometry of the pairs as a measurement with these standard deviations. */
Guesses odometryGuesses(const std::vector<ScanPair>& pairs, double sigma_m, double sigma_rad);

/** A guess without covariance at a distance from the truth in a random direction, turned by a
 * rotation to a random side. */
Guess displacedGuess(const Pose2& truth, double distance_m, double rotation_rad,
                     std::mt19937_64& random);
}  // namespace psmks
