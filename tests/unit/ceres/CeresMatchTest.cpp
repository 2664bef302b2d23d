/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/ceres/CeresSolvers.h>
#include <psmks/core/Matcher.h>
#include <tests/support/PoseMatcher.h>
#include <tests/support/RandomNumbers.h>
#include <tests/support/Scenes.h>

namespace psmks
{
namespace
{
constexpr int kPairs = 100;

struct Tolerance
{
  double translation_m, rotation_rad;
};

// The two solvers end at slightly different poses, so that a ray at the edge of a gate may be
// associated in one match and not in the other.
constexpr Tolerance kReassociated{2e-4, degToRad(2e-3)};

// With the same associations both solvers have the same least squares problem. Their solutions then
// differ by the step at which Gauss-Newton stops.
constexpr double kStop = 1e-8;  // m and rad
constexpr Tolerance kSamePartners{10 * kStop, 10 * kStop};

/** Compares whole matches with and without Ceres on random pairs in an office. */
void expectSameMatches(const MatcherOptions& closedForm, const MatcherOptions& ceres,
                       const Tolerance& tolerance)
{
  test::RandomNumbers random(61);
  SCOPED_TRACE(random.seedText());
  const Matcher own(closedForm), withCeres(ceres, makeCeresSolvers());
  MatcherWorkspace workspace;
  std::mt19937 noise(61);
  const BeamGrid grid = BeamGrid::centered(kPi, 181);
  for (int i = 0; i < kPairs; ++i)
  {
    const Pose2 T_world_ref{random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5),
                            random.uniform(-kPi, kPi)};
    const Pose2 T_ref_cur{random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1),
                          random.uniform(-0.1, 0.1)};
    const Scan reference = castScan(officeRoom(), T_world_ref, grid, 30, 0.01, noise);
    const Scan current = castScan(officeRoom(), T_world_ref * T_ref_cur, grid, 30, 0.01, noise);
    const MatchResult a = own.match(reference, current, {}, workspace);
    const MatchResult b = withCeres.match(reference, current, {}, workspace);
    EXPECT_EQ(a.usable(), b.usable()) << "pair " << i;
    EXPECT_TRUE(isNearly(b.T_ref_cur, a.T_ref_cur, tolerance.translation_m, tolerance.rotation_rad))
        << "pair " << i << "\nown:   " << a.report() << "\nCeres: " << b.report();
  }
}
}  // namespace

TEST(CeresMatch, OfTheJointSchemeIsThatOfGaussNewton)
{
  MatcherOptions ceres;
  ceres.joint.solver = JointSolver::Ceres;
  expectSameMatches({}, ceres, kReassociated);
}

TEST(CeresMatch, OfTheJointSchemeWithOneAssociationIsThatOfGaussNewtonToTheLastStep)
{
  MatcherOptions gaussNewton;
  gaussNewton.joint.reassociations = 1;
  gaussNewton.joint.maxIterations = 100;
  gaussNewton.joint.stopTranslation_m = gaussNewton.joint.stopRotation_rad = kStop;
  MatcherOptions ceres = gaussNewton;
  ceres.joint.solver = JointSolver::Ceres;
  expectSameMatches(gaussNewton, ceres, kSamePartners);
}

TEST(CeresMatch, OfThePaperSchemeIsThatOfTheClosedForm)
{
  MatcherOptions ceres = MatcherOptions::paperScheme();
  ceres.paper.translationSolver = TranslationSolver::Ceres;
  expectSameMatches(MatcherOptions::paperScheme(), ceres, kReassociated);
}
}  // namespace psmks
