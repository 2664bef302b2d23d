/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/paper/PaperCovariance.h>
#include <psmks/paper/TranslationRegression.h>
#include <tests/support/Scenes.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>

namespace psmks
{
namespace
{
Pose2 plus(const Pose2& T, const Eigen::Vector3d& d)
{
  return {T.x_m + d[0], T.y_m + d[1], wrapAngle(T.phi_rad + d[2])};
}

//  +------------------+
//  |   r   c          |      Two exact scans of a room of 9 x 6 m. Each of the four walls is one
//  |                  |      segment in both, so that every segment has one partner.
//  +------------------+
class PaperCovarianceTest : public testing::TestWithParam<TranslationJacobian>
{
 protected:
  PaperCovarianceTest()
  {
    options_.jacobian = GetParam();
    options_.fineStep_rad = 0;  // no rounding, but where a test is about that
    scan(box({1, 0.5}, 9, 6));
  }

  void scan(const std::vector<Wall>& walls)
  {
    const BeamGrid grid = BeamGrid::centered(2 * kPi, 720);
    reference_ = segmentByWalls(castScan(walls, {}, grid, 30), walls, {});
    current_ = segmentByWalls(castScan(walls, kTruth, grid, 30), walls, kTruth);
  }

  const PaperCovariance& covarianceAtTruth()
  {
    objective_.assign(reference_, current_, options_);
    objective_.evaluate(kTruth, kTruth.phi_rad);
    covariance_.assign(objective_, kTruth);
    return covariance_;
  }

  /** What the two alternating searches find, by Newton's method: the pose where Z' W e = 0, with
   * the associations of the true pose. The residuals e and their slopes are computed here: a
   * point q of the current scan lies r0 / cos(bearing - phi0) - |T q| before its reference line.
   *  @param heading whether the heading is searched, or that of the start kept */
  Pose2 estimate(const Pose2& start, bool heading = true)
  {
    objective_.assign(reference_, current_, options_);
    objective_.evaluate(kTruth, kTruth.phi_rad);
    Pose2 T = start;
    for (int step = 0; step < 8; ++step) T = plus(T, newtonStep(T, heading ? 3 : 2));
    return T;
  }

  static constexpr double kSmall = 1e-5;  // of a numeric derivative, in m or rad
  const Pose2 kTruth{0.3, -0.2, 0.1};
  SegmentedScan reference_, current_;
  PaperOptions options_;
  PoseObjective objective_;
  PaperCovariance covariance_;

