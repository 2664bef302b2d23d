/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/base/ShortText.h>
#include <psmks/eval/PairsFile.h>
#include <psmks/gzip/GzipLines.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

namespace psmks
{
namespace
{
constexpr const char* kMagic = "PSMPAIRS";
constexpr int kVersion = 1;

/** Appends the shortest text that reads back as the same number. */
void appendNumber(std::string& text, double value)
{
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  text += ' ';
  text.append(buffer.data(), end.ptr);
}

void appendPose(std::string& text, const Pose2& pose)
{
  for (const double value : {pose.x_m, pose.y_m, pose.phi_rad}) appendNumber(text, value);
}

std::string rangesText(const Scan& scan)
{
  std::string text;
  for (const double range_m : scan.range_m) appendNumber(text, range_m);
  return text.substr(1) + '\n';
}
}  // namespace

/** Reads the lines of the file that are neither blank nor comments, and the fields of the present
 * one. */
class PairsReader::Lines
{
 public:
  explicit Lines(const std::string& path) : path_(path), lines_(path)
  {
    if (!lines_.isOpen()) throw PairsFileError(path + ": cannot be opened");
  }

  /** Refuses the line read last. */
  [[noreturn]] void fail(const std::string& reason) const { fail(lines_.number(), reason); }

  /** Moves to the next line.
   *  @throws PairsFileError if there is none */
  void next(const std::string& wanted)
  {
    do
    {
      if (!lines_.next(line_)) failAtEnd(wanted);
      rest_ = line_;
    } while (rest_.find_first_not_of(kBlanks) == std::string_view::npos || rest_.front() == '#');
  }

  /** Moves to the next line.
   *  @throws PairsFileError if there is none or it does not begin with the keyword */
  void next(const char* keyword, const std::string& wanted)
  {
    next(wanted);
    if (field() != keyword)
      fail("found where " + wanted + " should stand: '" + shortText(line_) + "'");
  }

  double number(const char* what) { return parse<double>(what); }
  int integer(const char* what) { return parse<int>(what); }

  Pose2 pose(const char* what)
  {
    const double x_m = number(what), y_m = number(what);
    return {x_m, y_m, number(what)};
  }

  void end()
  {
    if (!field().empty()) fail("more numbers than expected");
  }

 private:
  [[noreturn]] void fail(int line, const std::string& reason) const
  {
    throw PairsFileError(path_ + ", line " + std::to_string(line) + ": " + reason);
  }

  [[noreturn]] void failAtEnd(const std::string& wanted) const
  {
    const std::string damage = lines_.error();
    fail(lines_.number() + 1,
         damage.empty() ? "the file ends where " + wanted + " should follow" : damage);
  }

  std::string_view field()
  {
    const auto first = rest_.find_first_not_of(kBlanks);
    if (first == std::string_view::npos) return {};
    const auto last = std::min(rest_.find_first_of(kBlanks, first), rest_.size());
    const std::string_view found = rest_.substr(first, last - first);
    rest_.remove_prefix(last);
    return found;
  }

  template <class Number>
  Number parse(const char* what)
  {
    const std::string_view text = field();
    if (text.empty()) fail(std::string(what) + " is missing");
    Number value{};
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    if (result.ec != std::errc() || result.ptr != text.data() + text.size())
      fail(std::string(what) + ": '" + shortText(text) + "' is not a number");
    return value;
  }

  static constexpr std::string_view kBlanks{" \t\r\0", 4};

  std::string path_;
  GzipLines lines_;
  std::string_view line_;  //!< the present line
  std::string_view rest_;  //!< the part of it that was not read yet
};

PairsReader::PairsReader(const std::string& path) : lines_(std::make_unique<Lines>(path))
{
  readHeader();
}

PairsReader::~PairsReader() = default;

void PairsReader::readHeader()
{
  lines_->next(kMagic, "'PSMPAIRS 1', the mark of a scan pairs file,");
  if (lines_->integer("the format's version") != kVersion) lines_->fail("unknown format version");

  lines_->next("laser", "'laser <rays> <first bearing> <increment> <max range>'");
  const int rays = lines_->integer("the number of rays");
  const double first_rad = lines_->number("the first bearing");
  const double increment_rad = lines_->number("the increment");
  header_.maxRange_m = lines_->number("the maximum range");
  lines_->end();
  if (rays < 1) lines_->fail("a scanner without rays");
  try
  {
    header_.grid = BeamGrid(first_rad, increment_rad, rays);
  }
  catch (const std::invalid_argument& error)
  {
    lines_->fail(error.what());
  }

  lines_->next("npairs", "'npairs <N>'");
  header_.pairs = lines_->integer("the number of pairs");
  lines_->end();
}

bool PairsReader::read(ScanPair& pair)
{
  if (pairsRead_ == header_.pairs) return false;
  lines_->next("pair",
               "pair " + std::to_string(pairsRead_ + 1) + " of " + std::to_string(header_.pairs));
  pair.id = lines_->integer("the pair's id");
  pair.T_ref_cur_true = lines_->pose("the true pose");
  pair.T_ref_cur_odometry = lines_->pose("the odometry's pose");
  lines_->end();
  readRanges(pair.reference);
  readRanges(pair.current);
  ++pairsRead_;
  return true;
}

void PairsReader::readRanges(Scan& scan)
{
  lines_->next("the ranges of a scan");
  scan = Scan();
  scan.grid = header_.grid;
  scan.maxRange_m = header_.maxRange_m;
  scan.range_m.resize(static_cast<std::size_t>(header_.grid.count()));
  for (double& range_m : scan.range_m) range_m = lines_->number("a range");
  lines_->end();
}

PairsWriter::PairsWriter(const std::string& path, const PairsHeader& header) : path_(path)
{
  if (!file_.open(path)) throw PairsFileError(path + ": cannot be created");
  std::string text = std::string(kMagic) + ' ' + std::to_string(kVersion) + "\nlaser " +
                     std::to_string(header.grid.count());
  appendNumber(text, header.grid.firstBearing_rad());
  appendNumber(text, header.grid.increment_rad());
  appendNumber(text, header.maxRange_m);
  put(text + "\nnpairs " + std::to_string(header.pairs) + '\n');
}

void PairsWriter::write(const ScanPair& pair)
{
  std::string text = "pair " + std::to_string(pair.id);
  appendPose(text, pair.T_ref_cur_true);
  appendPose(text, pair.T_ref_cur_odometry);
  put(text + '\n' + rangesText(pair.reference) + rangesText(pair.current));
}

void PairsWriter::close()
{
  if (!file_.close()) throw PairsFileError(path_ + ": cannot be written");
}

void PairsWriter::put(const std::string& text)
{
  if (!file_.write(text)) throw PairsFileError(path_ + ": cannot be written");
}
}  // namespace psmks
