/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/report/WorstPairs.h>

#include <algorithm>
#include <numeric>

namespace psmks
{
namespace
{
double relativeError(const PairError& error, const PairError& limit)
{
  return std::max(error.translation_m / limit.translation_m,
                  error.rotation_rad / limit.rotation_rad);
}
}  // namespace

std::vector<std::size_t> worstRecords(const std::vector<PairRecord>& records, std::size_t count,
                                      const PairError& limit)
{
  std::vector<std::size_t> places(records.size());
  std::iota(places.begin(), places.end(), std::size_t{0});
  std::stable_sort(places.begin(), places.end(),
                   [&](std::size_t a, std::size_t b) {
                     return relativeError(records[a].error(), limit) >
                            relativeError(records[b].error(), limit);
                   });
  places.resize(std::min(count, places.size()));
  return places;
}
}  // namespace psmks
