/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/support/ReplacedFile.h>
#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <utility>

namespace psmks
{
namespace
{
namespace fs = std::filesystem;

/** The file that a path names, through symbolic links. */
fs::path targetOf(const std::string& path)
{
  std::error_code error;
  const fs::path target = fs::weakly_canonical(path, error);
  return error || target.empty() ? fs::path(path) : target;
}

bool isSpecial(const fs::path& path)
{
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  return fs::exists(status) && !fs::is_regular_file(status);
}

/** Waits until the bytes of a file are on the disk; some disks tell only then that they are full.
 */
bool isOnDisk(const std::string& path)
{
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return false;
  const bool done = fsync(file) == 0 || errno == EINVAL || errno == ENOSYS;  // or knows no fsync
  close(file);
  return done;
}
}  // namespace

ReplacedFile::ReplacedFile(const std::string& path) : place_(targetOf(path).string())
{
  const fs::path place(place_);
  const std::string name = ".psmks-" + std::to_string(getpid()) + '-' + place.filename().string();
  beside_ = isSpecial(place) ? place_ : (place.parent_path() / name).string();
}

ReplacedFile::~ReplacedFile()
{
  if (beside_.empty() || beside_ == place_) return;
  std::error_code ignored;
  fs::remove(beside_, ignored);
}

ReplacedFile::ReplacedFile(ReplacedFile&& other) noexcept
    : place_(std::move(other.place_)), beside_(std::exchange(other.beside_, ""))
{
}

bool ReplacedFile::moveIntoPlace()
{
  if (beside_ == place_) return true;
  std::error_code error;
  if (!isOnDisk(beside_)) return false;
  fs::rename(beside_, place_, error);
  return !error;
}

bool replaceFile(const std::string& path, const std::function<bool(const std::string&)>& write)
{
  ReplacedFile file(path);
  try
  {
    return write(file.beside()) && file.moveIntoPlace();
  }
  catch (const std::exception&)
  {
    return false;
  }
}

bool isCreatable(const std::string& path)
{
  const fs::path target = targetOf(path);
  std::error_code ignored;
  if (fs::is_directory(target, ignored)) return false;
  if (isSpecial(target)) return access(target.c_str(), W_OK) == 0;
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  const bool isReplaceable = !fs::exists(target, ignored) || access(target.c_str(), W_OK) == 0;
  return isReplaceable && fs::is_directory(folder, ignored) && access(folder.c_str(), W_OK) == 0;
}
}  // namespace psmks
