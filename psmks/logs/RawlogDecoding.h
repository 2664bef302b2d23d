/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace psmks
{
/** What the process that decodes a rawlog sends. */
enum class RawlogMessageKind : std::uint32_t
{
  Entry,   //!< the payload is an object as MRPT writes it
  Damage,  //!< the last message; the payload is the reason, as a part of a sentence
  End      //!< the last message: the log was read to its end
};

/** The head of a message. It is followed by its payload. */
struct RawlogMessage
{
  RawlogMessageKind kind = RawlogMessageKind::End;
  std::uint32_t payload_bytes = 0;
  double share = 0;  //!< of the bytes of the file that has been read
};

/** Decodes a rawlog and sends its entries, in a process that was forked for it, and ends the
 * process. Memory and time for an entry are limited; exceeding them, or a crash, ends the process
 * without a last message.
 *  @param pipe end of a pipe to write to */
[[noreturn]] void decodeRawlog(const std::string& path, int pipe);

/** The most memory that decoding a file may take: eight times its size, which its numbers as
 * doubles are, but at least 48 MB, for it may be compressed, and at most 1 GB. */
std::size_t decodingMemory_bytes(std::size_t file_bytes);
}  // namespace psmks
