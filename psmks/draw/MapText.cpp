/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/draw/MapSheet.h>
#include <psmks/draw/MapText.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <opencv2/imgproc.hpp>
#ifdef PSMKS_WITH_FREETYPE
#include <opencv2/freetype.hpp>
#endif

namespace psmks
{
namespace
{
constexpr int kStrokes = cv::FONT_HERSHEY_SIMPLEX;
constexpr double kStrokesHeight_px = 22;  // height of a capital letter at scale 1

double strokesScale(int height_px) { return height_px / kStrokesHeight_px; }
int strokesWidth_px(int height_px) { return std::max(1, height_px / 10); }
}  // namespace

#ifdef PSMKS_WITH_FREETYPE
namespace
{
/** Where distributions install sans-serif fonts. */
constexpr const char* kFontFiles[] = {
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", "/usr/share/fonts/TTF/DejaVuSans.ttf",
    "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
    "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf",
    "/usr/share/fonts/truetype/freefont/FreeSans.ttf"};
}  // namespace

struct MapText::Font
{
  cv::Ptr<cv::freetype::FreeType2> letters;
  int height_px = 0;  //!< from the top of a capital to the end of a long letter below the line

  static std::unique_ptr<Font> load(int capital_px)
  {
    /** Height of a line over that of its capitals. Definition: that of DejaVu. */
    constexpr double kLinePerCapital = 1.37;
    for (const char* file : kFontFiles)
    {
      if (!std::filesystem::exists(file)) continue;
      auto font = std::make_unique<Font>();
      font->letters = cv::freetype::createFreeType2();
      font->letters->loadFontData(file, 0);
      font->height_px = static_cast<int>(std::lround(kLinePerCapital * capital_px));
      return font;
    }
    return nullptr;
  }

  cv::Size size(const std::string& text) const
  {
    int baseline = 0;
    return letters->getTextSize(text, height_px, cv::FILLED, &baseline);
  }

  void write(cv::Mat& image, const std::string& text, const cv::Point& leftBottom) const
  {
    letters->putText(image, text, leftBottom, height_px, ink::kText, cv::FILLED, cv::LINE_AA, true);
  }
};
#else
struct MapText::Font
{
  static std::unique_ptr<Font> load(int) { return nullptr; }
  cv::Size size(const std::string&) const { return {}; }
  void write(cv::Mat&, const std::string&, const cv::Point&) const {}
};
#endif

MapText::MapText(int height_px) : height_px_(height_px), font_(Font::load(height_px)) {}

MapText::~MapText() = default;

int MapText::width_px(const std::string& text) const
{
  if (font_) return font_->size(text).width;
  int baseline = 0;
  return cv::getTextSize(text, kStrokes, strokesScale(height_px_), strokesWidth_px(height_px_),
                         &baseline)
      .width;
}

void MapText::write(cv::Mat& image, const std::string& text, const cv::Point& leftMiddle) const
{
  const cv::Point leftBottom = leftMiddle + cv::Point(0, height_px_ / 2);
  if (font_) return font_->write(image, text, leftBottom);
  cv::putText(image, text, leftBottom, kStrokes, strokesScale(height_px_), ink::kText,
              strokesWidth_px(height_px_), cv::LINE_AA);
}
}  // namespace psmks
