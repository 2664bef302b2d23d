/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/gzip/GzipLines.h>

namespace psmks
{
namespace
{
constexpr std::size_t kBlock_bytes = 1 << 16;
}

GzipLines::GzipLines(const std::string& path) : file_(path), block_(kBlock_bytes) {}

bool GzipLines::next(std::string_view& line)
{
  line_.clear();
  while (!isTooLong_ && (!unread_.empty() || refill()))
  {
    const std::size_t end = unread_.find('\n');
    const std::string_view part = unread_.substr(0, end);
    const bool isWhole = end != std::string_view::npos;
    unread_.remove_prefix(isWhole ? end + 1 : part.size());
    if (!isWhole || !line_.empty()) line_ += part;
    isTooLong_ = line_.size() > kLongest_bytes;
    if (!isWhole || isTooLong_) continue;
    line = line_.empty() ? part : std::string_view(line_);
    ++number_;
    return true;
  }
  if (line_.empty() || !error().empty()) return false;
  line = line_;
  ++number_;
  return true;
}

std::string GzipLines::error() const
{
  if (isTooLong_) return "line " + std::to_string(number_ + 1) + " is longer than 16 MB";
  return file_.error();
}

bool GzipLines::refill()
{
  if (!file_.isOpen()) return false;
  unread_ = std::string_view(block_.data(), file_.Read(block_.data(), block_.size()));
  return !unread_.empty();
}
}  // namespace psmks
