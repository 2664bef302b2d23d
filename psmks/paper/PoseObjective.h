/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/paper/MatchingError.h>
#include <psmks/paper/Projection.h>

#include <vector>

namespace psmks
{
/** The objective function f of the paper (section 2.3), which gives the matching error of a pose.
 * Each evaluation projects the current scan, marks what cannot be seen and associates anew. It
 * refers to the scans and the options, which must outlive it. */
class PoseObjective
{
 public:
  /** Begins with a pair of scans. Nothing is allocated if earlier scans had these sizes. */
  void assign(const SegmentedScan& reference, const SegmentedScan& current,
              const PaperOptions& options);

  struct Value
  {
    double error = 0;      //!< see matchingError()
    int associations = 0;  //!< number of associated rays
    int refused = 0;       //!< see Associations::refused
  };

  /** @param gateOrientation_rad heading of the current scan at which the angle gate is tested */
  Value evaluate(const Pose2& T_ref_cur, double gateOrientation_rad);

  /** Whether a pose is better than another one: it has at least minAssociations associations, and
   * its matching error is smaller. If one of the two has fewer than minAssociationShare times the
   * associations of the other, the other is better, whatever the errors.
   *
   * Differs from the paper: it does not say how to compare errors over different numbers of rays.
   * The mean error falls whenever a pair that fits badly is lost, so the pose with the least
   * overlap would win. Adding a penalty for lost rays was tried; it makes the error jump whenever a
   * short segment crosses a gate. */
  bool isBetter(const Value& value, const Value& other) const;

  /** An orientation that the search tried, and its value. */
  struct Trial
  {
    double phi_rad = 0;
    Value value;
  };

  /** The buffer of the orientation search, kept here so that it is allocated once. */
  std::vector<Trial>& trials() { return trials_; }

  /** The projection of the last evaluation. */
  const Projection& projection() const { return projection_; }
  const Associations& associations() const { return associations_; }

  const SegmentedScan& reference() const { return *reference_; }
  const SegmentedScan& current() const { return *current_; }
  const SegmentReliability& reliability() const { return reliability_; }
  const PaperOptions& options() const { return *options_; }

 private:
  const SegmentedScan* reference_ = nullptr;
  const SegmentedScan* current_ = nullptr;
  const PaperOptions* options_ = nullptr;
  DenoisedRays rays_;
  SegmentReliability reliability_;
  Projection projection_;
  Associations associations_;
  std::vector<Trial> trials_;
};
}  // namespace psmks
