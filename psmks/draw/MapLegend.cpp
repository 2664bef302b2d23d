/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/draw/MapLegend.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <sstream>

namespace psmks
{
namespace
{
constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;
constexpr double kFontHeight_px = 22;  // height of a letter at font scale 1
/** Least number of scale bars that fit side by side on the picture. */
constexpr double kBarsPerSheet = 6;
constexpr double kBoxShade = 0.85;                   // brightness of the frame relative to the grid
constexpr double kBarWidth = 1.5, kMarkWidth = 4.5;  // hairlines
}  // namespace

void MapLegend::draw()
{
  const double sheetWidth_m = sheet_.frame().max_m.x() - sheet_.frame().min_m.x();
  const double scale_m = roundLength(sheetWidth_m / kBarsPerSheet);
  std::ostringstream lengthText;
  lengthText << scale_m << " m";
  const std::string scaleText = lengthText.str();
  const int barWidth = static_cast<int>(std::lround(scale_m / sheet_.pixel_m()));
  int width = barWidth + unit_ + textWidth(scaleText);
  for (const auto& row : rows_) width = std::max(width, 4 * unit_ + textWidth(row.text));
  const int height = 2 * (static_cast<int>(rows_.size()) + 1) * unit_;
  const cv::Rect box = emptiestCorner({width + 3 * unit_, height + 2 * unit_});
  drawBox(box);

  cv::Point at = box.tl() + cv::Point(unit_, 2 * unit_);
  for (const auto& row : rows_)
  {
    drawRow(row, at);
    at.y += 2 * unit_;
  }
  drawScale(at, barWidth, scaleText);
}

double MapLegend::fontScale() const { return unit_ / kFontHeight_px; }

int MapLegend::textWidth(const std::string& text) const
{
  int baseline = 0;
  return cv::getTextSize(text, kFont, fontScale(), sheet_.strokes(1), &baseline).width;
}

/** The corner whose mean brightness is highest, so that the box hides as little as possible. */
cv::Rect MapLegend::emptiestCorner(const cv::Size& size) const
{
  const cv::Mat& image = sheet_.image();
  const int left = unit_, top = unit_;
  const int right = std::max(left, image.cols - size.width - unit_);
  const int bottom = std::max(top, image.rows - size.height - unit_);
  cv::Rect best;
  double brightest = -1;
  for (const cv::Point corner :
       {cv::Point(left, bottom), {right, bottom}, {left, top}, {right, top}})
  {
    const cv::Rect box(corner, size);
    const cv::Scalar mean = cv::mean(image(box & cv::Rect({0, 0}, image.size())));
    const double brightness = mean[0] + mean[1] + mean[2];
    if (brightness <= brightest) continue;
    brightest = brightness;
    best = box;
  }
  return best;
}

void MapLegend::drawBox(const cv::Rect& box)
{
  cv::rectangle(sheet_.image(), box, ink::kPaper, cv::FILLED);
  cv::rectangle(sheet_.image(), box, ink::kGrid * kBoxShade, sheet_.strokes(1), cv::LINE_AA);
}

void MapLegend::drawRow(const Row& row, const cv::Point& at)
{
  if (row.sample == Sample::None) return write(row.text, at);
  const cv::Point sampleEnd = at + cv::Point(3 * unit_, 0);
  if (row.sample == Sample::Line)
    cv::line(sheet_.image(), at, sampleEnd, row.colour, sheet_.strokes(row.width), cv::LINE_AA);
  else
    cv::circle(sheet_.image(), (at + sampleEnd) / 2, sheet_.strokes(kMarkWidth), row.colour,
               cv::FILLED, cv::LINE_AA);
  write(row.text, sampleEnd + cv::Point(unit_, 0));
}

void MapLegend::drawScale(const cv::Point& at, int barWidth, const std::string& text)
{
  const cv::Point end = at + cv::Point(barWidth, 0), tick(0, unit_ / 2);
  const int stroke_px = sheet_.strokes(kBarWidth);
  cv::line(sheet_.image(), at, end, ink::kText, stroke_px, cv::LINE_AA);
  for (const auto& p : {at, end})
    cv::line(sheet_.image(), p - tick, p + tick, ink::kText, stroke_px, cv::LINE_AA);
  write(text, end + cv::Point(unit_, 0));
}

void MapLegend::write(const std::string& text, const cv::Point& leftMiddle)
{
  cv::putText(sheet_.image(), text, leftMiddle + cv::Point(0, unit_ / 2), kFont, fontScale(),
              ink::kText, sheet_.strokes(1), cv::LINE_AA);
}
}  // namespace psmks
