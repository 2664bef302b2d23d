/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <functional>
#include <string>

namespace psmks
{
/** A file that is written beside its place and moved there when it is whole, so that a program that
 * is killed, or a disk that is full, leaves no part of a file, and keeps the file that was there.
 *
 *     folder/.psmks-4711-map.png  --moveIntoPlace()-->  folder/map.png
 *
 * A symbolic link stays one: the file that it names is replaced. What is no regular file, such as
 * /dev/stdout or a pipe, is written in place. */
class ReplacedFile
{
 public:
  /** Chooses the name to write to; creates nothing. */
  explicit ReplacedFile(const std::string& path);

  /** Removes what was not moved. */
  ~ReplacedFile();
  ReplacedFile(ReplacedFile&& other) noexcept;
  ReplacedFile& operator=(ReplacedFile&&) = delete;

  /** The file to write. Its name ends as the path does. */
  const std::string& beside() const { return beside_; }

  /** Moves the file that was written and closed to its place, once its bytes are on the disk.
   *  @return false if it cannot be */
  bool moveIntoPlace();

 private:
  std::string place_, beside_;
};

/** Writes a file beside its place and moves it there.
 *  @param write called with the name of the file to write; returns whether all of it was written
 *  @return false if it could not be written or moved, or `write` threw: the place is then as before
 */
bool replaceFile(const std::string& path, const std::function<bool(const std::string&)>& write);

/** Whether a file can be created or replaced at a path: the folder is there and may be written to.
 *  Creates nothing. */
bool isCreatable(const std::string& path);
}  // namespace psmks
