/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/mrpt/MapPicture.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <sstream>

namespace psmks
{
namespace
{
using Colour = cv::Scalar;  // blue, green, red

const Colour kPaper(255, 255, 255);
const Colour kGrid(240, 238, 236);
const Colour kPoint(190, 170, 140);
const Colour kWall(70, 40, 20);
const Colour kOdometry(140, 150, 255);
const Colour kStart(60, 150, 30);
const Colour kEnd(40, 30, 200);
const Colour kText(60, 50, 45);

constexpr double kFinestPixel_m = 0.02;
constexpr int kLongestSide_px = 4000;
constexpr double kMargin_m = 1.0;
constexpr double kOutlierShare = 0.002;  // of the points, on each side of the frame

struct Frame
{
  Eigen::Vector2d min_m, max_m;
};

/** The range of values, without the outermost ones on either side. */
std::pair<double, double> bulkOf(std::vector<double> values)
{
  const auto skipped =
      static_cast<std::ptrdiff_t>(kOutlierShare * static_cast<double>(values.size()));
  std::nth_element(values.begin(), values.begin() + skipped, values.end());
  const double low = values[static_cast<std::size_t>(skipped)];
  std::nth_element(values.begin(), values.end() - 1 - skipped, values.end());
  return {low, *(values.end() - 1 - skipped)};
}

Frame frameOf(const ScanMap& map)
{
  std::vector<double> xs, ys;
  for (const auto& p : map.points_m)
  {
    xs.push_back(p.x());
    ys.push_back(p.y());
  }
  const auto [xMin, xMax] = bulkOf(std::move(xs));
  const auto [yMin, yMax] = bulkOf(std::move(ys));
  Frame frame{{xMin, yMin}, {xMax, yMax}};
  for (const auto& pose : map.path)
  {
    frame.min_m = frame.min_m.cwiseMin(pose.translation());
    frame.max_m = frame.max_m.cwiseMax(pose.translation());
  }
  frame.min_m.array() -= kMargin_m;
  frame.max_m.array() += kMargin_m;
  return frame;
}

/** 1, 2 or 5 times a power of ten, at most x. */
double roundLength(double x)
{
  const double decade = std::pow(10.0, std::floor(std::log10(x)));
  for (const double step : {5.0, 2.0})
    if (step * decade <= x) return step * decade;
  return decade;
}

/** A sheet of paper with the map's frame on it. Lines and letters grow with the sheet. */
class Sheet
{
 public:
  explicit Sheet(const Frame& frame) : frame_(frame)
  {
    const Eigen::Vector2d size_m = frame.max_m - frame.min_m;
    pixel_m_ = std::max(kFinestPixel_m, size_m.maxCoeff() / kLongestSide_px);
    const Eigen::Vector2i size_px = (size_m / pixel_m_).array().ceil().cast<int>();
    image_ = cv::Mat(size_px.y(), size_px.x(), CV_8UC3, kPaper);
    stroke_ = std::max(1.0, size_px.maxCoeff() / 900.0);
  }

  void drawGrid(double spacing_m)
  {
    for (double x = std::ceil(frame_.min_m.x() / spacing_m) * spacing_m; x < frame_.max_m.x();
         x += spacing_m)
      line({x, frame_.min_m.y()}, {x, frame_.max_m.y()}, kGrid, 1);
    for (double y = std::ceil(frame_.min_m.y() / spacing_m) * spacing_m; y < frame_.max_m.y();
         y += spacing_m)
      line({frame_.min_m.x(), y}, {frame_.max_m.x(), y}, kGrid, 1);
  }

  void drawPoints(const std::vector<Eigen::Vector2d>& points_m)
  {
    const int radius = static_cast<int>(stroke_ / 3);
    for (const auto& p : points_m)
      cv::rectangle(image_, pixel(p) - cv::Point(radius, radius),
                    pixel(p) + cv::Point(radius, radius), kPoint, cv::FILLED);
  }

  void line(const Eigen::Vector2d& a_m, const Eigen::Vector2d& b_m, const Colour& colour,
            double width)
  {
    constexpr int kShift = 4;  // OpenCV's fixed point: sixteenths of a pixel
    cv::line(image_, pixel(a_m, 1 << kShift), pixel(b_m, 1 << kShift), colour, strokes(width),
             cv::LINE_AA, kShift);
  }

