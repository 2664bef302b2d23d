/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <gtest/gtest.h>
#include <psmks/core/Matcher.h>
#include <tests/support/PoseMatcher.h>
#include <tests/support/RandomNumbers.h>
#include <tests/support/Scenes.h>

#include <string>
#include <vector>

namespace psmks
{
/** A scheme, and the accuracy with which the laws hold for it. The paper's scheme searches the
 * heading in steps of 0.1 degree, and its optimum depends on which of the scans is the reference.
 */
struct Law
{
  const char* name;
  MatcherOptions options;
  double tol_m;
  double tol_rad;
};

/** Prints the parameter of a failing test. */
inline void PrintTo(const Law& law, std::ostream* out) { *out << law.name; }

inline std::vector<Law> bothSchemes()
{
  return {{"Joint", MatcherOptions{}, 0.001, degToRad(0.02)},
          {"Paper", MatcherOptions::paperScheme(), 0.015, degToRad(0.25)}};
}

/** Two noisy scans of one place and the motion between them. */
struct ScanPair
{
  Scan reference, current;
  Pose2 T_ref_cur;
};

/** Tests of a law for both schemes on random pairs of scans in an office. */
class SchemeLaw : public testing::TestWithParam<Law>
{
 protected:
  static constexpr unsigned kSeed = 2015;
  static constexpr int kPairs = 25;

  SchemeLaw() : trace_(__FILE__, __LINE__, random_.seedText()) {}

  /** A pair with a small motion that both schemes find from a guess of zero. */
  ScanPair randomPair(const BeamGrid& grid, double sigma_m = 0.005)
  {
    const Pose2 T_world_ref{random_.uniform(-0.5, 0.5), random_.uniform(-0.5, 0.5),
                            random_.uniform(-kPi, kPi)};
    const Pose2 T_ref_cur{random_.uniform(-0.12, 0.12), random_.uniform(-0.12, 0.12),
                          random_.uniform(-0.1, 0.1)};
    std::mt19937 noise(static_cast<unsigned>(random_.integer(0, 1 << 30)));
    return {castScan(officeRoom(), T_world_ref, grid, 30, sigma_m, noise),
            castScan(officeRoom(), T_world_ref * T_ref_cur, grid, 30, sigma_m, noise), T_ref_cur};
  }

  MatchResult match(const Scan& reference, const Scan& current, const Guess& guess = {})
  {
    return matcher_.match(reference, current, guess, workspace_);
  }

  testing::AssertionResult holds(const MatchResult& result, const Pose2& expected) const
  {
    if (!result.usable()) return testing::AssertionFailure() << result.report();
    return isNearly(result.T_ref_cur, expected, GetParam().tol_m, GetParam().tol_rad);
  }

  test::RandomNumbers random_{kSeed};
  testing::ScopedTrace trace_;
  const Matcher matcher_{GetParam().options};
  MatcherWorkspace workspace_;
};

inline std::string schemeName(const testing::TestParamInfo<Law>& law) { return law.param.name; }

inline const BeamGrid kHalfCircle = BeamGrid::centered(kPi, 361);
inline const BeamGrid kFullCircle = BeamGrid::centered(2 * kPi, 720);
}  // namespace psmks
