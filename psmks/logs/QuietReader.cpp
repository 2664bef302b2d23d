/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/logs/QuietReader.h>

#include <iomanip>
#include <sstream>
#include <utility>

namespace psmks
{
QuietReader::QuietReader(std::unique_ptr<LogReader> log, std::vector<RangeBand> rings)
    : log_(std::move(log)), rings_(std::move(rings))
{
  for (RangeBand& ring : rings_) ring.readings = 0;
}

bool QuietReader::next(LaserFrame& frame)
{
  if (!log_->next(frame)) return false;
  auto& scan = *frame.scan;
  for (std::size_t ray = 0; ray < scan.getScanSize(); ++ray)
  {
    if (!scan.getScanRangeValidity(ray)) continue;
    ++readings_;
    for (RangeBand& ring : rings_)
    {
      if (!ring.contains(static_cast<double>(scan.getScanRange(ray)))) continue;
      scan.setScanRangeValidity(ray, false);
      ++ring.readings;
      break;
    }
  }
  return true;
}

std::vector<std::string> QuietReader::remarks() const
{
  std::vector<std::string> remarks = log_->remarks();
  for (const RangeBand& ring : rings_)
  {
    std::ostringstream text;
    text << std::fixed << std::setprecision(2) << "took " << ring.readings << " of " << readings_
         << " readings, from " << ring.from_m << " to " << ring.to_m
         << " m, for no return: they stay the same while the scanner moves";
    remarks.push_back(text.str());
  }
  return remarks;
}
}  // namespace psmks
