/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/draw/MapSheet.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

namespace psmks
{
namespace
{
constexpr double kUsualPixel_m = 0.02;  // fine enough to show the noise of a laser scanner
constexpr int kShortestSide_px = 1200, kLongestSide_px = 4000;  // pixels of the longer side
constexpr double kHairlinesPerSheet = 900;                      // along the longer side
constexpr double kMarkWidth = 4.5, kRimWidth = 6;               // hairlines

/** The size of a pixel: the usual one, smaller for small maps and larger for large ones. */
double pixelSize_m(double longerSide_m)
{
  return std::max(std::min(kUsualPixel_m, longerSide_m / kShortestSide_px),
                  longerSide_m / kLongestSide_px);
}
}  // namespace

MapSheet::MapSheet(const MapFrame& frame) : frame_(frame)
{
  const Eigen::Vector2d size_m = frame.size_m();
  if (!size_m.allFinite() || !(size_m.maxCoeff() > 0))
    throw std::invalid_argument("a map without extent, or of infinite extent, cannot be drawn");
  pixel_m_ = pixelSize_m(size_m.maxCoeff());
  const Eigen::Vector2i size_px = (size_m / pixel_m_).array().ceil().max(1).cast<int>();
  image_ = cv::Mat(size_px.y(), size_px.x(), CV_8UC3, ink::kPaper);
  hairline_px_ = std::max(1.0, size_px.maxCoeff() / kHairlinesPerSheet);
}

void MapSheet::drawGrid()
{
  const auto [min_m, max_m] = frame_;
  for (const double x : frame_.gridCoordinates_m(0))
    drawLine({x, min_m.y()}, {x, max_m.y()}, ink::kGrid, 1);
  for (const double y : frame_.gridCoordinates_m(1))
    drawLine({min_m.x(), y}, {max_m.x(), y}, ink::kGrid, 1);
}

void MapSheet::drawPoints(const std::vector<Eigen::Vector2d>& points_m, const Colour& colour)
{
  const int reach = static_cast<int>(hairline_px_ / 3);
  for (const auto& p : points_m)
    cv::rectangle(image_, pixel(p) - cv::Point(reach, reach), pixel(p) + cv::Point(reach, reach),
                  colour, cv::FILLED);
}

void MapSheet::drawLine(const Eigen::Vector2d& a_m, const Eigen::Vector2d& b_m,
                        const Colour& colour, double width)
{
  constexpr int kShift = 4;  // OpenCV takes fixed-point coordinates: here sixteenths of a pixel
  cv::line(image_, pixel(a_m, 1 << kShift), pixel(b_m, 1 << kShift), colour, strokes(width),
           cv::LINE_AA, kShift);
}

void MapSheet::drawPath(const std::vector<Eigen::Vector2d>& path_m, const Colour& colour,
                        double width)
{
  for (std::size_t i = 1; i < path_m.size(); ++i) drawLine(path_m[i - 1], path_m[i], colour, width);
}

void MapSheet::drawEnds(const std::vector<Eigen::Vector2d>& path_m)
{
  drawMark(path_m.front(), ink::kStart);
  drawMark(path_m.back(), ink::kEnd, Mark::Square);
}

void MapSheet::drawMark(const Eigen::Vector2d& p_m, const Colour& colour, Mark mark)
{
  drawMark(pixel(p_m), colour, mark);
}

void MapSheet::drawMark(const cv::Point& pixel, const Colour& colour, Mark mark)
{
  const auto draw = [&](const Colour& ink, int reach)
  {
    const cv::Point corner(reach, reach);
    if (mark == Mark::Square)
      cv::rectangle(image_, pixel - corner, pixel + corner, ink, cv::FILLED);
    else
      cv::circle(image_, pixel, reach, ink, cv::FILLED, cv::LINE_AA);
  };
  draw(ink::kPaper, strokes(kRimWidth));
  draw(colour, strokes(kMarkWidth));
}

int MapSheet::strokes(double width) const
{
  return std::max(1, static_cast<int>(std::lround(width * hairline_px_)));
}

cv::Point MapSheet::pixel(const Eigen::Vector2d& p_m, int parts) const
{
  const double scale = parts / pixel_m_;
  return {static_cast<int>(std::lround((p_m.x() - frame_.min_m.x()) * scale)),
          static_cast<int>(std::lround((frame_.max_m.y() - p_m.y()) * scale))};
}

bool MapSheet::save(const std::string& path) const
{
  const std::string ending = std::filesystem::path(path).extension().string();
  std::vector<unsigned char> bytes;
  if (ending.empty() || !cv::imencode(ending, image_, bytes)) return false;
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
  file.close();
  return !file.fail();
}

std::vector<Eigen::Vector2d> placesOf(const std::vector<Pose2>& path)
{
  std::vector<Eigen::Vector2d> places_m;
  for (const auto& pose : path) places_m.push_back(pose.translation());
  return places_m;
}
}  // namespace psmks
