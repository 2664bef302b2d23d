/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/paper/PoseObjective.h>

namespace psmks
{
void PoseObjective::assign(const SegmentedScan& reference, const SegmentedScan& current,
                           const PaperOptions& options)
{
  reference_ = &reference;
  current_ = &current;
  options_ = &options;
  rays_.assign(current);
  reliability_.assign(current, reference);
}

PoseObjective::Value PoseObjective::evaluate(const Pose2& T_ref_cur, double gateOrientation_rad)
{
  projectScan(rays_, *current_, T_ref_cur, *reference_, projection_);
  associate(rays_, projection_, *current_, *reference_, gateOrientation_rad, *options_,
            associations_);
  return {matchingError(associations_, reliability_, *options_),
          static_cast<int>(associations_.pairs.size()), associations_.refused};
}

bool PoseObjective::isBetter(const Value& value, const Value& other) const
{
  if (value.associations < options_->minAssociations) return false;
  if (value.associations < options_->minAssociationShare * other.associations) return false;
  if (other.associations < options_->minAssociationShare * value.associations) return true;
  return value.error < other.error;
}
}  // namespace psmks
