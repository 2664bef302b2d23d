/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/gzip/GzipOutput.h>
#include <zlib.h>

#include <filesystem>

namespace psmks
{
namespace
{
gzFile gz(void* file) { return static_cast<gzFile>(file); }
}  // namespace

bool GzipOutput::open(const std::string& path)
{
  const bool zipped = std::filesystem::path(path).extension() == ".gz";
  file_.reset(gzopen(path.c_str(), zipped ? "wb" : "wbT"));
  return file_ != nullptr;
}

bool GzipOutput::write(std::string_view text)
{
  const auto bytes = static_cast<unsigned>(text.size());
  return gzwrite(gz(file_.get()), text.data(), bytes) == static_cast<int>(bytes);
}

bool GzipOutput::close() { return gzclose(gz(file_.release())) == Z_OK; }

void GzipOutput::Close::operator()(void* file) const { gzclose(gz(file)); }
}  // namespace psmks
