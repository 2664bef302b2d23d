/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/draw/MapLegend.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace psmks
{
namespace
{
/** Half the distance of two rows, and the height of a capital letter as a share of it. */
constexpr double kUnit = 10, kCapital = 0.95;  // hairlines; share

constexpr const char* kXLabel = "x, m";
constexpr const char* kYLabel = "y, m";
}  // namespace

MapLegend::MapLegend(MapSheet& sheet)
    : sheet_(sheet),
      unit_(sheet.strokes(kUnit)),
      text_(std::max(1, static_cast<int>(std::lround(kCapital * unit_))))
{
}

void MapLegend::draw()
{
  const Margins margins = this->margins();
  cv::Mat& image = sheet_.image();
  const cv::Rect map({margins.left, margins.top}, image.size());
  cv::Mat framed;
  cv::copyMakeBorder(image, framed, margins.top, margins.bottom, margins.left, margins.right,
                     cv::BORDER_CONSTANT, ink::kPaper);
  image = framed;
  cv::Point title(margins.left, rowHeight());
  for (const std::string& text : titles_)
  {
    write(text, title);
    title.y += rowHeight();
  }
  drawAxes(margins, map);
  drawEntries({margins.left, map.br().y + 3 * rowHeight()}, framed.cols - margins.left);
}

/** Margins that hold all texts; on the right what titles and entries of the legend need. */
MapLegend::Margins MapLegend::margins() const
{
  Margins margins{text_.width_px(kYLabel), 2 * unit_, 0, 0};
  for (const double y : sheet_.frame().gridCoordinates_m(1))
    margins.left = std::max(margins.left, text_.width_px(lengthText(y)));
  margins.left += 3 * unit_;
  margins.top = (static_cast<int>(titles_.size()) + 2) * rowHeight();
  int widest = 0;
  for (const std::string& title : titles_) widest = std::max(widest, text_.width_px(title));
  for (const Entry& entry : entries_) widest = std::max(widest, widthOf(entry));
  const int mapWidth = sheet_.image().cols;
  margins.right = std::max(margins.right, widest - mapWidth + 2 * unit_);
  const auto places = this->places(mapWidth + margins.right);
  margins.bottom = (places.empty() ? 0 : places.back().y) + 4 * rowHeight();
  return margins;
}

/** Where the entries begin, one after the other in rows of a width. */
std::vector<cv::Point> MapLegend::places(int width) const
{
  std::vector<cv::Point> places;
  cv::Point at;
  for (const Entry& entry : entries_)
  {
    if (at.x > 0 && at.x + widthOf(entry) > width) at = {0, at.y + rowHeight()};
    places.push_back(at);
    at.x += widthOf(entry);
  }
  return places;
}

void MapLegend::drawAxes(const Margins& margins, const cv::Rect& map)
{
  cv::rectangle(sheet_.image(), map, ink::kFrame, sheet_.strokes(1), cv::LINE_AA);
  const MapFrame& frame = sheet_.frame();
  const int below = map.br().y + rowHeight();
  int free = map.x;  // where the last number ends
  for (const double x : frame.gridCoordinates_m(0))
  {
    const std::string text = lengthText(x);
    const int middle = map.x + static_cast<int>((x - frame.min_m.x()) / sheet_.pixel_m());
    const int begin = middle - text_.width_px(text) / 2;
    if (begin < free) continue;
    write(text, {begin, below});
    free = begin + text_.width_px(text) + unit_;
  }
  for (const double y : frame.gridCoordinates_m(1))
  {
    const std::string text = lengthText(y);
    const int middle = map.y + static_cast<int>((frame.max_m.y() - y) / sheet_.pixel_m());
    write(text, {margins.left - unit_ - text_.width_px(text), middle});
  }
  write(kYLabel, {margins.left - unit_ - text_.width_px(kYLabel), map.y - rowHeight()});
  write(kXLabel, {map.x + (map.width - text_.width_px(kXLabel)) / 2, below + rowHeight()});
}

void MapLegend::drawEntries(const cv::Point& at, int width)
{
  const auto places = this->places(width);
  for (std::size_t i = 0; i < entries_.size(); ++i)
  {
    const cv::Point from = at + places[i], to = from + cv::Point(3 * unit_, 0);
    drawSample(entries_[i], from, to);
    write(entries_[i].text, to + cv::Point(unit_, 0));
  }
}

void MapLegend::drawSample(const Entry& entry, const cv::Point& from, const cv::Point& to)
{
  cv::Mat& image = sheet_.image();
  const int width = sheet_.strokes(entry.width);
  if (entry.sample == Sample::Disc || entry.sample == Sample::Square)
    return sheet_.drawMark(
        (from + to) / 2, entry.colours.front(),
        entry.sample == Sample::Disc ? MapSheet::Mark::Disc : MapSheet::Mark::Square);
  const bool isDashed = entry.sample == Sample::Dashes;
  const int pieces = isDashed ? 5 : static_cast<int>(entry.colours.size());
  for (int piece = 0; piece < pieces; piece += isDashed ? 2 : 1)
    cv::line(image, from + (to - from) * piece / pieces, from + (to - from) * (piece + 1) / pieces,
             entry.colours[isDashed ? 0 : static_cast<std::size_t>(piece)], width, cv::LINE_AA);
}

void MapLegend::write(const std::string& text, const cv::Point& leftMiddle)
{
  text_.write(sheet_.image(), text, leftMiddle);
}
}  // namespace psmks
