/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <benchmark/benchmark.h>
#include <benchmarks/RoomPair.h>
#include <psmks/core/Matcher.h>
#include <psmks/paper/Projection.h>

namespace psmks
{
namespace
{
/** Projects the current scan to the reference viewpoint and marks occlusions, as the paper's
 * orientation search does for each angle. The argument is the number of rays. */
void projection(benchmark::State& state)
{
  const RoomPair pair(static_cast<int>(state.range(0)));
  const Matcher matcher(MatcherOptions::paperScheme());
  MatcherWorkspace workspace;
  SegmentedScan reference, current;
  matcher.segment(pair.reference, workspace, reference);
  matcher.segment(pair.current, workspace, current);
  DenoisedRays rays;
  rays.assign(current);
  Projection projected;
  for (auto _ : state)
  {
    projectScan(rays, current, pair.T_ref_cur_true, reference, projected);
    benchmark::DoNotOptimize(projected.mark.data());
  }
}

BENCHMARK(projection)->Arg(181)->Arg(361);
}  // namespace
}  // namespace psmks