  void drawMark(const Eigen::Vector2d& p_m, const Colour& colour)
  {
    cv::circle(image_, pixel(p_m), strokes(6), kPaper, cv::FILLED, cv::LINE_AA);
    cv::circle(image_, pixel(p_m), strokes(4.5), colour, cv::FILLED, cv::LINE_AA);
  }

  const Frame& frame() const { return frame_; }
  double pixel_m() const { return pixel_m_; }
  int strokes(double width) const
  {
    return std::max(1, static_cast<int>(std::lround(width * stroke_)));
  }
  cv::Mat& image() { return image_; }

 private:
  cv::Point pixel(const Eigen::Vector2d& p_m, int parts = 1) const
  {
    const double scale = parts / pixel_m_;
    return {static_cast<int>(std::lround((p_m.x() - frame_.min_m.x()) * scale)),
            static_cast<int>(std::lround((frame_.max_m.y() - p_m.y()) * scale))};
  }

  Frame frame_;
  double pixel_m_;
  double stroke_;  //!< pixels of a hairline
  cv::Mat image_;
};

/** From violet at the start over red to orange at the end. */
Colour pathColour(double share)
{
  const Colour stops[] = {{170, 30, 90}, {110, 50, 210}, {20, 150, 250}};
  const int first = share < 0.5 ? 0 : 1;
  const double t = 2 * share - first;
  return stops[first] * (1 - t) + stops[first + 1] * t;
}

void drawPath(Sheet& sheet, const std::vector<Pose2>& path)
{
  for (std::size_t i = 1; i < path.size(); ++i)
    sheet.line(path[i - 1].translation(), path[i].translation(),
               pathColour(static_cast<double>(i) / static_cast<double>(path.size())), 2.2);
}

/** Dashes of equal length along the path, whatever the spacing of its poses. */
void drawDashed(Sheet& sheet, const std::vector<Pose2>& path, const Colour& colour)
{
  const double dash_m = 8 * sheet.strokes(1) * sheet.pixel_m();
  double way_m = 0;
  for (std::size_t i = 1; i < path.size(); ++i)
  {
    const Eigen::Vector2d a = path[i - 1].translation(), b = path[i].translation();
    const double length_m = (b - a).norm();
    const int pieces = std::max(1, static_cast<int>(std::ceil(4 * length_m / dash_m)));
    for (int k = 0; k < pieces; ++k)
    {
      const double from = static_cast<double>(k) / pieces, to = static_cast<double>(k + 1) / pieces;
      const bool ink = std::fmod(way_m + from * length_m, 2 * dash_m) < dash_m;
      if (ink) sheet.line(a + from * (b - a), a + to * (b - a), colour, 1.2);
    }
    way_m += length_m;
  }
}

/** Lines of text, each behind a sample of what it names, in the emptiest corner of the sheet. */
class Legend
{
 public:
  explicit Legend(Sheet& sheet) : sheet_(sheet), unit_(sheet.strokes(10)) {}

  void add(const std::string& text) { rows_.push_back({text, {}, 0}); }
  void addLine(const std::string& text, const Colour& colour, double width)
  {
    rows_.push_back({text, colour, width});
  }
  void addMark(const std::string& text, const Colour& colour)
  {
    rows_.push_back({text, colour, -1});
  }

  void draw(double scale_m, const std::string& scaleText)
  {
    const int barWidth = static_cast<int>(std::lround(scale_m / sheet_.pixel_m()));
    int width = barWidth + 3 * unit_ + textWidth(scaleText);
    for (const auto& row : rows_) width = std::max(width, 5 * unit_ + textWidth(row.text));
    const cv::Size size(width + 2 * unit_, (2 * static_cast<int>(rows_.size()) + 4) * unit_);
    const cv::Rect box(emptiestCorner(size), size);
    cv::rectangle(sheet_.image(), box, kPaper, cv::FILLED);
    cv::rectangle(sheet_.image(), box, kGrid * 0.85, sheet_.strokes(1), cv::LINE_AA);

    cv::Point at = box.tl() + cv::Point(unit_, 2 * unit_);
    for (const auto& row : rows_)
    {
      drawRow(row, at);
      at.y += 2 * unit_;
    }
    drawScale(at, barWidth, scaleText);
  }

 private:
  struct Row
  {
    std::string text;
    Colour colour;
    double width;  //!< of a line; 0: text alone; negative: a mark
  };

