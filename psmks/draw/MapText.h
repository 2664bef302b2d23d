/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <memory>
#include <opencv2/core.hpp>
#include <string>

namespace psmks
{
/** Letters for pictures of maps: of the first usual sans-serif font that is installed, by FreeType,
 * or where there is none the strokes of OpenCV. */
class MapText
{
 public:
  /** @param height_px of a capital letter, about */
  explicit MapText(int height_px);
  ~MapText();
  MapText(const MapText&) = delete;
  MapText& operator=(const MapText&) = delete;

  int width_px(const std::string& text) const;

  /** Writes a text that begins at a point and is centred on it from top to bottom. */
  void write(cv::Mat& image, const std::string& text, const cv::Point& leftMiddle) const;

 private:
  struct Font;

  int height_px_;
  std::unique_ptr<Font> font_;  //!< null where the strokes of OpenCV serve
};
}  // namespace psmks
