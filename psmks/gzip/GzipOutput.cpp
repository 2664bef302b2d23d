/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/gzip/GzipOutput.h>
#include <zlib.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

namespace psmks
{
namespace
{
gzFile gz(void* file) { return static_cast<gzFile>(file); }
}  // namespace

bool GzipOutput::open(const std::string& path, GzipUse use)
{
  const bool zipped = use == GzipUse::Always || std::filesystem::path(path).extension() == ".gz";
  path_ = path;
  failed_ = false;
  // MRPT gzips its files at the fastest level.
  const char* mode = use == GzipUse::Always ? "wb1" : zipped ? "wb" : "wbT";
  file_.reset(gzopen(path.c_str(), mode));
  return file_ != nullptr;
}

bool GzipOutput::write(std::string_view text)
{
  constexpr std::size_t kMostAtOnce = 1U << 30;  // zlib counts bytes as int
  while (!text.empty() && !failed_)
  {
    const auto bytes = static_cast<unsigned>(std::min(text.size(), kMostAtOnce));
    failed_ = gzwrite(gz(file_.get()), text.data(), bytes) != static_cast<int>(bytes);
    text.remove_prefix(bytes);
  }
  return !failed_;
}

bool GzipOutput::close()
{
  if (gzclose(gz(file_.release())) != Z_OK) failed_ = true;
  return !failed_;
}

std::size_t GzipOutput::Write(const void* buffer, std::size_t bytes)
{
  write({static_cast<const char*>(buffer), bytes});
  return bytes;
}

std::size_t GzipOutput::Read(void*, std::size_t)
{
  throw std::logic_error("GzipOutput: " + path_ + " is open for writing");
}

void GzipOutput::Close::operator()(void* file) const { gzclose(gz(file)); }
}  // namespace psmks