  static constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;
  double fontScale() const { return unit_ / 22.0; }

  int textWidth(const std::string& text) const
  {
    int baseline = 0;
    return cv::getTextSize(text, kFont, fontScale(), sheet_.strokes(1), &baseline).width;
  }

  void write(const std::string& text, const cv::Point& leftMiddle)
  {
    cv::putText(sheet_.image(), text, leftMiddle + cv::Point(0, unit_ / 2), kFont, fontScale(),
                kText, sheet_.strokes(1), cv::LINE_AA);
  }

  void drawRow(const Row& row, const cv::Point& at)
  {
    const cv::Point sampleEnd = at + cv::Point(3 * unit_, 0);
    if (row.width > 0)
      cv::line(sheet_.image(), at, sampleEnd, row.colour, sheet_.strokes(row.width), cv::LINE_AA);
    if (row.width < 0)
      cv::circle(sheet_.image(), (at + sampleEnd) / 2, sheet_.strokes(4.5), row.colour, cv::FILLED,
                 cv::LINE_AA);
    write(row.text, row.width == 0 ? at : sampleEnd + cv::Point(unit_, 0));
  }

  void drawScale(const cv::Point& at, int barWidth, const std::string& text)
  {
    const cv::Point end = at + cv::Point(barWidth, 0), tick(0, unit_ / 2);
    cv::line(sheet_.image(), at, end, kText, sheet_.strokes(1.5), cv::LINE_AA);
    for (const auto& p : {at, end})
      cv::line(sheet_.image(), p - tick, p + tick, kText, sheet_.strokes(1.5), cv::LINE_AA);
    write(text, end + cv::Point(unit_, 0));
  }

  /** Upper left corner of the box where it hides least ink. */
  cv::Point emptiestCorner(const cv::Size& size) const
  {
    const cv::Mat& image = sheet_.image();
    const int left = unit_, top = unit_;
    const int right = std::max(left, image.cols - size.width - unit_);
    const int bottom = std::max(top, image.rows - size.height - unit_);
    cv::Point best(left, bottom);
    double brightest = -1;
    for (const cv::Point corner :
         {cv::Point(left, bottom), {right, bottom}, {left, top}, {right, top}})
    {
      const cv::Rect box = cv::Rect(corner, size) & cv::Rect({0, 0}, image.size());
      const Colour mean = cv::mean(image(box));
      const double brightness = mean[0] + mean[1] + mean[2];
      if (brightness <= brightest) continue;
      brightest = brightness;
      best = corner;
    }
    return best;
  }

  Sheet& sheet_;
  int unit_;
  std::vector<Row> rows_;
};

void drawLegend(Sheet& sheet, const ScanMap& map, const std::string& title)
{
  const double width_m = sheet.frame().max_m.x() - sheet.frame().min_m.x();
  const double scale_m = roundLength(width_m / 6);
  Legend legend(sheet);
  legend.add(title);
  legend.addLine("points of " + std::to_string(map.path.size()) + " scans", kPoint, 2);
  legend.addLine("segments of the reference scans", kWall, 1);
  legend.addLine("path", pathColour(0.5), 2.2);
  if (!map.odometryPath.empty()) legend.addLine("odometry alone", kOdometry, 1.2);
  legend.addMark("start", kStart);
  legend.addMark("end", kEnd);
  std::ostringstream scaleText;
  scaleText << scale_m << " m";
  legend.draw(scale_m, scaleText.str());
}
}  // namespace

bool saveMapPicture(const ScanMap& map, const std::string& title, const std::string& path)
{
  if (map.points_m.empty() || map.path.empty()) return false;
  Sheet sheet(frameOf(map));
  sheet.drawGrid(roundLength((sheet.frame().max_m - sheet.frame().min_m).maxCoeff() / 4));
  sheet.drawPoints(map.points_m);
  for (const auto& wall : map.walls) sheet.line(wall.from_m, wall.to_m, kWall, 1);
  drawDashed(sheet, map.odometryPath, kOdometry);
  drawPath(sheet, map.path);
  sheet.drawMark(map.path.front().translation(), kStart);
  sheet.drawMark(map.path.back().translation(), kEnd);
  drawLegend(sheet, map, title);
  return cv::imwrite(path, sheet.image());
}
}  // namespace psmks
