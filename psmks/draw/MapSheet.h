/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <vector>

namespace psmks
{
/** A sheet of paper for the picture of a map (MapPicture): x to the right, y up, in metres. Lines
 * and letters grow with the sheet. */
class MapSheet
{
 public:
  using Colour = cv::Scalar;  //!< blue, green, red: 0 to 255

  struct Frame
  {
    Eigen::Vector2d min_m, max_m;
  };

  explicit MapSheet(const Frame& frame);

  /** Faint lines, four to ten along the longer side. */
  void drawGrid();

  void drawPoints(const std::vector<Eigen::Vector2d>& points_m, const Colour& colour);

  /** @param width hairlines */
  void drawLine(const Eigen::Vector2d& a_m, const Eigen::Vector2d& b_m, const Colour& colour,
                double width);

  /** A disc with a rim of paper. */
  void drawMark(const Eigen::Vector2d& p_m, const Colour& colour);

  const Frame& frame() const { return frame_; }
  double pixel_m() const { return pixel_m_; }

  /** Pixels of a line that is `width` hairlines wide. */
  int strokes(double width) const;

  cv::Mat& image() { return image_; }

 private:
  cv::Point pixel(const Eigen::Vector2d& p_m, int parts = 1) const;

  Frame frame_;
  double pixel_m_;
  double hairline_px_;
  cv::Mat image_;
};

/** 1, 2 or 5 times a power of ten, at most x. */
double roundLength(double x);

namespace ink
{
const MapSheet::Colour kPaper(255, 255, 255);
const MapSheet::Colour kGrid(240, 238, 236);
const MapSheet::Colour kText(60, 50, 45);
}  // namespace ink
}  // namespace psmks
