/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/poses/CPosePDFGaussian.h>
#include <mrpt/rtti/CObject.h>
#include <mrpt/slam/CICP.h>
#include <mrpt/slam/CMetricMapsAlignmentAlgorithm.h>
#include <psmks/core/Matcher.h>
#include <psmks/mrpt/Convert.h>
#include <psmks/mrpt/ScanMatcherOptions.h>

namespace psmks
{
/** PSM-KS as an MRPT map alignment algorithm: takes the place of mrpt::slam::CICP call for call,
 * and matches pairs of scans directly, which is more accurate than matching point maps made of
 * them.
 *
 * All poses are those of `m2` (or of the robot at the current scan) in the frame of `m1` (the robot
 * at the reference scan). An initial covariance of zeros, or one that is not positive definite,
 * means "nothing is known beside the pose": MRPT's Align() passes zeros. Any other is a prior that
 * takes part in the estimate.
 *
 * When a match fails (ReturnInfo::match says why) the result is the initial guess with goodness 0,
 * and with its covariance, or a large one where none was given. Bad data does not throw.
 *
 * One object serves one thread; a copy is independent of its original. Each match is logged at
 * DEBUG level, a failed one at WARN. */
class ScanMatcher : public mrpt::slam::CMetricMapsAlignmentAlgorithm, public mrpt::rtti::CObject
{
  DEFINE_MRPT_OBJECT(ScanMatcher, psmks)

 public:
  using Options = ScanMatcherOptions;

  /** What a match found. Callers that pass a CICP::TReturnInfo get that part filled:
   *  - nIterations
   *  - goodness: from 0 to 1; 0 on failure. 0.4, the threshold that MRPT's map builders use, stands
   *    for `accept_score` of the joint scheme, 1 for every ray explained by the other scan.
   *  - quality: goodness, or 0 where the scans leave a direction or the heading open (a corridor)
   */
  struct ReturnInfo : public mrpt::slam::CICP::TReturnInfo
  {
    MatchResult match;  //!< in the frames of the two sensors (or viewpoints), see Convert.h
  };

  ScanMatcher();

  Options options;

  /** Pose of the robot at the current scan in the frame of the robot at the reference scan. Sensor
   *  poses, scanning directions, upside-down mountings and fields of view are those of the scans,
   *  which may come from different sensors.
   *  @param info filled where not null
   *  @throws OptionError if the options choose Ceres in a build without it */
  mrpt::poses::CPosePDFGaussian::Ptr align(const mrpt::obs::CObservation2DRangeScan& reference,
                                           const mrpt::obs::CObservation2DRangeScan& current,
                                           const mrpt::poses::CPosePDFGaussian& initial,
                                           ReturnInfo* info = nullptr);

  /** Pose of m2 in the frame of m1. Both maps are turned into scans seen from one place, the
   *  scanner's place in m2 (options.view) and the same by the guess in m1; see polarView() for the
   *  classes of maps.
   *  @param outInfo filled as far as its class has fields for it: TMetricMapAlignmentResult,
   *  CICP::TReturnInfo or ReturnInfo
   *  @return a CPosePDFGaussian
   *  @throws std::invalid_argument for a null map or one of a class that has no polar view */
  mrpt::poses::CPosePDF::Ptr AlignPDF(
      const mrpt::maps::CMetricMap* m1, const mrpt::maps::CMetricMap* m2,
      const mrpt::poses::CPosePDFGaussian& initialEstimationPDF,
      mrpt::optional_ref<mrpt::slam::TMetricMapAlignmentResult> outInfo = std::nullopt) override;

  /** The same for a guess in the plane: x, y and yaw are estimated; z, pitch and roll stay as they
   *  are, with the covariance of the guess or, where that is smaller, 1 cm and 1 degree.
   *  @return a CPose3DPDFGaussian
   *  @throws std::invalid_argument if pitch or roll exceed options.maxTilt_rad */
  mrpt::poses::CPose3DPDF::Ptr Align3DPDF(
      const mrpt::maps::CMetricMap* m1, const mrpt::maps::CMetricMap* m2,
      const mrpt::poses::CPose3DPDFGaussian& initialEstimationPDF,
      mrpt::optional_ref<mrpt::slam::TMetricMapAlignmentResult> outInfo = std::nullopt) override;

 private:
  /** Two scans and where their sensors stand in the frames that the caller asks for. */
  struct Problem
  {
    const Scan& reference;
    const Scan& current;
    Pose2 T_m1_reference;
    Pose2 T_m2_current;
  };

  /** Buffers that live from match to match. A copied matcher starts with its own. */
  struct Buffers
  {
    Buffers() = default;
    Buffers(const Buffers&) : Buffers() {}
    Buffers& operator=(const Buffers&) { return *this; }

    MatcherWorkspace workspace;
    ScanConverter referenceConverter, currentConverter;
    Scan reference, current;
  };

  UncertainPose solve(const Problem& problem, const UncertainPose& T_m1_m2, ReturnInfo& info);
  /** The observation as a scan; without any ray, and a warning, where it is tilted too far. */
  const Scan& planarScan(const mrpt::obs::CObservation2DRangeScan& observation,
                         ScanConverter& converter, Scan& scan) const;
  void report(const MatchResult& match) const;

  Buffers buffers_;
};
}  // namespace psmks
