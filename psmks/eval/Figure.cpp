/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/eval/Figure.h>
#include <psmks/eval/Gnuplot.h>

#include <algorithm>

namespace psmks
{
namespace
{
constexpr int kChartWidth_px = 1000, kChartHeight_px = 700;

bool endsIn(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

std::string terminal(const std::string& path, int width_px, int height_px)
{
  const bool svg = endsIn(path, ".svg");
  return std::string("set encoding utf8\nset terminal ") + (svg ? "svg" : "pngcairo") +
         " noenhanced size " + std::to_string(width_px) + ',' + std::to_string(height_px) +
         " font 'DejaVu Sans,14' background '#ffffff'\nset output " + gnuplotString(path) + '\n';
}

const char* const kLook =
    "set key bmargin center horizontal Left reverse samplen 2 height 1 width -1\n"
    "set grid linetype 1 linewidth 1 linecolor rgb '#e0e0e0'\n"
    "set tics nomirror\n"
    "set border 3\n";
}  // namespace

bool save(const Figure& figure, const std::string& path, std::string* reason)
{
  const int panels = static_cast<int>(figure.panels.size());
  const int columns = std::clamp(figure.columns, 1, std::max(panels, 1));
  const int rows = std::max((panels + columns - 1) / columns, 1);
  std::string script =
      terminal(path, columns * figure.panelWidth_px, rows * figure.panelHeight_px) + kLook +
      "set multiplot layout " + std::to_string(rows) + ',' + std::to_string(columns);
  if (!figure.title.empty()) script += " title " + gnuplotString(figure.title);
  script += '\n';
  for (const Chart& chart : figure.panels) script += gnuplotCommands(chart);
  script += "unset multiplot\nunset output\n";

  const std::string failure = runGnuplot(script);
  if (reason) *reason = failure.empty() ? "" : path + ": " + failure;
  return failure.empty();
}

bool save(const Chart& chart, const std::string& path, std::string* reason)
{
  Figure figure;
  figure.panels = {chart};
  figure.panelWidth_px = kChartWidth_px;
  figure.panelHeight_px = kChartHeight_px;
  return save(figure, path, reason);
}
}  // namespace psmks
