/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <fcntl.h>
#include <mrpt/serialization/CArchive.h>
#include <psmks/gzip/GzipInput.h>
#include <psmks/logs/RawlogDecoding.h>
#include <psmks/logs/RawlogEntries.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <stdexcept>

namespace psmks
{
using mrpt::serialization::CSerializable;

namespace
{
/** Bytes that MRPT reads an object from. */
class ReceivedEntry
{
 public:
  explicit ReceivedEntry(const std::vector<char>& bytes) : bytes_(bytes) {}

  std::size_t Read(void* buffer, std::size_t count)
  {
    const std::size_t read = std::min(count, bytes_.size() - read_);
    std::memcpy(buffer, bytes_.data() + read_, read);
    read_ += read;
    return read;
  }
  std::size_t Write(const void*, std::size_t)
  {
    throw std::logic_error("ReceivedEntry: only read");
  }
  std::string getStreamDescription() const { return "entry of a rawlog"; }

 private:
  const std::vector<char>& bytes_;
  std::size_t read_ = 0;
};
}  // namespace

RawlogEntries::RawlogEntries(const std::string& path)
{
  GzipInput file(path);
  if (!file.isOpen())
    damage_ = "no such file, or not to be read";
  else if (file.isAtEnd())
    damage_ = file.error().empty() ? "the file is empty" : file.error();
  else
    start(path);
}

RawlogEntries::~RawlogEntries()
{
  if (pipe_ >= 0) close(pipe_);
  if (process_ <= 0) return;
  kill(process_, SIGKILL);
  while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) continue;
}

void RawlogEntries::start(const std::string& path)
{
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) == 0)
  {
    process_ = fork();
    if (process_ == 0) decodeRawlog(path, ends[1]);
    close(ends[1]);
    pipe_ = ends[0];
  }
  if (process_ < 0) damage_ = "no process can be started to decode it";
}

CSerializable::Ptr RawlogEntries::next()
{
  if (!damage_.empty() || pipe_ < 0) return nullptr;
  RawlogMessage head;
  if (!receive(&head, sizeof(head)))
  {
    reportEndOfProcess();
    return nullptr;
  }
  share_ = head.share;
  payload_.resize(head.payload_bytes);
  const bool isWhole = receive(payload_.data(), payload_.size());
  if (!isWhole)
    reportEndOfProcess();
  else if (head.kind == RawlogMessageKind::Damage)
    reportDamage({payload_.begin(), payload_.end()});
  else if (head.kind == RawlogMessageKind::Entry)
  {
    ReceivedEntry entry(payload_);
    ++read_;
    return mrpt::serialization::archiveFrom(entry).ReadObject();
  }
  close(pipe_);
  pipe_ = -1;
  return nullptr;
}

/** Reads so many bytes from the pipe.
 *  @return false if it ends before */
bool RawlogEntries::receive(void* buffer, std::size_t bytes)
{
  auto* to = static_cast<char*>(buffer);
  while (bytes > 0)
  {
    const ssize_t got = ::read(pipe_, to, bytes);
    if (got == 0 || (got < 0 && errno != EINTR)) return false;
    if (got < 0) continue;
    to += got;
    bytes -= static_cast<std::size_t>(got);
  }
  return true;
}

void RawlogEntries::reportDamage(const std::string& reason)
{
  damage_ = read_ > 0 ? "read " + std::to_string(read_) + " entries, then: " + reason
                      : "not an MRPT rawlog: " + reason;
}

void RawlogEntries::reportEndOfProcess()
{
  reportDamage("entry " + std::to_string(read_ + 1) + " cannot be decoded");
}
}  // namespace psmks
