/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/draw/MapSheet.h>
#include <psmks/draw/MapText.h>

#include <string>
#include <vector>

namespace psmks
{
/** What surrounds the picture of a map: the titles above it, numbers in metres at its grid, and a
 * legend below it. It is drawn last, and nothing of it lies on the map.
 *
 *      title
 *     +-----------+
 *   5 |    map    |
 *     +-----------+
 *      0    5   x, m
 *      -- walls  o start
 */
class MapLegend
{
 public:
  explicit MapLegend(MapSheet& sheet);

  /** Adds a title. */
  void add(const std::string& text) { titles_.push_back(text); }

  void addLine(const std::string& text, const MapSheet::Colour& colour, double width)
  {
    entries_.push_back({text, Sample::Line, {colour}, width});
  }
  void addDashes(const std::string& text, const MapSheet::Colour& colour, double width)
  {
    entries_.push_back({text, Sample::Dashes, {colour}, width});
  }
  /** Adds a line whose colour changes along it, by its colours from start to end. */
  void addShades(const std::string& text, const std::vector<MapSheet::Colour>& colours,
                 double width)
  {
    entries_.push_back({text, Sample::Line, colours, width});
  }
  void addMark(const std::string& text, const MapSheet::Colour& colour,
               MapSheet::Mark mark = MapSheet::Mark::Disc)
  {
    entries_.push_back(
        {text, mark == MapSheet::Mark::Disc ? Sample::Disc : Sample::Square, {colour}, 0});
  }
  /** Adds what MapSheet::drawEnds() draws. */
  void addEnds()
  {
    addMark("start", ink::kStart);
    addMark("end", ink::kEnd, MapSheet::Mark::Square);
  }

  /** Puts the margins around the map and draws into them. */
  void draw();

 private:
  enum class Sample
  {
    Line,
    Dashes,
    Disc,
    Square
  };

  struct Entry
  {
    std::string text;
    Sample sample;
    std::vector<MapSheet::Colour> colours;
    double width;
  };

  /** The margins around the map, in pixels. */
  struct Margins
  {
    int left, right, top, bottom;
  };

  int rowHeight() const { return 2 * unit_; }
  int widthOf(const Entry& entry) const { return 6 * unit_ + text_.width_px(entry.text); }
  Margins margins() const;
  std::vector<cv::Point> places(int width) const;
  void drawAxes(const Margins& margins, const cv::Rect& map);
  void drawEntries(const cv::Point& at, int width);
  void drawSample(const Entry& entry, const cv::Point& from, const cv::Point& to);
  void write(const std::string& text, const cv::Point& leftMiddle);

  MapSheet& sheet_;
  int unit_;  //!< half the distance of two rows in pixels
  MapText text_;
  std::vector<std::string> titles_;
  std::vector<Entry> entries_;
};
}  // namespace psmks
