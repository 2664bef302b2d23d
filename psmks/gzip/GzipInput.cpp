/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/gzip/GzipInput.h>
#include <zlib.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <stdexcept>

namespace psmks
{
namespace
{
gzFile gz(void* file) { return static_cast<gzFile>(file); }
}  // namespace

GzipInput::GzipInput(const std::string& path) : path_(path)
{
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return;
  file_ = gzopen(path.c_str(), "rb");
  size_bytes_ = static_cast<double>(std::filesystem::file_size(path, ignored));
}

GzipInput::~GzipInput()
{
  if (file_) gzclose(gz(file_));
}

bool GzipInput::isAtEnd()
{
  const int byte = gzgetc(gz(file_));
  if (byte < 0) return true;
  gzungetc(byte, gz(file_));
  return false;
}

std::string GzipInput::error() const
{
  int code = Z_OK;
  gzerror(gz(file_), &code);
  switch (code)
  {
    case Z_OK:
    case Z_STREAM_END:
      return "";
    case Z_BUF_ERROR:
      return "the compressed data is cut off";
    case Z_DATA_ERROR:
      return "the compressed data is damaged";
    default:
      return "the file cannot be read";
  }
}

double GzipInput::shareRead() const
{
  if (!file_ || size_bytes_ <= 0) return 1;
  return std::min(1.0, static_cast<double>(gzoffset(gz(file_))) / size_bytes_);
}

std::size_t GzipInput::Read(void* buffer, std::size_t bytes)
{
  if (bytes > std::numeric_limits<unsigned>::max()) return 0;
  const int read = gzread(gz(file_), buffer, static_cast<unsigned>(bytes));
  return read > 0 ? static_cast<std::size_t>(read) : 0;
}

std::size_t GzipInput::Write(const void*, std::size_t)
{
  throw std::logic_error("GzipInput: " + path_ + " is open for reading");
}
}  // namespace psmks
