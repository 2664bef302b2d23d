/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/experiments/Method.h>

namespace psmks
{
namespace
{
ReferenceOptions triggered()
{
  ReferenceOptions reference;
  reference.choice = ReferenceChoice::Sequential;
  reference.matchEveryScan = false;
  reference.retryLastScan = false;
  return reference;
}

ReferenceOptions everyScan(ReferenceChoice choice)
{
  ReferenceOptions reference;
  reference.choice = choice;
  return reference;
}
}  // namespace

Method paperMethod() { return {"paper", "paper", "psmks-paper", triggered()}; }

std::vector<Method> experimentMethods()
{
  return {paperMethod(),
          {"joint sequential", "joint-sequential", "psmks", triggered()},
          {"joint keyframe", "joint-keyframe", "psmks", everyScan(ReferenceChoice::Keyframe)},
          {"joint map", "joint-map", "psmks", everyScan(ReferenceChoice::Map)},
          {"MRPT ICP", "icp", "icp-classic", triggered()}};
}
}  // namespace psmks
