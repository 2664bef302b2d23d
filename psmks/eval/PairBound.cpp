/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/eval/PairBound.h>
#include <psmks/eval/SharedLines.h>
#include <psmks/eval/Statistics.h>
#include <psmks/features/CirclePairing.h>
#include <psmks/features/ShortLines.h>
#include <psmks/geometry/Observability.h>
#include <psmks/geometry/RangeInformation.h>
#include <psmks/segmentation/Segmentation.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace psmks
{
namespace
{
/** A segmented scan with its circles at its true pose. */
struct TruthView
{
  Pose2 T_ref_scan;
  SegmentedScan scan;
  std::vector<Circle> circles;
  std::vector<int> circleOfRay;
  std::vector<Segment> shortLines;

  TruthView(Scan raw, const Pose2& T_ref_scan_true, const RangeNoise& noise)
      : T_ref_scan(T_ref_scan_true)
  {
    raw.rangeSigma_m = noise.sigma_m;
    SegmentationOptions options;
    options.rangeSigmaPerMetre_m = noise.sigmaPerMetre_m;
    options.estimateRangeSigma = false;
    SegmentationBuffers buffers;
    segmentScan(raw, {}, options, buffers, scan);
    findCircles(scan, circles, circleOfRay);
    findShortLines(scan, circleOfRay, shortLines);
  }
};

void addLines(const TruthView& view, SharedLines& lines)
{
  for (const Segment& segment : view.scan.segments) lines.add(segment, view.T_ref_scan);
  for (const Segment& segment : view.shortLines) lines.add(segment, view.T_ref_scan);
}

/** Adds each ray of a scan to the information of the wall on which it ends. */
void addRays(const TruthView& view, bool isCurrent, const SharedLines& lines,
             std::vector<RangeInformation>& walls)
{
  const Eigen::Matrix2d R_ref_scan = view.T_ref_scan.rotation();
  const RangeNoise& noise = view.scan.rangeNoise;
  for (int ray = 0; ray < view.scan.rays(); ++ray)
  {
    if (!view.scan.isValid(ray)) continue;
    const Eigen::Vector2d direction = R_ref_scan * view.scan.grid.direction(ray);
    const double range_m = view.scan.range_m[static_cast<std::size_t>(ray)];
    const Eigen::Vector2d end_m = view.T_ref_scan.translation() + range_m * direction;
    const SharedLines::Piece* piece = lines.pieceAt(direction, end_m, noise.sigmaAt_m(range_m));
    if (piece == nullptr) continue;
    const AnchoredLine& wall = lines.pieces()[piece->wall].line;
    walls[piece->wall].add(
        {view.T_ref_scan.translation(), direction, range_m, 0, isCurrent, noise.weightAt(range_m)},
        SurfaceContact::onLine(wall.normal, wall.anchor_m, end_m));
  }
}

Eigen::Matrix3d lineInformation(const TruthView& reference, const TruthView& current)
{
  SharedLines lines;
  addLines(reference, lines);
  addLines(current, lines);
  lines.group();
  std::vector<RangeInformation> walls(lines.pieces().size());
  addRays(reference, false, lines, walls);
  addRays(current, true, lines, walls);
  PoseInformation sums;
  for (const RangeInformation& wall : walls) wall.addTo(sums);
  return sums.information / reference.scan.rangeNoise.varianceAt_m2(0);
}

/** The information of pairs of circles. A pair measures R q + t = p, with the covariances of both
 * centres p and q. */
Eigen::Matrix3d circleInformation(const TruthView& reference, const TruthView& current)
{
  constexpr double kSamePlace_m = 0.05;
  std::vector<CirclePairTerm> pairs;
  pairCircles(reference.circles, current.circles, current.T_ref_scan, kSamePlace_m, pairs);
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  for (const CirclePairTerm& pair : pairs)
  {
    Eigen::Matrix<double, 2, 3> J;
    J << Eigen::Matrix2d::Identity(), current.T_ref_scan.rotationDerivative() * pair.curCentre_m;
    information += J.transpose() * pair.information * J;
  }
  return information;
}

/** Draws random errors of position and heading with the covariances of bounds. */
class ErrorDraws
{
 public:
  void add(const Eigen::Matrix3d& information)
  {
    constexpr int kDrawsPerPair = 20;
    const bool isPositionKnown = observability(information).weakSigma_m < kOpen_m;
    const double headingSigma_rad = 1 / std::sqrt(headingInformation(information));
    const bool isHeadingKnown = headingSigma_rad < kOpen_rad;
    // With information = L L', the vector inv(L') white has the inverse of it as its covariance.
    const Eigen::LLT<Eigen::Matrix2d> position(positionInformation(information));
    for (int i = 0; i < kDrawsPerPair; ++i)
    {
      const Eigen::Vector2d white(normal_(random_), normal_(random_));
      const double heading_rad = headingSigma_rad * std::abs(normal_(random_));
      errors_.push_back({isPositionKnown ? position.matrixU().solve(white).norm() : kInfinity,
                         isHeadingKnown ? heading_rad : kInfinity});
    }
  }

  const std::vector<PairError>& errors() const { return errors_; }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  /** Larger sigmas count as infinite. */
  static constexpr double kOpen_m = 0.5, kOpen_rad = degToRad(20);

  /** The information of the position if the heading is estimated too. */
  static Eigen::Matrix2d positionInformation(const Eigen::Matrix3d& information)
  {
    const Eigen::Vector2d coupling = information.topRightCorner<2, 1>();
    return information.topLeftCorner<2, 2>() - coupling * coupling.transpose() / information(2, 2);
  }

  /** The information of the heading if the position is estimated too. A direction in which the
   * scans do not constrain the position takes nothing away from the heading: a coupling with it
   * comes from the noise of parallel lines. */
  static double headingInformation(const Eigen::Matrix3d& information)
  {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> position(
        information.topLeftCorner<2, 2>());
    const Eigen::Vector2d coupling =
        position.eigenvectors().transpose() * information.topRightCorner<2, 1>();
    double left = information(2, 2);
    for (int i = 0; i < 2; ++i)
      if (position.eigenvalues()[i] > 1 / (kOpen_m * kOpen_m))
        left -= coupling[i] * coupling[i] / position.eigenvalues()[i];
    return std::max(left, 0.0);
  }

  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  std::vector<PairError> errors_;
};
}  // namespace

PairBound pairBound(const Scan& reference, const Scan& current, const Pose2& T_ref_cur_true,
                    const RangeNoise& noise)
{
  const TruthView ref(reference, Pose2{}, noise);
  const TruthView cur(current, T_ref_cur_true, noise);
  return {lineInformation(ref, cur) + circleInformation(ref, cur)};
}

std::vector<PairError> drawnErrors(const std::vector<PairBound>& bounds)
{
  ErrorDraws draws;
  for (const PairBound& bound : bounds) draws.add(bound.information);
  return draws.errors();
}

BoundSummary summarize(const std::vector<PairBound>& bounds)
{
  constexpr double kP95 = 0.95;
  std::vector<double> translations_m, rotations_rad;
  for (const PairError& error : drawnErrors(bounds))
  {
    translations_m.push_back(error.translation_m);
    rotations_rad.push_back(error.rotation_rad);
  }
  return {median(translations_m), quantile(translations_m, kP95), median(rotations_rad),
          quantile(rotations_rad, kP95)};
}
}  // namespace psmks
