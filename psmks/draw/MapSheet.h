/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/draw/MapFrame.h>
#include <psmks/geometry/Pose2.h>

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace psmks
{
/** The picture of a map while it is drawn: x to the right, y up, coordinates in metres.
 *
 * A pixel is 2 cm, but the longer side of the picture has 1200 to 4000 pixels. Widths of lines and
 * sizes of letters are given in hairlines, which are a fixed share of the longer side, so that
 * pictures of all sizes look alike. */
class MapSheet
{
 public:
  using Colour = cv::Scalar;  //!< blue, green, red: 0 to 255

  explicit MapSheet(const MapFrame& frame);

  /** Draws faint lines at round coordinates, four to ten of them along the longer side. */
  void drawGrid();

  void drawPoints(const std::vector<Eigen::Vector2d>& points_m, const Colour& colour);

  /** Draws a straight line.
   *  @param width in hairlines */
  void drawLine(const Eigen::Vector2d& a_m, const Eigen::Vector2d& b_m, const Colour& colour,
                double width);

  /** Draws straight lines from each place to the next.
   *  @param width in hairlines */
  void drawPath(const std::vector<Eigen::Vector2d>& path_m, const Colour& colour, double width);

  /** Marks the start and the end of a path in the colours of MapLegend::addEnds().
   *  @param path_m not empty */
  void drawEnds(const std::vector<Eigen::Vector2d>& path_m);

  /** The shape of a mark. */
  enum class Mark
  {
    Disc,
    Square
  };

  /** Marks a place by a shape with a rim in the colour of the paper. */
  void drawMark(const Eigen::Vector2d& p_m, const Colour& colour, Mark mark = Mark::Disc);

  /** Marks a pixel of image(). */
  void drawMark(const cv::Point& pixel, const Colour& colour, Mark mark);

  const MapFrame& frame() const { return frame_; }
  double pixel_m() const { return pixel_m_; }

  /** The pixels, at least 1, of a line that is `width` hairlines wide. */
  int strokes(double width) const;

  cv::Mat& image() { return image_; }

  /** Writes the picture; the ending of the name says the format.
   *  @return false if the file cannot be written */
  bool save(const std::string& path) const;

 private:
  cv::Point pixel(const Eigen::Vector2d& p_m, int parts = 1) const;

  MapFrame frame_;
  double pixel_m_;
  double hairline_px_;
  cv::Mat image_;
};

/** The places of poses. */
std::vector<Eigen::Vector2d> placesOf(const std::vector<Pose2>& path);

/** Colours that mean the same in every picture. */
namespace ink
{
const MapSheet::Colour kPaper(255, 255, 255);
const MapSheet::Colour kGrid(240, 238, 236);
const MapSheet::Colour kText(60, 50, 45);
const MapSheet::Colour kWall(70, 40, 20);
const MapSheet::Colour kFrame(160, 155, 150);
// Of the palette of Okabe and Ito, which colour-blind readers can tell apart.
const MapSheet::Colour kStart(115, 158, 0);
const MapSheet::Colour kEnd(178, 114, 0);
}  // namespace ink
}  // namespace psmks
