/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <pcl/console/print.h>
#include <pcl/point_types.h>
#include <pcl/registration/gicp.h>
#include <psmks/base/Stopwatch.h>
#include <psmks/features/RayPoints.h>
#include <psmks/matchers/PairMatcherRegistration.h>
#include <psmks/segmentation/Preprocessing.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

namespace psmks
{
namespace
{
using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Gicp = pcl::GeneralizedIterativeClosestPoint<pcl::PointXYZ, pcl::PointXYZ>;

constexpr double kGate_m = 1.0;       // largest distance of the points of a pair
constexpr float kExplained_m = 0.1F;  // a point this close to the other scan counts as explained
/** Least share of explained points of a usable match, as for MRPT's ICP. */
constexpr double kAcceptedShare = 0.40;
/** Number of points that GICP takes for the neighbourhood of a point. */
constexpr std::size_t kLeastPoints = 20;

/** The points that the covariance of a point is computed from. */
enum class Surface
{
  Nearest,  //!< the nearest points in space, as in PCL, although all points lie in a plane
  Rays      //!< those of the neighbouring rays, in the plane
};

Cloud::Ptr toCloud(const Scan& scan)
{
  SegmentedScan cleaned;
  cleanScan(scan, PreprocessingOptions(), cleaned);
  RayPoints points;
  points.build(cleaned);
  auto cloud = std::make_shared<Cloud>();
  for (std::size_t i = 0; i < points.size(); ++i)
    cloud->emplace_back(points.x_m[i], points.y_m[i], 0.0F);
  return cloud;
}

/** A covariance that is large along the surface, and small across it and out of the plane.
 *  @param scatter matrix of the points around, in the plane */
Eigen::Matrix3d surfaceCovariance(const Eigen::Matrix2d& scatter)
{
  constexpr double kAcross = 1e-3, kAlong = 1;
  const Eigen::Vector2d along =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(scatter).eigenvectors().col(1);
  Eigen::Matrix3d covariance = kAcross * Eigen::Matrix3d::Identity();
  covariance.topLeftCorner<2, 2>() += (kAlong - kAcross) * along * along.transpose();
  return covariance;
}

Gicp::MatricesVectorPtr rayCovariances(const Cloud& cloud)
{
  constexpr int kToEitherSide = 4;
  auto covariances = std::make_shared<Gicp::MatricesVector>();
  const int points = static_cast<int>(cloud.size());
  for (int i = 0; i < points; ++i)
  {
    const int first = std::max(0, i - kToEitherSide);
    const int last = std::min(points - 1, i + kToEitherSide);
    Eigen::Matrix2Xd around(2, last - first + 1);
    for (int n = first; n <= last; ++n)
      around.col(n - first) =
          cloud[static_cast<std::size_t>(n)].getVector3fMap().head<2>().cast<double>();
    around.colwise() -= around.rowwise().mean().eval();
    covariances->push_back(surfaceCovariance(around * around.transpose()));
  }
  return covariances;
}

Eigen::Matrix4f toMatrix(const Pose2& pose)
{
  Eigen::Matrix4f matrix = Eigen::Matrix4f::Identity();
  matrix.topLeftCorner<2, 2>() = pose.rotation().cast<float>();
  matrix.block<2, 1>(0, 3) = pose.translation().cast<float>();
  return matrix;
}

Pose2 toPose(const Eigen::Matrix4f& matrix)
{
  return {matrix(0, 3), matrix(1, 3), std::atan2(matrix(1, 0), matrix(0, 0))};
}

/** PCL's generalised ICP with its default parameters but for the gate, on the points of two scans.
 *
 *  PCL reports convergence for nearly every result. Here a match fails (NoImprovement) if less than
 * kAcceptedShare of the points are explained; `score` is that share. There is no covariance. */
class GicpPairMatcher : public PairMatcher
{
 public:
  GicpPairMatcher(std::string name, Surface surface) : name_(std::move(name)), surface_(surface)
  {
    pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
    gicp_.setMaxCorrespondenceDistance(kGate_m);
  }

  std::string name() const override { return name_; }

  MatchResult match(const Scan& reference, const Scan& current, const Guess& guess) override
  {
    Stopwatch stopwatch;
    const Cloud::Ptr referenceCloud = toCloud(reference), currentCloud = toCloud(current);
    if (referenceCloud->empty() || currentCloud->empty() || !guess.T_ref_cur.isFinite())
      return keptGuess(MatchStatus::InvalidInput, guess);
    if (std::min(referenceCloud->size(), currentCloud->size()) < kLeastPoints)
      return keptGuess(MatchStatus::TooFewAssociations, guess);

    setClouds(referenceCloud, currentCloud);
    MatchResult result = align(guess);
    result.times.refinement_s = stopwatch.lap_s();
    return result;
  }

 private:
  void setClouds(const Cloud::Ptr& reference, const Cloud::Ptr& current)
  {
    gicp_.setInputTarget(reference);
    gicp_.setInputSource(current);
    if (surface_ == Surface::Nearest) return;
    gicp_.setTargetCovariances(rayCovariances(*reference));
    gicp_.setSourceCovariances(rayCovariances(*current));
  }

  MatchResult align(const Guess& guess)
  {
    Cloud aligned;
    gicp_.align(aligned, toMatrix(guess.T_ref_cur));
    const int explained = gicp_.hasConverged() ? explainedPoints(aligned) : 0;

    MatchResult result = keptGuess(MatchStatus::NoImprovement, guess);
    result.associations = explained;
    result.score = static_cast<double>(explained) / static_cast<double>(aligned.size());
    if (result.score < kAcceptedShare) return result;
    result.status = MatchStatus::Converged;
    result.T_ref_cur = toPose(gicp_.getFinalTransformation());
    result.covariance = MatchResult::unknownCovariance();
    return result;
  }

  int explainedPoints(const Cloud& aligned) const
  {
    const auto tree = gicp_.getSearchMethodTarget();
    pcl::Indices nearest(1);
    std::vector<float> squaredDistance_m2(1);
    int explained = 0;
    for (const auto& point : aligned)
      if (tree->nearestKSearch(point, 1, nearest, squaredDistance_m2) == 1 &&
          squaredDistance_m2.front() < kExplained_m * kExplained_m)
        ++explained;
    return explained;
  }

  std::string name_;
  Surface surface_;
  Gicp gicp_;
};

PairMatcherRegistration registration(const std::string& name, int place,
                                     const std::string& description, Surface surface)
{
  return PairMatcherRegistration({name, description, PairMatcherFamily::Gicp, place,
                                  [surface](const std::string& asked, const MatcherOptions&)
                                  { return std::make_unique<GicpPairMatcher>(asked, surface); }});
}

const std::array<PairMatcherRegistration, 2> kRegistrations{
    registration("pcl-gicp", 0, "PCL's generalised ICP, its own covariances in 3D",
                 Surface::Nearest),
    registration("pcl-gicp-planar", 1, "PCL's generalised ICP, covariances from neighbouring rays",
                 Surface::Rays)};
}  // namespace
}  // namespace psmks
