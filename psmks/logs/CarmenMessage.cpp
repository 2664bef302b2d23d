/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/geometry/Angle.h>
#include <psmks/logs/CarmenMessage.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace psmks
{
namespace
{
/** Reads the words of a line one after the other. */
class Words
{
 public:
  explicit Words(std::string_view line) : rest_(line) { skipBlanks(); }

  bool isAtEnd() const { return rest_.empty(); }

  /** The next word; empty after the last one. */
  std::string_view next()
  {
    const std::string_view word = rest_.substr(0, rest_.find_first_of(kBlanks));
    rest_.remove_prefix(word.size());
    skipBlanks();
    return word;
  }

  std::size_t count() const
  {
    Words copy = *this;
    std::size_t count = 0;
    for (; !copy.isAtEnd(); copy.next()) ++count;
    return count;
  }

 private:
  void skipBlanks()
  {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(kBlanks), rest_.size()));
  }

  static constexpr std::string_view kBlanks = " \t\r";
  std::string_view rest_;
};

/** Numbers of words in the parts of a message after its readings. */
constexpr std::size_t kStampWords = 3, kPoseWords = 3, kRobotLaserStateWords = 5;
constexpr std::size_t kAfterRobotLaser = 2 * kPoseWords + kRobotLaserStateWords + kStampWords;

/** Reads a number, which may be NaN or infinite.
 *  @return false if the word is not a number */
template <class Number>
bool read(Words& words, Number& value)
{
  const std::string_view word = words.next();
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size() && !word.empty();
}

bool readFinite(Words& words, double& value) { return read(words, value) && std::isfinite(value); }

bool skipNumbers(Words& words, std::size_t count)
{
  double ignored = 0;
  for (; count > 0; --count)
    if (!read(words, ignored)) return false;
  return true;
}

bool readPose(Words& words, Pose2& pose)
{
  if (!readFinite(words, pose.x_m) || !readFinite(words, pose.y_m) ||
      !readFinite(words, pose.phi_rad))
    return false;
  pose.phi_rad = wrapAngle(pose.phi_rad);
  return true;
}

bool readRanges(Words& words, std::vector<double>& ranges_m)
{
  ranges_m.clear();
  int count = 0;
  if (!read(words, count) || count < 1) return false;
  for (double range_m = 0; count > 0; --count)
  {
    if (!read(words, range_m)) return false;
    ranges_m.push_back(range_m);
  }
  return true;
}

/** Reads the end of a message. Some programs write something else than a number for the stamp of
 * the logger. */
bool readStamps(Words& words, CarmenMessage& message)
{
  if (!readFinite(words, message.ipcStamp_s)) return false;
  const std::string_view host = words.next();
  if (host.empty() || words.isAtEnd()) return false;
  if (!readFinite(words, message.loggerStamp_s)) message.loggerStamp_s = 0;
  return words.isAtEnd();
}

std::optional<double> positive(double value)
{
  return value > 0 ? std::make_optional(value) : std::nullopt;
}

bool readScanner(Words& words, CarmenScanner& scanner)
{
  double type, first_rad, fieldOfView_rad, increment_rad, maxRange_m, accuracy_m, remissionMode;
  for (double* value : {&type, &first_rad, &fieldOfView_rad, &increment_rad, &maxRange_m,
                        &accuracy_m, &remissionMode})
    if (!readFinite(words, *value)) return false;
  scanner = {first_rad,
             positive(fieldOfView_rad),
             positive(increment_rad),
             positive(maxRange_m),
             positive(accuracy_m),
             static_cast<int>(type)};
  return true;
}

/** Skips the list of remissions. Old logs do not have it, which shows in the number of words. */
bool skipRemissions(Words& words)
{
  if (words.count() == kAfterRobotLaser) return true;
  std::size_t remissions = 0;
  return read(words, remissions) && words.count() == remissions + kAfterRobotLaser &&
         skipNumbers(words, remissions);
}

bool parseLaser(Words& words, CarmenMessage& message)
{
  return readRanges(words, message.ranges_m) && readPose(words, message.T_odom_laser) &&
         readPose(words, message.T_odom_robot) && readStamps(words, message);
}

bool parseRobotLaser(Words& words, CarmenMessage& message)
{
  return readScanner(words, message.scanner.emplace()) && readRanges(words, message.ranges_m) &&
         skipRemissions(words) && readPose(words, message.T_odom_laser) &&
         readPose(words, message.T_odom_robot) && skipNumbers(words, kRobotLaserStateWords) &&
         readStamps(words, message);
}

bool parseOdometry(Words& words, CarmenMessage& message)
{
  constexpr std::size_t kVelocityWords = 3;
  return readPose(words, message.T_odom_robot) && skipNumbers(words, kVelocityWords) &&
         readStamps(words, message);
}

CarmenKind kindIf(bool whole, CarmenKind kind) { return whole ? kind : CarmenKind::Malformed; }
}  // namespace

void parseCarmenMessage(std::string_view line, CarmenMessage& message)
{
  Words words(line);
  message.name = words.next();
  message.scanner.reset();
  message.kind = CarmenKind::Other;
  if (message.name == "FLASER" || message.name == "RLASER")
    message.kind = kindIf(parseLaser(words, message), CarmenKind::Scan);
  else if (message.name == "ROBOTLASER1" || message.name == "ROBOTLASER2")
    message.kind = kindIf(parseRobotLaser(words, message), CarmenKind::Scan);
  else if (message.name == "ODOM")
    message.kind = kindIf(parseOdometry(words, message), CarmenKind::Odometry);
  else if (message.name == "PARAM")
  {
    message.name = words.next();
    if (readFinite(words, message.value)) message.kind = CarmenKind::Parameter;
  }
}
}  // namespace psmks
