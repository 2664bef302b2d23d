/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/poses/CPosePDFGaussian.h>
#include <mrpt/rtti/CObject.h>
#include <mrpt/slam/CICP.h>
#include <mrpt/slam/CMetricMapsAlignmentAlgorithm.h>
#include <psmks/core/Matcher.h>
#include <psmks/mrpt/Convert.h>
#include <psmks/mrpt/LendingPool.h>
#include <psmks/mrpt/MapPoints.h>
#include <psmks/mrpt/ScanMatcherOptions.h>
#include <psmks/mrpt/SurfaceField.h>

#include <optional>

namespace psmks
{
/** PSM-KS as an MRPT map alignment algorithm: a drop-in replacement for mrpt::slam::CICP. Beside
 *  maps it matches pairs of scans.
 *
 *  - Scans are matched by a Matcher: by this project's own scheme, Scheme::Joint, unless the
 *    options choose Scheme::Paper, that of Cuadra Troncoso et al., 2015.
 *  - Maps are matched by MapMatch, which registers the points of one map to the surfaces of the
 *    other; where that does not explain the points, a Matcher looks for a better start in views of
 *    both maps. The reference may be made of any number of scans.
 *
 *  - Every pose is that of `m2` in the frame of `m1`, or that of the robot at the current scan in
 *    the frame of the robot at the reference scan: metres, radians, covariances of (x, y, phi).
 *  - The initial covariance is used as a Gaussian prior. A covariance that is not positive definite
 *    means that the initial pose is only where to begin; MRPT's Align() passes zeros.
 *  - A match that fails gives back the initial pose, with goodness 0 and with the initial
 *    covariance. Where that was not positive definite, scans give a large one, and maps that of
 *    options.guessSigma_m and guessSigma_rad: particle filters, as that of MRPT's rbpf-slam, draw
 *    from the covariance of a map alignment whether it failed or not, and one that says how little
 *    is known would scatter their particles. ReturnInfo::match says why a match failed. Bad data
 *    does not throw.
 *  - A match is logged at the level DEBUG, a failed one at WARN.
 *  - One object may serve several threads while its options stay as they are. A copy has the
 * options of its original and nothing else in common with it. */
class ScanMatcher : public mrpt::slam::CMetricMapsAlignmentAlgorithm, public mrpt::rtti::CObject
{
  DEFINE_MRPT_OBJECT(ScanMatcher, psmks)

 public:
  using Options = ScanMatcherOptions;
  using TConfigParams = ScanMatcherOptions;  //!< as mrpt::slam::CICP calls them

  /** What a match found. A caller that passes a CICP::TReturnInfo gets its fields:
   *  - nIterations: see MatchResult::iterations.
   *  - goodness: 0 to 1, and 0 on failure. 0.4, the threshold that MRPT's map builders use, stands
   *    for a score of `joint.accept_score`, and 1 for a score of 1: every ray is explained by the
   *    other scan.
   *  - quality: the goodness, but 0 where match.status is Degenerate: the scans leave a direction
   *    or the heading open, as in a corridor, or fit elsewhere as well. */
  struct ReturnInfo : public mrpt::slam::CICP::TReturnInfo
  {
    /** The match in the frames of the two sensors, see SensorMounting, or of the two maps, where
     *  MapMatch tells what score, associations and hypotheses mean. */
    MatchResult match;
  };
  using TReturnInfo = ReturnInfo;  //!< as mrpt::slam::CICP calls it

  ScanMatcher();
  explicit ScanMatcher(const Options& options);

  /** May be changed between matches. A match throws an OptionError for options that Matcher does
   *  not accept, such as Ceres in a build without it. */
  Options options;

