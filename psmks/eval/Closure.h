/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/core/Matcher.h>
#include <psmks/geometry/Scan.h>

#include <Eigen/Core>
#include <optional>
#include <random>
#include <vector>

namespace psmks
{
/** By how much three matches around a triangle of scans miss each other,
 *
 *     a --T_a_b--> b --T_b_c--> c,   T_a_b T_b_c T_a_c^-1,
 *
 * and the covariance of it that the noise of the scans explains. */
struct Closure
{
  Eigen::Vector3d error;       //!< x, y, phi in the axes of a: m, m, rad
  Eigen::Matrix3d covariance;  //!< of the error: m^2, m rad, rad^2
};

/** Closes triangles of scans.
 *
 * Each scan has a part in two of the three matches, so that their errors are not independent. The
 * covariance is therefore that of repeated closures of the same scans, whose rays are put onto the
 * lines that were found in them and given noise that is drawn anew: of the standard deviation that
 * the segmentation finds, and smoothed over as many rays as it finds. Rays on no line keep their
 * own noise as well. */
class ClosureExperiment
{
 public:
  /** @param draws repeated closures for a covariance, at least kFewestDraws */
  ClosureExperiment(const MatcherOptions& options, int draws, unsigned seed)
      : matcher_(options), draws_(draws), random_(seed)
  {
  }

  /** Fewest draws. Unit: closures. Definition: a covariance of three coordinates has an inverse
   * with a mean from six on; ten leave it a spread of a factor of two. */
  static constexpr int kFewestDraws = 10;

  /** Closes a triangle.
   *  @param T_a_b, T_b_c starts of the matches
   *  @return none where a match fails, or leaves a direction or a choice open */
  std::optional<Closure> close(const Scan& a, const Scan& b, const Scan& c, const Pose2& T_a_b,
                               const Pose2& T_b_c);

  /** Squared Mahalanobis distance of a closure error, 3 on average where the noise explains it. The
   * inverse of a covariance of n draws is too large by (n - 1) / (n - 5) on average. */
  double normalizedSquare(const Closure& closure) const;

 private:
  struct Triangle
  {
    Pose2 T_a_b, T_b_c, T_a_c;
    Eigen::Vector3d error() const;
  };

  std::optional<Triangle> matched(const Triangle& starts);
  std::optional<Pose2> matched(std::size_t reference, std::size_t current, const Pose2& start);
  Scan withNewNoise(const Scan& scan, const SegmentedScan& segmented);

  Matcher matcher_;
  int draws_;
  std::mt19937_64 random_;
  MatcherWorkspace workspace_;
  SegmentedScan scans_[3];  //!< a, b, c
};

/** @param draws of each closure's covariance
 *  @return a standard deviation of each match, besides the noise, with which errors of closures
 * have the expected mean square; 0 where the noise explains them. */
struct MissingSigma
{
  double sigma_m = 0, sigma_rad = 0;
};
MissingSigma missingSigma(const std::vector<Closure>& closures, int draws);
}  // namespace psmks
