/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/draw/MapFrame.h>
#include <psmks/draw/MapSvg.h>
#include <psmks/eval/HtmlText.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>

namespace psmks
{
namespace
{
/** The longer side of the map, and the margins around it. Unit: px. */
constexpr double kLongerSide_px = 1000, kLeft_px = 60, kRight_px = 20, kTop_px = 40,
                 kBottom_px = 80;
/** Distance of a text from what it belongs to, and from one row to the next. Unit: px. */
constexpr double kGap_px = 8, kRow_px = 18;
/** Least width of the sheet, for the legend. Unit: px. */
constexpr double kLeastWidth_px = 560;

constexpr const char* kStyle =
    "<style>\n"
    "text { font-family: sans-serif; font-size: 13px; fill: #222 }\n"
    ".title { font-size: 16px }\n"
    ".x { text-anchor: middle } .y { text-anchor: end; dominant-baseline: middle }\n"
    ".grid { stroke: #ddd; stroke-width: 1; fill: none }\n"
    "#segments, .segments { stroke: #142846; stroke-width: 1.2; stroke-linecap: round; fill: none "
    "}\n"
    "#path, .path { stroke: #d55e00; stroke-width: 1.5; fill: none }\n"
    ".start { fill: #009e73 } .end { fill: #0072b2 }\n"
    "</style>\n";

/** The document while it is written: from metres to pixels. */
class MapSvg
{
 public:
  MapSvg(std::ostream& out, const MapFrame& frame) : out_(out), frame_(frame)
  {
    scale_ = kLongerSide_px / frame.size_m().maxCoeff();
    out_ << std::fixed << std::setprecision(2);
  }

  void write(const ScanMap& map, const std::string& title)
  {
    begin(title);
    drawGrid();
    drawSegments(map);
    drawPath(map.path);
    drawLegend(map);
    out_ << "</svg>\n";
  }

 private:
  double right_px() const { return x_px(frame_.max_m.x()); }
  double bottom_px() const { return y_px(frame_.min_m.y()); }
  double x_px(double x_m) const { return kLeft_px + scale_ * (x_m - frame_.min_m.x()); }
  double y_px(double y_m) const { return kTop_px + scale_ * (frame_.max_m.y() - y_m); }

  void begin(const std::string& title)
  {
    const double width_px = std::max(kLeastWidth_px, right_px() + kRight_px);
    const double height_px = bottom_px() + kBottom_px;
    out_ << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << width_px << "\" height=\""
         << height_px << "\" viewBox=\"0 0 " << width_px << ' ' << height_px << "\">\n"
         << "<title>" << htmlText(title) << "</title>\n"
         << kStyle << "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
    write(title, "title", kLeft_px, kTop_px - 2 * kGap_px);
  }

  void write(const std::string& text, const char* style, double at_x_px, double at_y_px)
  {
    out_ << "<text class=\"" << style << "\" x=\"" << at_x_px << "\" y=\"" << at_y_px << "\">"
         << htmlText(text) << "</text>\n";
  }

  void drawGrid()
  {
    out_ << "<path class=\"grid\" d=\"";
    for (const double x : frame_.gridCoordinates_m(0))
      out_ << 'M' << x_px(x) << ' ' << kTop_px << 'V' << bottom_px();
    for (const double y : frame_.gridCoordinates_m(1))
      out_ << 'M' << kLeft_px << ' ' << y_px(y) << 'H' << right_px();
    out_ << "\"/>\n<rect class=\"grid\" x=\"" << kLeft_px << "\" y=\"" << kTop_px << "\" width=\""
         << right_px() - kLeft_px << "\" height=\"" << bottom_px() - kTop_px << "\"/>\n";
    for (const double x : frame_.gridCoordinates_m(0))
      write(lengthText(x), "x", x_px(x), bottom_px() + 2 * kGap_px);
    for (const double y : frame_.gridCoordinates_m(1))
      write(lengthText(y), "y", kLeft_px - kGap_px, y_px(y));
    write("x, m", "x", (kLeft_px + right_px()) / 2, bottom_px() + kGap_px + kRow_px + kGap_px);
    write("y, m", "y", kLeft_px - kGap_px, kTop_px - kGap_px);
  }

  void drawSegments(const ScanMap& map)
  {
    out_ << "<path id=\"segments\" d=\"";
    for (const ScanMap::Wall& wall : map.walls)
      out_ << 'M' << x_px(wall.from_m.x()) << ' ' << y_px(wall.from_m.y()) << 'L'
           << x_px(wall.to_m.x()) << ' ' << y_px(wall.to_m.y());
    out_ << "\"/>\n";
  }

  void drawPath(const std::vector<Pose2>& path)
  {
    out_ << "<polyline id=\"path\" points=\"";
    for (const Pose2& pose : path) out_ << x_px(pose.x_m) << ',' << y_px(pose.y_m) << ' ';
    out_ << "\"/>\n";
    if (path.empty()) return;
    drawMark("start", x_px(path.front().x_m), y_px(path.front().y_m));
    drawMark("end", x_px(path.back().x_m), y_px(path.back().y_m));
  }

  void drawMark(const char* style, double at_x_px, double at_y_px)
  {
    out_ << "<circle class=\"" << style << "\" cx=\"" << at_x_px << "\" cy=\"" << at_y_px
         << "\" r=\"5\"/>\n";
  }

  /** One row below the map; every entry has the width of its text. */
  void drawLegend(const ScanMap& map)
  {
    const double y = bottom_px() + kBottom_px - kRow_px;
    double x = drawSample("segments", kLeft_px, y);
    x = writeEntry(std::to_string(map.walls.size()) + " segments of the reference scans", x, y);
    x = drawSample("path", x, y);
    x = writeEntry("path", x, y);
    for (const char* end : {"start", "end"})
    {
      drawMark(end, x + kGap_px, y);
      x = writeEntry(end, x + 2 * kGap_px, y);
    }
  }

  double drawSample(const char* style, double x, double y)
  {
    const double end = x + 3 * kGap_px;
    out_ << "<path class=\"" << style << "\" d=\"M" << x << ' ' << y << 'H' << end << "\"/>\n";
    return end;
  }

  /** @return where the next entry begins */
  double writeEntry(const std::string& text, double x, double y)
  {
    /** Width of a letter, rather too wide. Unit: px. */
    constexpr double kLetter_px = 7.5;
    write(text, "entry", x + kGap_px, y + kGap_px / 2);
    return x + 3 * kGap_px + kLetter_px * static_cast<double>(text.size());
  }

  std::ostream& out_;
  MapFrame frame_;
  double scale_;  //!< px/m
};
}  // namespace

void writeMapSvg(std::ostream& out, const ScanMap& map, const std::string& title)
{
  const bool isEmpty = map.points_m.empty() || map.path.empty();
  const MapFrame frame = isEmpty ? MapFrame{{0, 0}, {1, 1}} : frameOf(map);
  MapSvg(out, frame).write(map, title);
}
}  // namespace psmks
