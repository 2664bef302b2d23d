/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/paper/Association.h>

#include <Eigen/LU>
#include <cmath>

namespace psmks
{
namespace
{
/** Smallest cosine of incidence of an associated ray; a ray that runs along a line has no range
 * there. Unit: cosine. Evidence: measured. */
constexpr double kMinIncidenceCosine = 0.05;

bool withinMahalanobis(const Eigen::Vector2d& difference, const Eigen::Matrix2d& covariance,
                       double gate)
{
  const double squared = difference.dot(covariance.inverse() * difference);
  return squared < gate * gate;
}

bool areSimilar(const Segment& current, const Line& seenFromReference, const Line& reference,
                double gateOrientation_rad, const PaperOptions& options)
{
  const double radius_m = seenFromReference.r0_m - reference.r0_m;
  const double angle_rad =
      wrapAngle(current.line.phi0_rad + gateOrientation_rad - reference.phi0_rad);
  if (std::abs(radius_m) >= options.radiusGate_m) return false;
  if (std::abs(angle_rad) >= options.angleGate_rad) return false;
  return options.mahalanobisGate <= 0 ||
         withinMahalanobis({radius_m, angle_rad},
                           seenFromReference.covariance + reference.covariance,
                           options.mahalanobisGate);
}

void findSimilarSegments(const Projection& projection, const SegmentedScan& current,
                         const SegmentedScan& reference, double gateOrientation_rad,
                         const PaperOptions& options, std::vector<std::uint8_t>& similar)
{
  similar.clear();
  for (std::size_t c = 0; c < current.segments.size(); ++c)
    for (const Segment& segment : reference.segments)
      similar.push_back(!projection.lineTurned[c] &&
                        areSimilar(current.segments[c], projection.lines[c], segment.line,
                                   gateOrientation_rad, options));
}

int segmentAt(const SegmentedScan& scan, double index)
{
  const int ray = scan.grid.neighbour(static_cast<int>(index), 0);
  return ray < 0 ? SegmentedScan::kNoSegment : scan.segmentOfRay[static_cast<std::size_t>(ray)];
}

/** The reference segments on both sides of a bearing: twice the same inside a segment. */
struct Boundary
{
  int below, above;
};

Boundary boundaryAt(const SegmentedScan& reference, double index)
{
  const double below = std::floor(index);
  return {segmentAt(reference, below), segmentAt(reference, below + 1)};
}

/** r0 / cos(b - phi0) - r' with cos(b - phi0) = n.p / r'. */
bool compare(const Projection& p, std::size_t ray, const Eigen::Vector2d& normal, double r0_m,
             Association& a)
{
  a.incidenceCosine = (normal.x() * p.x_m[ray] + normal.y() * p.y_m[ray]) / p.range_m[ray];
  a.residual_m = r0_m / a.incidenceCosine - p.range_m[ray];
  return a.incidenceCosine > kMinIncidenceCosine;
}

/** The associations of one ray with the similar ones of two candidate lines, the better kept. */
class RayAssociator
{
 public:
  RayAssociator(const DenoisedRays& rays, const Projection& projection,
                const SegmentedScan& reference, Associations& result)
      : rays_(rays), projection_(projection), reference_(reference), result_(result)
  {
  }

  void operator()(std::size_t ray)
  {
    const Boundary at = boundaryAt(reference_, projection_.index[ray]);
    if (at.below == SegmentedScan::kNoSegment && at.above == SegmentedScan::kNoSegment) return;
    Association best, other;
    bool found = tryLine(ray, at.below, best);
    if (at.above != at.below && tryLine(ray, at.above, other))
    {
      if (!found || std::abs(other.residual_m) < std::abs(best.residual_m)) best = other;
      found = true;
    }
    if (found)
      result_.pairs.push_back(best);
    else
      ++result_.refused;
  }

 private:
  bool tryLine(std::size_t ray, int segment, Association& a) const
  {
    if (segment == SegmentedScan::kNoSegment) return false;
    const auto c = static_cast<std::size_t>(rays_.segment[ray]);
    const auto r = static_cast<std::size_t>(segment);
    if (!result_.similar[c * reference_.segments.size() + r]) return false;
    a.ray = ray;
    a.currentSegment = rays_.segment[ray];
    a.referenceSegment = segment;
    return compare(projection_, ray, result_.normals[r], reference_.segments[r].line.r0_m, a);
  }

  const DenoisedRays& rays_;
  const Projection& projection_;
  const SegmentedScan& reference_;
  Associations& result_;
};
}  // namespace

void associate(const DenoisedRays& rays, const Projection& projection, const SegmentedScan& current,
               const SegmentedScan& reference, double gateOrientation_rad,
               const PaperOptions& options, Associations& result)
{
  result.pairs.clear();
  result.refused = 0;
  result.normals.clear();
  for (const Segment& segment : reference.segments) result.normals.push_back(segment.line.normal());
  findSimilarSegments(projection, current, reference, gateOrientation_rad, options, result.similar);

  RayAssociator associateRay(rays, projection, reference, result);
  for (std::size_t i = 0; i < rays.size(); ++i)
    if (projection.mark[i] == RayMark::Visible && rays.segment[i] != SegmentedScan::kNoSegment)
      associateRay(i);
}
}  // namespace psmks
