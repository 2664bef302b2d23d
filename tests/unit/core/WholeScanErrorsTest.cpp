/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/core/WholeScanErrors.h>

namespace psmks
{
namespace
{
MatchResult matched()
{
  MatchResult result;
  result.status = MatchStatus::Converged;
  result.T_ref_cur = {3, 4, 0.5};
  result.covariance = Eigen::Vector3d(1e-6, 2e-6, 3e-8).asDiagonal();
  return result;
}

/** What the errors add to the covariance of the match. */
Eigen::Matrix3d addedBy(const WholeScanOptions& options)
{
  MatchResult result = matched();
  addWholeScanErrors(options, result);
  return result.covariance - matched().covariance;
}
}  // namespace

TEST(WholeScanErrors, AreNoneByDefault)
{
  EXPECT_EQ(addedBy({}), Eigen::Matrix3d(Eigen::Matrix3d::Zero()));
}

// Both scans err in place: twice the variance, whatever the heading between them.
TEST(WholeScanErrors, OfThePlaceAddUp)
{
  const Eigen::Matrix3d added = addedBy({0.002, 0});
  EXPECT_NEAR(added(0, 0), 2 * 4e-6, 1e-12);
  EXPECT_NEAR(added(1, 1), 2 * 4e-6, 1e-12);
  EXPECT_NEAR(added(2, 2), 0, 1e-15);
}

// A turn of the reference scan by a moves the current one by a (-4, 3) m, at (3, 4) m; its own turn
// does not.
TEST(WholeScanErrors, OfTheHeadingOfTheReferenceSwingTheCurrentScan)
{
  const Eigen::Matrix3d added = addedBy({0, 0.01});
  EXPECT_NEAR(added(0, 0), 16 * 1e-4, 1e-12);
  EXPECT_NEAR(added(1, 1), 9 * 1e-4, 1e-12);
  EXPECT_NEAR(added(0, 1), -12 * 1e-4, 1e-12);
  EXPECT_NEAR(added(2, 2), 2 * 1e-4, 1e-12);
}

TEST(WholeScanErrors, AFailureKeepsItsCovariance)
{
  MatchResult result = matched();
  result.status = MatchStatus::NoImprovement;
  addWholeScanErrors({0.1, 0.1}, result);
  EXPECT_EQ(result.covariance, matched().covariance);
}
}  // namespace psmks
