/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/core/MatcherOptions.h>
#include <psmks/geometry/BeamGrid.h>
#include <psmks/geometry/Scan.h>
#include <psmks/match/Guess.h>
#include <psmks/match/MatchResult.h>

#include <vector>

/** \file
 * The shortest way to match two scans: one function call.
 *
 *     using namespace psmks;
 *     const BeamGrid grid = BeamGrid::centered(degToRad(270), 541);  // field of view, rays
 *     const MatchResult match = align(reference_m, current_m, grid);
 *     if (match.usable()) std::cout << match.report() << '\n';
 *
 * Every function of this file keeps the same contract:
 *
 *  - The result's `T_ref_cur` is the pose of the current sensor frame in the reference sensor
 *    frame: it maps points of the current scan into the frame of the reference scan. Both frames
 *    have x forward, y left and bearings counter-clockwise; lengths are in metres, angles in
 *    radians. MatchResult describes the covariance.
 *  - A range that is NaN, infinite, zero or negative is no return. The ray is left out.
 *  - Bad data never throws. A failure is told by MatchResult::usable() and its `status`; the pose
 *    is then the guess, or the identity where the guess is not finite. The status is InvalidInput
 *    for a scan without a return, for a scan whose number of ranges is not the number of rays of
 *    its grid, and for a guess that is not finite, farther than 1e15 m, or whose covariance is not
 *    positive definite.
 *  - Options that cannot be accepted throw an OptionError, as the constructor of Matcher does.
 *    Ceres is not available here.
 *  - A call makes a Matcher and its buffers and drops both, so it may run in any number of threads
 *    at once. A program that matches many scans keeps one Matcher and one MatcherWorkspace a
 *    thread, which allocate nothing after the first match and segment a reference only once; the
 *    results are the same to the last bit. */

namespace psmks
{
/** Matches two scans, which may come from different scanners.
 *  @param guess where the current sensor is assumed to stand in the reference frame, see Guess;
 *  without it, at the same place */
MatchResult align(const Scan& reference, const Scan& current, const Guess& guess = {},
                  const MatcherOptions& options = {});

/** Matches two scans of one scanner that are given as plain ranges.
 *  @param reference_m one range in metres for every ray of the grid, in the order of the grid:
 *  counter-clockwise, the first one at BeamGrid::firstBearing_rad()
 *  @param current_m the same for the current scan
 *  @param grid bearings of the scanner's rays, made from their field of view by
 *  BeamGrid::centered(), or from the first bearing, the increment and the number of rays */
MatchResult align(const std::vector<double>& reference_m, const std::vector<double>& current_m,
                  const BeamGrid& grid, const Guess& guess = {},
                  const MatcherOptions& options = {});

/** The same for ranges in single precision, as many drivers deliver them. */
MatchResult align(const std::vector<float>& reference_m, const std::vector<float>& current_m,
                  const BeamGrid& grid, const Guess& guess = {},
                  const MatcherOptions& options = {});
}  // namespace psmks