  /** Matches two scans. Sensor poses, scanning directions, mountings upside down and fields of view
   *  are those of the observations, which may come from different sensors. A scan that is tilted by
   *  more than options.maxTilt_rad is not matched: the status is InvalidInput, and a warning says
   *  so.
   *  @param initial see above
   *  @param info filled where not null
   *  @return pose of the robot at the current scan in the frame of the robot at the reference scan
   *  @throws OptionError see `options` */
  mrpt::poses::CPosePDFGaussian::Ptr align(const mrpt::obs::CObservation2DRangeScan& reference,
                                           const mrpt::obs::CObservation2DRangeScan& current,
                                           const mrpt::poses::CPosePDFGaussian& initial,
                                           ReturnInfo* info = nullptr);

  /** Matches two maps, of which m1 may be made of many scans, see MapMatch. Where the points of m2
   *  are not explained at once, both maps are also turned into scans, see polarView(), and matched
   *  so: m2 as seen from the place of its scanner, options.view.T_map_sensor, and m1 as seen from
   *  where the initial pose puts that place. What is found does not depend much on that place.
   *  @param outInfo filled as far as its class has fields for it: TMetricMapAlignmentResult,
   *  CICP::TReturnInfo or ReturnInfo
   *  @return a CPosePDFGaussian, the pose of m2 in the frame of m1
   *  @throws std::invalid_argument for a null map or one of a class that has no polar view
   *  @throws OptionError see `options` */
  mrpt::poses::CPosePDF::Ptr AlignPDF(
      const mrpt::maps::CMetricMap* m1, const mrpt::maps::CMetricMap* m2,
      const mrpt::poses::CPosePDFGaussian& initialEstimationPDF,
      mrpt::optional_ref<mrpt::slam::TMetricMapAlignmentResult> outInfo = std::nullopt) override;

  /** The same in space, for maps that lie in the plane: x, y and yaw are estimated as AlignPDF()
   *  does. z, pitch and roll stay as they are, with the variances of the initial pose, which are
   *  taken to be at least those of 1 cm and 1 degree.
   *  @return a CPose3DPDFGaussian, the pose of m2 in the frame of m1
   *  @throws std::invalid_argument as AlignPDF(), and if the initial pitch or roll exceeds
   *  options.maxTilt_rad
   *  @throws OptionError see `options` */
  mrpt::poses::CPose3DPDF::Ptr Align3DPDF(
      const mrpt::maps::CMetricMap* m1, const mrpt::maps::CMetricMap* m2,
      const mrpt::poses::CPose3DPDFGaussian& initialEstimationPDF,
      mrpt::optional_ref<mrpt::slam::TMetricMapAlignmentResult> outInfo = std::nullopt) override;

 private:
  /** Two scans, and where their sensors stand in the frames between which the caller asks for the
   *  motion. */
  struct Problem
  {
    const Scan& reference;
    const Scan& current;
    Pose2 T_m1_reference;
    Pose2 T_m2_current;
  };

  /** Memory that is kept from match to match. */
  struct Buffers
  {
    MatcherWorkspace workspace;
    ScanConverter referenceConverter, currentConverter;
    Scan reference, current;
    SurfaceField field;
  };

  /** Matches the scans of the problem from an initial pose of m2 in m1, in the frames of the
   *  sensors. */
  MatchResult solve(const Problem& problem, const UncertainPose& T_m1_m2, SearchScope scope,
                    MatcherWorkspace& workspace) const;

  /** Where a match of the views of two maps puts m2 in m1; none where it fails. */
  std::optional<Pose2> poseOfViews(const MapPoints& m1, const MapPoints& m2, const Pose2& T_m1_m2,
                                   MatcherWorkspace& workspace) const;

  MatchResult matchMaps(const mrpt::maps::CMetricMap& m1, const mrpt::maps::CMetricMap& m2,
                        const UncertainPose& guess);

  /** What MRPT reports of a match; all but the execution time. */
  ReturnInfo infoOf(const MatchResult& match) const;

  /** The observation as a scan. One that is tilted too far has no ray, and is warned of. */
  const Scan& planarScan(const mrpt::obs::CObservation2DRangeScan& observation,
                         ScanConverter& converter, Scan& scan) const;
  void report(const MatchResult& match) const;

  LendingPool<Buffers> buffers_;
};
}  // namespace psmks
