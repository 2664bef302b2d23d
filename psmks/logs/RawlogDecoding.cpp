/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <mrpt/serialization/CArchive.h>
#include <mrpt/serialization/CSerializable.h>
#include <psmks/gzip/GzipInput.h>
#include <psmks/logs/GuardedProcess.h>
#include <psmks/logs/RawlogDecoding.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <regex>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace psmks
{
namespace
{
/** Memory that MRPT writes an object to. */
class RawlogPayload
{
 public:
  std::size_t Write(const void* bytes, std::size_t count)
  {
    const auto* first = static_cast<const char*>(bytes);
    bytes_.insert(bytes_.end(), first, first + count);
    return count;
  }
  std::size_t Read(void*, std::size_t) { throw std::logic_error("RawlogPayload: only written"); }
  std::string getStreamDescription() const { return "entry of a rawlog"; }

  void clear() { bytes_.clear(); }
  std::string_view view() const { return {bytes_.data(), bytes_.size()}; }

 private:
  std::vector<char> bytes_;
};

/** Shortens an error text of MRPT, which contains source lines and addresses, to the name of the
 * missing class. */
std::string readableReason(const std::string& mrptError)
{
  static const std::regex kUnknownClass("class '([A-Za-z0-9_:]{1,60})' which is not registered");
  std::smatch match;
  if (std::regex_search(mrptError, match, kUnknownClass))
    return "is of the unknown class '" + match[1].str() + "'";
  return "cannot be decoded";
}

/** Decodes and sends one entry after the other. */
class RawlogDecoding
{
 public:
  RawlogDecoding(const std::string& path, int pipe) : file_(path), pipe_(pipe) {}

  void run()
  {
    while (!file_.isAtEnd())
    {
      limitWorkingTime();
      const std::string problem = sendEntry();
      if (!problem.empty()) return send(RawlogMessageKind::Damage, problem);
    }
    if (file_.error().empty()) return send(RawlogMessageKind::End, "");
    send(RawlogMessageKind::Damage, file_.error());
  }

 private:
  /** @return what is wrong with the entry; empty after a good one */
  std::string sendEntry()
  {
    try
    {
      const auto entry = mrpt::serialization::archiveFrom(file_).ReadObject();
      if (!entry) return "";
      payload_.clear();
      mrpt::serialization::archiveFrom(payload_).WriteObject(entry.get());
      send(RawlogMessageKind::Entry, payload_.view());
      ++sent_;
      return "";
    }
    catch (const std::exception& error)
    {
      const std::string entry = "entry " + std::to_string(sent_ + 1);
      if (!file_.error().empty()) return file_.error();
      return file_.isAtEnd() ? "the file ends within " + entry
                             : entry + " " + readableReason(error.what());
    }
  }

  void send(RawlogMessageKind kind, std::string_view payload)
  {
    const RawlogMessage head{kind, static_cast<std::uint32_t>(payload.size()), file_.shareRead()};
    message_.resize(sizeof(head) + payload.size());
    std::memcpy(message_.data(), &head, sizeof(head));
    std::copy(payload.begin(), payload.end(),
              message_.begin() + static_cast<std::ptrdiff_t>(sizeof(head)));
    for (std::size_t sent = 0; sent < message_.size();)
    {
      const ssize_t bytes = ::write(pipe_, message_.data() + sent, message_.size() - sent);
      if (bytes < 0 && errno != EINTR) _exit(EXIT_FAILURE);
      if (bytes > 0) sent += static_cast<std::size_t>(bytes);
    }
  }

  GzipInput file_;
  int pipe_;
  RawlogPayload payload_;
  std::vector<char> message_;
  int sent_ = 0;
};
}  // namespace

std::size_t decodingMemory_bytes(std::size_t file_bytes)
{
  constexpr std::size_t kMegabyte = 1 << 20, kLeast = 48 * kMegabyte, kMost = 1024 * kMegabyte;
  constexpr std::size_t kTimes = 8;
  return file_bytes > kMost / kTimes ? kMost : std::max(kLeast, kTimes * file_bytes);
}

void decodeRawlog(const std::string& path, int pipe)
{
  std::error_code ignored;
  guardProcess(decodingMemory_bytes(std::filesystem::file_size(path, ignored)));
  try
  {
    RawlogDecoding(path, pipe).run();
  }
  catch (...)  // out of memory: the parent sees that the last message is missing
  {
    _exit(EXIT_FAILURE);
  }
  _exit(EXIT_SUCCESS);
}
}  // namespace psmks
