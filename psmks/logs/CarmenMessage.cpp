/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/geometry/Angle.h>
#include <psmks/geometry/BeamGrid.h>
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

  static constexpr std::string_view kBlanks{" \t\r\0", 4};
  std::string_view rest_;
};

/** Numbers of words in the parts of a message after its readings. */
constexpr std::size_t kStampWords = 3, kPoseWords = 3, kRobotLaserStateWords = 5;
constexpr std::size_t kAfterRobotLaser = 2 * kPoseWords + kRobotLaserStateWords + kStampWords;

/** The mark that some editors put before a text. Definition: Unicode. */
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/** Largest coordinate of a pose. Definition: half way round the Earth. */
constexpr double kFarthest_m = 2e7;

/** Largest heading of a pose. Definition: a turn a second for months; beyond it a double keeps no
 * digits for the heading. */
constexpr double kMostTurned_rad = 1e8;

/** Largest number of a kind of scanner. Definition: CARMEN numbers ten of them. */
constexpr double kLargestType = 1e6;

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
  if (!read(words, pose.x_m) || !read(words, pose.y_m) || !read(words, pose.phi_rad)) return false;
  const bool isPlace = std::abs(pose.x_m) < kFarthest_m && std::abs(pose.y_m) < kFarthest_m &&
                       std::abs(pose.phi_rad) < kMostTurned_rad;
  if (!isPlace) return false;
  pose.phi_rad = wrapAngle(pose.phi_rad);
  return true;
}

bool readRanges(Words& words, std::vector<double>& ranges_m)
{
  constexpr int kMostRays = static_cast<int>(2 * kPi / BeamGrid::kLeastIncrement_rad);
  ranges_m.clear();
  int count = 0;
  if (!read(words, count) || count < 1 || count > kMostRays) return false;
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
             std::nullopt};
  if (std::abs(type) < kLargestType) scanner.type = static_cast<int>(type);
  return true;
}

/** Skips the list of remissions. Old logs do not have it, which shows in the number of words.
 *  @param after number of words behind the list */
bool skipRemissions(Words& words, std::size_t after)
{
  const std::size_t left = words.count();
  if (left == after) return true;
  std::size_t remissions = 0;
  return read(words, remissions) && remissions < left && left == 1 + remissions + after &&
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
         skipRemissions(words, kAfterRobotLaser) && readPose(words, message.T_odom_laser) &&
         readPose(words, message.T_odom_robot) && skipNumbers(words, kRobotLaserStateWords) &&
         readStamps(words, message);
}

bool parseRawLaser(Words& words, CarmenMessage& message)
{
  message.T_odom_laser = message.T_odom_robot = {};
  return readScanner(words, message.scanner.emplace()) && readRanges(words, message.ranges_m) &&
         skipRemissions(words, kStampWords) && readStamps(words, message);
}

bool parseOdometry(Words& words, CarmenMessage& message)
{
  constexpr std::size_t kVelocityWords = 3;
  return readPose(words, message.T_odom_robot) && skipNumbers(words, kVelocityWords) &&
         readStamps(words, message);
}

CarmenKind kindIf(bool whole, CarmenKind kind) { return whole ? kind : CarmenKind::Malformed; }
}  // namespace

bool isRawLaser(std::string_view messageName)
{
  constexpr std::string_view kRaw = "RAWLASER";
  return messageName.size() == kRaw.size() + 1 && messageName.substr(0, kRaw.size()) == kRaw &&
         messageName.back() >= '1' && messageName.back() <= '5';
}

void parseCarmenMessage(std::string_view line, CarmenMessage& message)
{
  if (line.substr(0, kByteOrderMark.size()) == kByteOrderMark)
    line.remove_prefix(kByteOrderMark.size());
  Words words(line);
  message.name = words.next();
  message.scanner.reset();
  message.kind = CarmenKind::Other;
  if (message.name == "FLASER" || message.name == "RLASER")
    message.kind = kindIf(parseLaser(words, message), CarmenKind::Scan);
  else if (message.name == "ROBOTLASER1" || message.name == "ROBOTLASER2")
    message.kind = kindIf(parseRobotLaser(words, message), CarmenKind::Scan);
  else if (isRawLaser(message.name))
    message.kind = kindIf(parseRawLaser(words, message), CarmenKind::Scan);
  else if (message.name == "ODOM")
    message.kind = kindIf(parseOdometry(words, message), CarmenKind::Odometry);
  else if (message.name == "PARAM")
  {
    message.name = words.next();
    if (readFinite(words, message.value)) message.kind = CarmenKind::Parameter;
  }
}
}  // namespace psmks
