/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/mrpt/SurfaceField.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace psmks
{
std::int64_t SurfaceField::Cells::keyOf(Index index)
{
  return static_cast<std::int64_t>(
      (static_cast<std::uint64_t>(static_cast<std::uint32_t>(index.x)) << 32) |
      static_cast<std::uint32_t>(index.y));
}

/** Where a key is, or the free slot where it belongs. */
std::size_t SurfaceField::Cells::slotOf(std::int64_t key) const
{
  constexpr std::uint64_t kGolden = 0x9E3779B97F4A7C15ULL;  // Fibonacci hashing (Knuth, 6.4)
  constexpr int kHighBits = 40;  // the product mixes both halves of the key in its upper bits
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = ((static_cast<std::uint64_t>(key) * kGolden) >> kHighBits) & mask;
  while (slots_[slot].key != kFree && slots_[slot].key != key) slot = (slot + 1) & mask;
  return slot;
}

void SurfaceField::Cells::clear()
{
  for (const std::size_t slot : used_) slots_[slot] = Cell();
  used_.clear();
}

SurfaceField::Cell& SurfaceField::Cells::at(Index index)
{
  if (2 * used_.size() >= slots_.size()) grow();
  const std::int64_t key = keyOf(index);
  const std::size_t slot = slotOf(key);
  if (slots_[slot].key == kFree)
  {
    slots_[slot].key = key;
    used_.push_back(slot);
  }
  return slots_[slot];
}

const SurfaceField::Cell* SurfaceField::Cells::find(Index index) const
{
  const Cell& cell = slots_[slotOf(keyOf(index))];
  return cell.key == kFree ? nullptr : &cell;
}

void SurfaceField::Cells::grow()
{
  constexpr std::size_t kFirst = 1024, kFactor = 4;
  std::vector<Cell> old(std::max(kFirst, kFactor * slots_.size()));
  old.swap(slots_);
  for (std::size_t& slot : used_)
  {
    const Cell& cell = old[slot];
    slot = slotOf(cell.key);
    slots_[slot] = cell;
  }
}

void SurfaceField::clear()
{
  for (Cells& cells : levels_) cells.clear();
  surfaces_.clear();
}

SurfaceField::Index SurfaceField::indexOf(const Eigen::Vector2d& place_m, int level)
{
  constexpr double kMost = 1e9;  // fits into an int, as its neighbours do
  const Eigen::Array2d cell = (place_m / cell_m(level)).array().floor().max(-kMost).min(kMost);
  return {static_cast<int>(cell.x()), static_cast<int>(cell.y())};
}

void SurfaceField::add(const Eigen::Vector2d& p)
{
  for (int level = 0; level < kLevels; ++level)
  {
    Sums& sums = levels_[static_cast<std::size_t>(level)].at(indexOf(p, level)).sums;
    ++sums.n;
    sums.x += p.x(), sums.y += p.y();
    sums.xx += p.x() * p.x(), sums.xy += p.x() * p.y(), sums.yy += p.y() * p.y();
  }
}

const Surface* SurfaceField::at(const Eigen::Vector2d& place_m, int level)
{
  const Index index = indexOf(place_m, level);
  std::int32_t& surface = levels_[static_cast<std::size_t>(level)].at(index).surface;
  if (surface == kUnknown) surface = fit(windowAbout(index, level), level);
  return surface == kNone ? nullptr : &surfaces_[static_cast<std::size_t>(surface)];
}

const Surface* SurfaceField::finestAt(const Eigen::Vector2d& place_m, int finest, int coarsest)
{
  for (int level = finest; level <= coarsest; ++level)
    if (const Surface* surface = at(place_m, level)) return surface;
  return nullptr;
}

SurfaceField::Sums SurfaceField::windowAbout(Index index, int level) const
{
  Sums window;
  for (int dx = -1; dx <= 1; ++dx)
    for (int dy = -1; dy <= 1; ++dy)
    {
      const Cell* cell =
          levels_[static_cast<std::size_t>(level)].find({index.x + dx, index.y + dy});
      if (!cell) continue;
      const Sums& sums = cell->sums;
      window.n += sums.n;
      window.x += sums.x, window.y += sums.y;
      window.xx += sums.xx, window.xy += sums.xy, window.yy += sums.yy;
    }
  return window;
}

std::int32_t SurfaceField::fit(const Sums& window, int level)
{
  constexpr int kFewest = 3;  // that show a direction and a spread
  if (window.n < kFewest) return kNone;
  const double n = window.n, x = window.x / n, y = window.y / n;
  const double xx = window.xx / n - x * x, xy = window.xy / n - x * y, yy = window.yy / n - y * y;
  // The eigenvalues of a symmetric 2x2 matrix, and the direction of the larger one.
  const double mean = (xx + yy) / 2, half = std::hypot((xx - yy) / 2, xy);
  const double along_rad = std::atan2(2 * xy, xx - yy) / 2;

  Surface surface;
  surface.mean_m = {x, y};
  surface.normal = {-std::sin(along_rad), std::cos(along_rad)};
  surface.acrossVariance_m2 = std::max(0.0, mean - half);
  surface.alongVariance_m2 = std::max(0.0, mean + half);
  surface.points = window.n;
  surface.window_m = 3 * cell_m(level);
  surface.isIsolated = isIsolated(surface, level);
  surfaces_.push_back(surface);
  return static_cast<std::int32_t>(surfaces_.size()) - 1;
}

bool SurfaceField::isIsolated(const Surface& surface, int level) const
{
  /** Points of the wider window for each of the narrow one: between those of a post, 1, and those
   * of the end of a wall, 2 and more. Evidence: open. */
  constexpr double kMost = 1.3;
  const int wider = level + 1;
  return wider < kLevels &&
         windowAbout(indexOf(surface.mean_m, wider), wider).n <= kMost * surface.points;
}
}  // namespace psmks
