/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <benchmark/benchmark.h>
#include <benchmarks/RoomPair.h>
#include <psmks/core/Matcher.h>
#ifdef PSMKS_WITH_CERES
#include <psmks/ceres/CeresSolvers.h>
#endif

namespace psmks
{
namespace
{
/** Matches the room pair from the zero guess. The argument is the number of rays.
 *  @param segmented whether both scans are segmented before, as in a sequence of scans */
void match(benchmark::State& state, const Matcher& matcher, bool segmented)
{
  const RoomPair pair(static_cast<int>(state.range(0)));
  MatcherWorkspace workspace;
  SegmentedScan reference, current;
  matcher.segment(pair.reference, workspace, reference);
  matcher.segment(pair.current, workspace, current);
  MatchResult result;
  for (auto _ : state)
  {
    result = segmented ? matcher.match(reference, current, {}, workspace)
                       : matcher.match(pair.reference, pair.current, {}, workspace);
    benchmark::DoNotOptimize(result);
  }
  state.SetLabel(toString(result.status));
  state.counters["error_mm"] =
      1e3 * (result.T_ref_cur.translation() - pair.T_ref_cur_true.translation()).norm();
}

void joint(benchmark::State& state) { match(state, Matcher(), false); }
void jointOfSegmentedScans(benchmark::State& state) { match(state, Matcher(), true); }

void paper(benchmark::State& state) { match(state, Matcher(MatcherOptions::paperScheme()), false); }

BENCHMARK(joint)->Arg(181)->Arg(361)->Arg(1081);
BENCHMARK(jointOfSegmentedScans)->Arg(181)->Arg(361)->Arg(1081);
BENCHMARK(paper)->Arg(181)->Arg(361);

#ifdef PSMKS_WITH_CERES
/** As jointOfSegmentedScans, with Ceres in place of Gauss-Newton. */
void jointOfSegmentedScansByCeres(benchmark::State& state)
{
  MatcherOptions options;
  options.joint.solver = JointSolver::Ceres;
  match(state, Matcher(options, makeCeresSolvers()), true);
}

BENCHMARK(jointOfSegmentedScansByCeres)->Arg(181)->Arg(361)->Arg(1081);
#endif
}  // namespace
}  // namespace psmks
