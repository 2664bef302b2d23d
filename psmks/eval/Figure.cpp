/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/eval/Figure.h>
#include <psmks/eval/Gnuplot.h>
#include <psmks/eval/GnuplotCommands.h>

#include <algorithm>
#include <fstream>

namespace psmks
{
namespace
{
constexpr int kChartWidth_px = 1000, kChartHeight_px = 700;

bool endsIn(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

const char* const kLook =
    "set key bmargin center horizontal Left reverse samplen 2 height 1 width -1\n"
    "set grid linetype 1 linewidth 1 linecolor rgb '#e0e0e0'\n"
    "set tics nomirror\n"
    "set border 3\n";

int columnsOf(const Figure& figure)
{
  return std::clamp(figure.columns, 1, std::max(static_cast<int>(figure.panels.size()), 1));
}

int rowsOf(const Figure& figure)
{
  const int panels = static_cast<int>(figure.panels.size()), columns = columnsOf(figure);
  return std::max((panels + columns - 1) / columns, 1);
}

/** The gnuplot command that selects the kind of picture.
 *  @param kind "svg" or "pngcairo" */
std::string terminal(const std::string& kind, const Figure& figure)
{
  return "set encoding utf8\nset terminal " + kind + " noenhanced size " +
         std::to_string(columnsOf(figure) * figure.panelWidth_px) + ',' +
         std::to_string(rowsOf(figure) * figure.panelHeight_px) +
         " font 'DejaVu Sans,14' background '#ffffff'\n";
}

std::string drawing(const Figure& figure)
{
  std::string script = std::string(kLook) + "set multiplot layout " +
                       std::to_string(rowsOf(figure)) + ',' + std::to_string(columnsOf(figure));
  if (!figure.title.empty()) script += " title " + gnuplotString(figure.title);
  script += '\n';
  for (const Panel& panel : figure.panels)
    script += std::visit([](const auto& content) { return gnuplotCommands(content); }, panel);
  return script + "unset multiplot\nunset output\n";
}
}  // namespace

bool save(const Figure& figure, const std::string& path, std::string* reason)
{
  const GnuplotRun run =
      runGnuplot(terminal(endsIn(path, ".svg") ? "svg" : "pngcairo", figure) + drawing(figure));
  std::string failure = run.failure;
  std::ofstream file;
  if (failure.empty()) file.open(path, std::ios::binary);
  file << run.output;
  file.close();
  if (failure.empty() && file.fail()) failure = "cannot be written";
  if (reason) *reason = failure.empty() ? "" : path + ": " + failure;
  return failure.empty();
}

std::string svgText(const Figure& figure, std::string* reason)
{
  const GnuplotRun run = runGnuplot(terminal("svg", figure) + drawing(figure));
  if (reason) *reason = run.failure;
  return run.output;
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
