/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/eval/Gnuplot.h>
#include <psmks/eval/GnuplotCommands.h>
#include <psmks/eval/RoundNumber.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>

namespace psmks
{
namespace
{
constexpr int kDigits = 7;

std::ostringstream numberStream()
{
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << std::setprecision(kDigits);
  return out;
}

std::string titleCommands(const std::string& title, const std::string& xLabel,
                          const std::string& yLabel)
{
  return "set title " + gnuplotString(title) + "\nset xlabel " + gnuplotString(xLabel) +
         "\nset ylabel " + gnuplotString(yLabel) + '\n';
}

// Charts

// The palette of Okabe and Ito, which colour-blind readers can tell apart.
constexpr std::array<unsigned, 7> kPalette{0x0072B2, 0xD55E00, 0x009E73, 0xCC79A7,
                                           0xE69F00, 0x56B4E9, 0x000000};

const char* const kEqualAspect =
    "set size ratio -1\nset offsets graph 0.03, graph 0.03, graph 0.03, graph 0.03\n";
const char* const kFreeAspect = "set size noratio\nset offsets 0, 0, 0, 0\n";

/** The commands for one axis.
 *  @param axis "x" or "y" */
std::string axisCommands(const std::string& axis, const ChartRange& range)
{
  std::ostringstream out = numberStream();
  const auto write = [&out](double end) { std::isnan(end) ? out << '*' : out << end; };
  out << (range.logarithmic ? "set" : "unset") << " logscale " << axis << "\nset " << axis
      << "tics autofreq\nset format " << axis << " '%g'\nset " << axis << "range [";
  write(range.min);
  out << ':';
  write(range.max);
  out << "]\n";
  return out.str();
}

bool isShown(const Eigen::Vector2d& p, const Chart& chart)
{
  return p.allFinite() && (!chart.xRange.logarithmic || p.x() > 0) &&
         (!chart.yRange.logarithmic || p.y() > 0);
}

bool isShown(const ChartSeries& series, const Chart& chart)
{
  return std::any_of(series.points.begin(), series.points.end(),
                     [&chart](const Eigen::Vector2d& p) { return isShown(p, chart); });
}

/** A series as inline data, in which an empty line interrupts the curve. */
std::string dataBlock(const std::string& name, const ChartSeries& series, const Chart& chart)
{
  std::ostringstream out = numberStream();
  out << name << " << end_of_data\n";
  for (const Eigen::Vector2d& p : series.points)
  {
    if (isShown(p, chart)) out << p.x() << ' ' << p.y();
    out << '\n';
  }
  out << "end_of_data\n";
  return out.str();
}

const char* styleText(ChartSeries::Style style)
{
  switch (style)
  {
    case ChartSeries::Style::ThinLine:
      return "lines linewidth 1";
    case ChartSeries::Style::DashedLine:
      return "lines linewidth 2 dashtype 2";
    case ChartSeries::Style::Points:
      return "points pointtype 7 pointsize 0.5";
    case ChartSeries::Style::Line:
      break;
  }
  return "lines linewidth 2";
}

std::string colorText(unsigned rgb)
{
  std::ostringstream out;
  out << " linecolor rgb '#" << std::hex << std::setw(6) << std::setfill('0') << rgb << '\'';
  return out.str();
}

/** A box around all points that are shown. */
Eigen::AlignedBox2d boundsOf(const Chart& chart)
{
  Eigen::AlignedBox2d bounds;
  for (const ChartSeries& series : chart.series)
    for (const Eigen::Vector2d& p : series.points)
      if (isShown(p, chart)) bounds.extend(p);
  return bounds;
}

/** The same distance of tics on both axes of a map, so that the shorter one has few of them and
 * their numbers do not touch. */
std::string equalTics(const Chart& chart)
{
  /** Least number of tics along the longer axis. Definition: the numbers fit side by side. */
  constexpr double kLeast = 4;
  const Eigen::AlignedBox2d bounds = boundsOf(chart);
  if (bounds.isEmpty() || !(bounds.sizes().maxCoeff() > 0)) return "";
  const double spacing = roundNumber(bounds.sizes().maxCoeff() / kLeast);
  std::ostringstream out = numberStream();
  out << "set xtics " << spacing << "\nset ytics " << spacing << '\n';
  return out.str();
}

/** The dashes of a curve whose colour was taken before: another pattern for each round of colours.
 */
std::string dashText(const ChartSeries& series, std::size_t painted)
{
  const std::size_t round = series.rgb ? 0 : painted / kPalette.size();
  if (round == 0 || series.style == ChartSeries::Style::Points) return "";
  return " dashtype " + std::to_string(round + 2);
}

std::string plotCommand(const Chart& chart)
{
  std::string blocks, plots;
  std::size_t painted = 0;
  for (const ChartSeries& s : chart.series)
  {
    if (!isShown(s, chart)) continue;
    const std::string block = "$series" + std::to_string(&s - chart.series.data());
    blocks += dataBlock(block, s, chart);
    plots += (plots.empty() ? "plot " : ", ") + block + " using 1:2 with " + styleText(s.style) +
             dashText(s, painted) +
             colorText(s.rgb ? *s.rgb : kPalette[painted % kPalette.size()]) +
             (s.name.empty() ? " notitle" : " title " + gnuplotString(s.name));
    if (!s.rgb) ++painted;
  }
  if (plots.empty()) return "set xrange [0.1:1]\nset yrange [0.1:1]\nplot NaN notitle\n";
  return blocks + plots + '\n';
}

// Heat maps

// The colour map Viridis. Its brightness increases monotonically, for grey prints and colour-blind
// readers.
const char* const kColours =
    "set palette defined (0 '#440154', 1 '#3b528b', 2 '#21918c', 3 '#5ec962', 4 '#fde725')\n";

constexpr double kBrightShare = 0.6;  // share of the colour range above which numbers are black

/** The two ends of the cell around centre i. */
std::pair<double, double> cellEnds(const std::vector<double>& centres, std::size_t i)
{
  if (centres.size() == 1) return {centres[0] - 0.5, centres[0] + 0.5};
  const double before = i > 0 ? centres[i] - centres[i - 1] : centres[1] - centres[0];
  const double after = i + 1 < centres.size() ? centres[i + 1] - centres[i] : before;
  return {centres[i] - before / 2, centres[i] + after / 2};
}

/** The commands for an axis with a tic at each centre and a frame that ends with the cells. */
std::string cellAxisCommands(const std::string& axis, const std::vector<double>& centres)
{
  std::ostringstream out = numberStream();
  out << "unset logscale " << axis << "\nset " << axis << "range [" << cellEnds(centres, 0).first
      << ':' << cellEnds(centres, centres.size() - 1).second << "]\nset format " << axis
      << " '%g'\nset " << axis << "tics (";
  for (std::size_t i = 0; i < centres.size(); ++i) out << (i > 0 ? ", " : "") << centres[i];
  out << ")\n";
  return out.str();
}

/** The cells as inline data, one on each line: centre, ends, value, colour of its number. */
std::string cellBlock(const HeatMap& map)
{
  const double bright = map.valueMin + kBrightShare * (map.valueMax - map.valueMin);
  std::ostringstream out = numberStream();
  out << "$cells << end_of_data\n";
  for (std::size_t r = 0; r < map.y.size(); ++r)
    for (std::size_t c = 0; c < map.x.size(); ++c)
    {
      const double value = map.value(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c));
      if (!std::isfinite(value)) continue;
      const auto [left, right] = cellEnds(map.x, c);
      const auto [bottom, top] = cellEnds(map.y, r);
      out << map.x[c] << ' ' << map.y[r] << ' ' << left << ' ' << right << ' ' << bottom << ' '
          << top << ' ' << value << (value < bright ? " 0xffffff\n" : " 0x000000\n");
    }
  out << "end_of_data\n";
  return out.str();
}
}  // namespace

std::string gnuplotCommands(const Chart& chart)
{
  return titleCommands(chart.title, chart.xLabel, chart.yLabel) + axisCommands("x", chart.xRange) +
         axisCommands("y", chart.yRange) +
         (chart.equalAspect ? kEqualAspect + equalTics(chart) : kFreeAspect) + plotCommand(chart);
}

std::string gnuplotCommands(const HeatMap& map)
{
  std::ostringstream out = numberStream();
  out << titleCommands(map.title, map.xLabel, map.yLabel) << cellAxisCommands("x", map.x)
      << cellAxisCommands("y", map.y) << kFreeAspect << kColours << "set cblabel "
      << gnuplotString(map.valueLabel) << "\nset cbrange [" << map.valueMin << ':' << map.valueMax
      << "]\n";
  if (!map.value.array().isFinite().any()) return out.str() + "plot NaN notitle\n";
  out << cellBlock(map)
      << "plot $cells using 1:2:3:4:5:6:7 with boxxyerror fillstyle solid fillcolor palette "
         "notitle, $cells using 1:2:(sprintf('%."
      << map.decimals << "f', $7)):8 with labels textcolor rgb variable notitle\n";
  return out.str();
}
}  // namespace psmks
