/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/eval/PairsFile.h>
#include <zlib.h>

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

/** Significant digits of written numbers: exact for poses and ranges that were read from text. */
constexpr int kDigits = 12;

void appendNumber(std::string& text, double value)
{
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                 std::chars_format::general, kDigits);
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

bool endsWith(const std::string& text, std::string_view end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}
}  // namespace

/** The lines of the file that are neither blank nor comments, and the fields of the present one. */
class PairsReader::Lines
{
 public:
  explicit Lines(const std::string& path) : path_(path), file_(gzopen(path.c_str(), "rb"))
  {
    if (file_ == nullptr) throw PairsFileError(path + ": cannot be opened");
  }
  ~Lines() { gzclose(file_); }
  Lines(const Lines&) = delete;
  Lines& operator=(const Lines&) = delete;

  [[noreturn]] void fail(const std::string& reason) const
  {
    throw PairsFileError(path_ + ", line " + std::to_string(number_) + ": " + reason);
  }

  /** Moves to the next line, which has to exist. */
  void next(const std::string& wanted)
  {
    do
    {
      if (!readLine()) fail("the file ends where " + wanted + " should follow");
      rest_ = line_;
    } while (rest_.find_first_not_of(" \t\r") == std::string_view::npos || rest_.front() == '#');
  }

  /** Moves to the next line, which has to begin with this word. */
  void next(const char* keyword, const std::string& wanted)
  {
    next(wanted);
    if (field() != keyword) fail("found where " + wanted + " should stand: '" + shortLine() + "'");
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
  bool readLine()
  {
    line_.clear();
    ++number_;
    std::array<char, 4096> buffer{};
    while (gzgets(file_, buffer.data(), static_cast<int>(buffer.size())) != nullptr)
    {
      line_ += buffer.data();
      if (line_.back() != '\n') continue;
      line_.pop_back();
      return true;
    }
    int error = Z_OK;
    gzerror(file_, &error);
    if (error != Z_OK && error != Z_STREAM_END) fail("the compressed data is damaged or cut off");
    return !line_.empty();
  }

  std::string_view field()
  {
    const auto first = rest_.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) return {};
    const auto last = std::min(rest_.find_first_of(" \t\r", first), rest_.size());
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
      fail(std::string(what) + ": '" + std::string(text.substr(0, 40)) + "' is not a number");
    return value;
  }

  /** The beginning of the line, fit for a message whatever the file holds. */
  std::string shortLine() const
  {
    std::string text = line_.substr(0, 40);
    for (char& c : text)
      if (c < ' ' || c > '~') c = '?';
    return text;
  }

  std::string path_;
  gzFile file_;
  std::string line_;
  std::string_view rest_;
  int number_ = 0;
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

PairsWriter::PairsWriter(const std::string& path, const PairsHeader& header)
    : path_(path), file_(gzopen(path.c_str(), endsWith(path, ".gz") ? "wb" : "wbT"))
{
  if (!file_) throw PairsFileError(path + ": cannot be created");
  std::string text = std::string(kMagic) + ' ' + std::to_string(kVersion) + "\nlaser " +
                     std::to_string(header.grid.count());
  appendNumber(text, header.grid.firstBearing_rad());
  appendNumber(text, header.grid.increment_rad());
  appendNumber(text, header.maxRange_m);
  put(text + "\nnpairs " + std::to_string(header.pairs) + '\n');
}

PairsWriter::~PairsWriter() = default;

void PairsWriter::write(const ScanPair& pair)
{
  std::string text = "pair " + std::to_string(pair.id);
  appendPose(text, pair.T_ref_cur_true);
  appendPose(text, pair.T_ref_cur_odometry);
  put(text + '\n' + rangesText(pair.reference) + rangesText(pair.current));
}

void PairsWriter::close()
{
  if (gzclose(static_cast<gzFile>(file_.release())) != Z_OK)
    throw PairsFileError(path_ + ": cannot be written");
}

void PairsWriter::put(const std::string& text)
{
  const auto size = static_cast<unsigned>(text.size());
  if (gzwrite(static_cast<gzFile>(file_.get()), text.data(), size) != static_cast<int>(size))
    throw PairsFileError(path_ + ": cannot be written");
}

void PairsWriter::GzipClose::operator()(void* file) const { gzclose(static_cast<gzFile>(file)); }
}  // namespace psmks
