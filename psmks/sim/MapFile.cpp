/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/base/NumberRow.h>
#include <psmks/base/ShortText.h>
#include <psmks/sim/MapFile.h>

#include <algorithm>
#include <string>

namespace psmks
{
namespace
{
constexpr double kMetresPerUnit = 0.001;
constexpr std::size_t kCoordinatesOfLine = 4, kCoordinatesOfPoint = 2, kCoordinatesOfHome = 3;

enum class Section
{
  Header,
  Lines,
  Data
};

/** Reads a map file line by line. */
class MapText
{
 public:
  explicit MapText(std::istream& in) : in_(in) {}

  bool next()
  {
    ++number_;
    if (!std::getline(in_, line_)) return false;
    line_.erase(line_.find_last_not_of(" \t\r") + 1);
    return true;
  }

  const std::string& line() const { return line_; }

  [[noreturn]] void fail(const std::string& reason) const
  {
    throw MapFileError("line " + std::to_string(number_) + ": " + reason);
  }

  /** The numbers of a part of this line, at least `count` of them. */
  std::vector<double> numbers(std::string_view text, std::size_t count) const
  {
    const auto row = parseNumberRow(text);
    if (!row || row->size() < count)
      fail("expected " + std::to_string(count) + " numbers, found '" + shortText(line_) + "'");
    return *row;
  }

 private:
  std::istream& in_;
  std::string line_;
  int number_ = 0;
};

/** Reads the start pose from a line 'Cairn: RobotHome x y angle "" ICON ""' with the angle in
 * degrees; other headers are ignored. */
void readHeader(const MapText& text, Site& site)
{
  constexpr std::string_view kHome = "Cairn: RobotHome ";
  if (text.line().compare(0, kHome.size(), kHome) != 0) return;
  const std::size_t nameAt = std::min(text.line().find('"'), text.line().size());
  const std::string_view pose(text.line().data() + kHome.size(), nameAt - kHome.size());
  const std::vector<double> home = text.numbers(pose, kCoordinatesOfHome);
  site.T_world_start = {home[0] * kMetresPerUnit, home[1] * kMetresPerUnit,
                        wrapAngle(degToRad(home[2]))};
}

void readRow(const MapText& text, Section section, World& world)
{
  if (text.line().empty()) return;
  const bool isLine = section == Section::Lines;
  const std::vector<double> row =
      text.numbers(text.line(), isLine ? kCoordinatesOfLine : kCoordinatesOfPoint);
  const Eigen::Vector2d first = kMetresPerUnit * Eigen::Vector2d(row[0], row[1]);
  if (isLine)
    world.addWall({first, kMetresPerUnit * Eigen::Vector2d(row[2], row[3])});
  else
    world.addPoint(first);
}
}  // namespace

Site readMapFile(std::istream& in)
{
  MapText text(in);
  if (!text.next() || text.line() != "2D-Map") text.fail("expected '2D-Map': not a map");
  Site site;
  Section section = Section::Header;
  while (text.next())
  {
    if (text.line() == "LINES")
      section = Section::Lines;
    else if (text.line() == "DATA")
      section = Section::Data;
    else if (section == Section::Header)
      readHeader(text, site);
    else
      readRow(text, section, site.world);
  }
  return site;
}
}  // namespace psmks
