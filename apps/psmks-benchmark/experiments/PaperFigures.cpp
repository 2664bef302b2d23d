/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/experiments/PaperFigures.h>

namespace psmks
{
std::optional<PaperFigures> paperFigures(const std::string& site)
{
  if (site == "room")
    return PaperFigures{'a', 498.8, 312.0, 10.6, 1.57, 10.71, 0.104, 0.35, 0.937, 5.12};
  if (site == "clutter")
    return PaperFigures{'b', 558.6, 274.3, 13.1, 1.49, 11.36, 0.100, 0.98, 0.765, 5.59};
  if (site == "curved")
    return PaperFigures{'c', 568.0, 202.2, 14.8, 1.94, 13.86, 0.240, 2.64, 0.782, 6.56};
  if (site == "corridors")
    return PaperFigures{'d', 388.8, 187.4, 7.1, 1.65, 12.61, 0.578, 1.50, 2.151, 3.90};
  return std::nullopt;
}
}  // namespace psmks
