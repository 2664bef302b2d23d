/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/paper/MatchingError.h>
#include <psmks/paper/Projection.h>

#include <vector>

namespace psmks
{
/** The objective function f of the paper (section 2.3): a pose in, a matching error out. Each
 *  evaluation projects, prunes and associates anew. Refers to the scans and the options. */
class PoseObjective
{
 public:
  /** Begins with a pair of scans; allocates nothing once it has served scans of these sizes. */
  void assign(const SegmentedScan& reference, const SegmentedScan& current,
              const PaperOptions& options);

  struct Value
  {
    double error = 0;      //!< see matchingError()
    int associations = 0;  //!< rays
    int refused = 0;       //!< rays
  };

  /** @param gateOrientation_rad heading of the current scan at which the angle gate is tested */
  Value evaluate(const Pose2& T_ref_cur, double gateOrientation_rad);

  /** True where a pose is better than another: it associates minAssociations rays and its matching
   *  error is smaller. Where one of the two associates less than minAssociationShare of the other's
   *  rays, the other is better, whatever the errors.
   *
   *  Differs from the paper: that leaves open how errors over different numbers of rays compare.
   * The mean falls whenever a badly fitting pair is lost, and the pose with the least overlap would
   *  win. A charge on lost rays makes the error jump with every short segment that crosses a gate.
   */
  bool isBetter(const Value& value, const Value& other) const;

  /** An orientation that a search tried. */
  struct Trial
  {
    double phi_rad;
    Value value;
  };

  /** The buffer of the orientation search. */
  std::vector<Trial>& trials() { return trials_; }

  /** Of the last evaluation. */
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
