/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/draw/MapSheet.h>

#include <string>
#include <vector>

namespace psmks
{
/** The legend of a map's picture: rows of text, each with a sample of the line or mark that it
 * explains, and a bar for the scale. It is drawn last, in the corner where it hides least. */
class MapLegend
{
 public:
  explicit MapLegend(MapSheet& sheet) : sheet_(sheet), unit_(sheet.strokes(10)) {}

  void add(const std::string& text) { rows_.push_back({text, Sample::None, {}, 0}); }
  void addLine(const std::string& text, const MapSheet::Colour& colour, double width)
  {
    rows_.push_back({text, Sample::Line, colour, width});
  }
  void addMark(const std::string& text, const MapSheet::Colour& colour)
  {
    rows_.push_back({text, Sample::Mark, colour, 0});
  }
  /** Adds what MapSheet::drawEnds() draws. */
  void addEnds()
  {
    addMark("start", ink::kStart);
    addMark("end", ink::kEnd);
  }

  void draw();

 private:
  enum class Sample
  {
    None,
    Line,
    Mark
  };

  struct Row
  {
    std::string text;
    Sample sample;
    MapSheet::Colour colour;
    double width;
  };

  double fontScale() const;
  int textWidth(const std::string& text) const;
  cv::Rect emptiestCorner(const cv::Size& size) const;
  void drawBox(const cv::Rect& box);
  void drawRow(const Row& row, const cv::Point& at);
  void drawScale(const cv::Point& at, int barWidth, const std::string& text);
  void write(const std::string& text, const cv::Point& leftMiddle);

  MapSheet& sheet_;
  int unit_;  //!< half the distance of two rows in pixels
  std::vector<Row> rows_;
};
}  // namespace psmks
