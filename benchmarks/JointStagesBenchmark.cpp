/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <benchmark/benchmark.h>
#include <benchmarks/RoomPair.h>
#include <psmks/core/Matcher.h>
#include <psmks/features/FreeSpaceScore.h>
#include <psmks/joint/CorrelativeSearch.h>
#include <psmks/joint/GaussNewton.h>
#include <psmks/joint/LinePairing.h>
#include <psmks/joint/LineVotes.h>

namespace psmks
{
namespace
{
/** The segmented scans of the room pair, which the stages of a joint match begin with. */
struct Stages
{
  explicit Stages(const benchmark::State& state) : pair(static_cast<int>(state.range(0)))
  {
    const Matcher matcher;
    MatcherWorkspace workspace;
    matcher.segment(pair.reference, workspace, segmentedReference);
    matcher.segment(pair.current, workspace, segmentedCurrent);
    reference.build(segmentedReference);
    current.build(segmentedCurrent);
  }

  RoomPair pair;
  SegmentedScan segmentedReference, segmentedCurrent;
  ScanFeatures reference, current;
  JointProblem problem;
};

constexpr PairingGates kLastGates{0.05, degToRad(2.5), 0.5, 0, true};

/** Computes what is derived from a scan before it is matched: surfels, short lines, circles. */
void view(benchmark::State& state)
{
  Stages s(state);
  for (auto _ : state)
  {
    s.current.build(s.segmentedCurrent);
    benchmark::DoNotOptimize(s.current.lines.data());
  }
}

void association(benchmark::State& state)
{
  Stages s(state);
  for (auto _ : state)
  {
    s.problem.clear();
    benchmark::DoNotOptimize(
        associateFeatures(s.reference, s.current, s.pair.T_ref_cur_true, kLastGates, s.problem));
  }
}

/** Refines a pose that is 1 cm and half a degree off. */
void gaussNewton(benchmark::State& state)
{
  Stages s(state);
  associateFeatures(s.reference, s.current, s.pair.T_ref_cur_true, kLastGates, s.problem);
  const SolverLimits limits{10, 1e-4, degToRad(1e-3)};
  for (auto _ : state)
  {
    Pose2 T = s.pair.T_ref_cur_true * Pose2{0.01, 0, degToRad(0.5)};
    benchmark::DoNotOptimize(solveByGaussNewton(s.problem, limits, T));
  }
}

/** Scores the rays of one scan on the surfaces of the other. */
void score(benchmark::State& state)
{
  Stages s(state);
  for (auto _ : state)
    benchmark::DoNotOptimize(
        countRays(s.current.points, s.reference.surface, s.pair.T_ref_cur_true, 0.04f));
}

void lineVotes(benchmark::State& state)
{
  Stages s(state);
  LineVotes votes;
  std::vector<Hypothesis> found;
  for (auto _ : state)
  {
    found.clear();
    votes.propose(s.reference, s.current, {}, {1.3, degToRad(60), 4}, found);
    benchmark::DoNotOptimize(found.data());
  }
}

/** Searches a window about the zero guess, that of a search near it or the wide one. */
void correlativeSearch(benchmark::State& state, const SearchWindow& window)
{
  Stages s(state);
  CorrelativeSearch search;
  std::vector<Hypothesis> found;
  for (auto _ : state)
  {
    search.propose(s.reference, s.current, {}, window, 0.04, 8, found);
    benchmark::DoNotOptimize(found.data());
  }
}

BENCHMARK(view)->Arg(361);
BENCHMARK(association)->Arg(361);
BENCHMARK(gaussNewton)->Arg(361);
BENCHMARK(score)->Arg(361);
BENCHMARK(lineVotes)->Arg(361);
BENCHMARK_CAPTURE(correlativeSearch, near, SearchWindow{1.3, degToRad(60)})->Arg(361);
BENCHMARK_CAPTURE(correlativeSearch, wide, SearchWindow{5, degToRad(120)})->Arg(361);
}  // namespace
}  // namespace psmks