 private:
  Eigen::Vector3d newtonStep(const Pose2& T, int unknowns) const
  {
    Eigen::Matrix3d ZtWJ = Eigen::Matrix3d::Zero();
    Eigen::Vector3d ZtWe = Eigen::Vector3d::Zero();
    for (const Association& a : objective_.associations().pairs)
    {
      const auto r = static_cast<std::size_t>(a.referenceSegment);
      const Line& line = reference_.segments[r].line;
      const Eigen::Vector2d q =
          kTruth.inverse() *
          Eigen::Vector2d(objective_.projection().x_m[a.ray], objective_.projection().y_m[a.ray]);
      const auto residualAt = [&](const Pose2& pose)
      {
        const Eigen::Vector2d p = pose * q;
        return line.rangeAt_m(std::atan2(p.y(), p.x())) - p.norm();
      };
      Eigen::Vector3d J;
      for (int k = 0; k < 3; ++k)
      {
        const Eigen::Vector3d d = kSmall * Eigen::Vector3d::Unit(k);
        J[k] = (residualAt(plus(T, d)) - residualAt(plus(T, -d))) / (2 * kSmall);
      }
      Eigen::Vector3d Z = J;
      Z.head<2>() = residualSlope(options_.jacobian, (T * q).normalized(), line.normal());
      const double w =
          objective_.reliability().ofPair(a.currentSegment, a.referenceSegment).weight();
      ZtWJ += w * Z * J.transpose();
      ZtWe += w * Z * residualAt(T);
    }
    Eigen::Vector3d step = Eigen::Vector3d::Zero();
    step.head(unknowns) = -ZtWJ.topLeftCorner(unknowns, unknowns).inverse() * ZtWe.head(unknowns);
    return step;
  }
};

INSTANTIATE_TEST_SUITE_P(Jacobians, PaperCovarianceTest,
                         testing::Values(TranslationJacobian::FrozenBearing,
                                         TranslationJacobian::Full),
                         [](const auto& jacobian) -> std::string {
                           return jacobian.param == TranslationJacobian::Full ? "Full"
                                                                              : "FrozenBearing";
                         });

/** Largest difference of two covariances in any direction, as a share of the second. */
double relativeDifference(const Eigen::Matrix3d& actual, const Eigen::Matrix3d& expected)
{
  const Eigen::Matrix3d L_inverse = Eigen::Matrix3d(expected.llt().matrixL()).inverse();
  const Eigen::Matrix3d whitened = L_inverse * (actual - expected) * L_inverse.transpose();
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(whitened)
      .eigenvalues()
      .cwiseAbs()
      .maxCoeff();
}
}  // namespace

// Every line of both scans is moved by a little in r0 and in phi0, and the estimate is made anew:
// its derivatives carry the covariances of the lines over to the pose. What is left are rays that
// a gate or an edge takes away and the curvature over a step of 10 um: far below 1 %.
TEST_P(PaperCovarianceTest, IsThatOfTheLinesCarriedThroughTheEstimate)
{
  const Eigen::Matrix3d stated = covarianceAtTruth().of(Eigen::Matrix3d::Identity());
  Eigen::Matrix3d numeric = Eigen::Matrix3d::Zero();
  for (SegmentedScan* scan : {&reference_, &current_})
  {
    ASSERT_EQ(scan->segments.size(), 4U);
    for (Segment& segment : scan->segments)
    {
      const Line line = segment.line;
      Eigen::Matrix<double, 3, 2> G;
      for (const int k : {0, 1})
      {
        const auto estimateWith = [&](double by)
        {
          (k == 0 ? segment.line.r0_m : segment.line.phi0_rad) += by;
          const Pose2 T = estimate(kTruth);
          segment.line = line;
          return T;
        };
        const Pose2 more = estimateWith(kSmall), less = estimateWith(-kSmall);
        G.col(k) << more.x_m - less.x_m, more.y_m - less.y_m, more.phi_rad - less.phi_rad;
      }
      G /= 2 * kSmall;
      numeric += G * line.covariance * G.transpose();
    }
  }
  EXPECT_LT(relativeDifference(stated, numeric), 0.01) << stated << "\n\n" << numeric;
}

// The information is J' S^-1 J over the pairs of walls, with J the derivative of a current line
// seen from the reference; here by moving the pose by a little.
TEST_P(PaperCovarianceTest, TheInformationIsThatOfThePairsOfLines)
{
  const Eigen::Matrix3d stated = covarianceAtTruth().information();
  Eigen::Matrix3d numeric = Eigen::Matrix3d::Zero();
  for (const Segment& segment : current_.segments)
  {
    const Line seen = segment.line.transformed(kTruth);
    const auto isPartner = [&](const Segment& other)
    { return std::abs(wrapAngle(other.line.phi0_rad - seen.phi0_rad)) < 1e-3; };
    const auto partner =
        std::find_if(reference_.segments.begin(), reference_.segments.end(), isPartner);
    ASSERT_NE(partner, reference_.segments.end());
    Eigen::Matrix<double, 2, 3> J;
    for (int k = 0; k < 3; ++k)
    {
      const Eigen::Vector3d d = kSmall * Eigen::Vector3d::Unit(k);
      const Line more = segment.line.transformed(plus(kTruth, d));
      const Line less = segment.line.transformed(plus(kTruth, -d));
      J.col(k) << more.r0_m - less.r0_m, wrapAngle(more.phi0_rad - less.phi0_rad);
    }
    J /= 2 * kSmall;
    const Eigen::Matrix2d S = seen.covariance + partner->line.covariance;
    numeric += J.transpose() * S.inverse() * J;
  }
  EXPECT_LT(relativeDifference(stated, numeric), 1e-4);
}

// A covariance is never below what the lines fix at best.
TEST_P(PaperCovarianceTest, NoEstimateIsBetterThanTheLinesAllow)
{
  const PaperCovariance& covariance = covarianceAtTruth();
  const Eigen::Matrix3d excess =
      covariance.of(Eigen::Matrix3d::Identity()) - covariance.information().inverse();
  const double least = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(excess).eigenvalues()[0];
  EXPECT_GT(least, -1e-12);
}

// A heading that is rounded by d moves the place that the regression then finds. Rounded to steps
// of s, d has the variance s^2 / 12.
TEST_P(PaperCovarianceTest, TheStepOfTheOrientationSearchAddsItsRounding)
{
  const Eigen::Matrix3d exact = covarianceAtTruth().of(Eigen::Matrix3d::Identity());
  options_.fineStep_rad = degToRad(0.5);
  const Eigen::Matrix3d rounded = covarianceAtTruth().of(Eigen::Matrix3d::Identity());
  Pose2 turned = kTruth;
  turned.phi_rad += kSmall;
  const Pose2 placed = estimate(turned, false);
  const Eigen::Vector3d shift(placed.x_m - kTruth.x_m, placed.y_m - kTruth.y_m, kSmall);
  const Eigen::Matrix3d expected =
      std::pow(options_.fineStep_rad / kSmall, 2) / 12 * shift * shift.transpose();
  const double scale = expected.cwiseAbs().maxCoeff();
  EXPECT_LT((rounded - exact - expected).cwiseAbs().maxCoeff(), 1e-3 * scale);
}

TEST_P(PaperCovarianceTest, AcrossWhatWasEstimatedItIsZero)
{
  const Eigen::Vector2d open = Eigen::Vector2d(0.6, 0.8);
  Eigen::Matrix<double, 3, 2> known;
  known << -open.y(), 0, open.x(), 0, 0, 1;
  const Eigen::Matrix3d P = covarianceAtTruth().of(known);
  EXPECT_LT((P * Eigen::Vector3d(open.x(), open.y(), 0)).norm(), 1e-15);
  EXPECT_GT(P(2, 2), 0);
  EXPECT_GT(known.col(0).dot(P * known.col(0)), 0);
}

//   ---------------------------     two walls along x: nothing is known of the place along them
TEST_P(PaperCovarianceTest, ACorridorsInformationLeavesThePlaceAlongItOpen)
{
  scan(corridor());
  const Observability o = observability(covarianceAtTruth().information());
  EXPECT_NEAR(std::abs(o.weakDirection.x()), 1, 1e-6);
  // Walls that are parallel to the microradian over 60 m fix nothing that 100 m would not contain.
  EXPECT_GT(o.weakSigma_m, 100);
  EXPECT_LT(o.headingSigma_rad, degToRad(0.1));
}

TEST_P(PaperCovarianceTest, WithoutAssociationsItIsNotFinite)
{
  scan({});
  const PaperCovariance& covariance = covarianceAtTruth();
  EXPECT_FALSE(covariance.of(Eigen::Matrix3d::Identity()).allFinite());
  EXPECT_EQ(covariance.information(), Eigen::Matrix3d::Zero().eval());
}
}  // namespace psmks
