/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <benchmark/benchmark.h>
#include <benchmarks/RoomPair.h>
#include <psmks/segmentation/Segmentation.h>

namespace psmks
{
namespace
{
/** Segments one scan from its raw ranges. The argument is the number of rays. */
void segmentation(benchmark::State& state, LineFilter filter)
{
  const RoomPair pair(static_cast<int>(state.range(0)));
  SegmentationOptions options;
  options.filter = filter;
  SegmentationBuffers buffers;
  SegmentedScan segmented;
  for (auto _ : state)
  {
    segmentScan(pair.reference, PreprocessingOptions(), options, buffers, segmented);
    benchmark::DoNotOptimize(segmented.segments.data());
  }
  state.counters["segments"] = static_cast<double>(segmented.segments.size());
}

BENCHMARK_CAPTURE(segmentation, linear, LineFilter::Linear)->Arg(181)->Arg(361)->Arg(1081);
BENCHMARK_CAPTURE(segmentation, ekf, LineFilter::Ekf)->Arg(181)->Arg(361)->Arg(1081);
}  // namespace
}  // namespace psmks
