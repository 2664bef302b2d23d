/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <fcntl.h>
#include <psmks/eval/Gnuplot.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <iomanip>
#include <locale>
#include <memory>
#include <sstream>

namespace psmks
{
namespace
{
constexpr int kDigits = 7;

// Okabe and Ito: told apart by colour-blind readers, too.
constexpr std::array<unsigned, 7> kPalette{0x0072B2, 0xD55E00, 0x009E73, 0xCC79A7,
                                           0xE69F00, 0x56B4E9, 0x000000};

const char* const kMap =
    "set size ratio -1\nset offsets graph 0.03, graph 0.03, graph 0.03, graph 0.03\n";
const char* const kGraph = "set size noratio\nset offsets 0, 0, 0, 0\n";

bool isDrawn(const ChartSeries& series)
{
  return std::any_of(series.points.begin(), series.points.end(),
                     [](const Eigen::Vector2d& p) { return p.allFinite(); });
}

std::ostringstream numberStream()
{
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << std::setprecision(kDigits);
  return out;
}

/** Inline data; an empty line breaks the curve. */
std::string dataBlock(const std::string& name, const std::vector<Eigen::Vector2d>& points)
{
  std::ostringstream out = numberStream();
  out << name << " << end_of_data\n";
  for (const Eigen::Vector2d& p : points)
  {
    if (p.allFinite()) out << p.x() << ' ' << p.y();
    out << '\n';
  }
  out << "end_of_data\n";
  return out.str();
}

std::string rangeText(const ChartRange& range)
{
  std::ostringstream out = numberStream();
  const auto write = [&out](double end) { std::isnan(end) ? out << '*' : out << end; };
  out << '[';
  write(range.min);
  out << ':';
  write(range.max);
  out << "]\n";
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

std::string plotCommand(const std::vector<ChartSeries>& series)
{
  std::string blocks, plots;
  std::size_t painted = 0;
  for (const ChartSeries& s : series)
  {
    if (!isDrawn(s)) continue;
    const std::string block = "$series" + std::to_string(&s - series.data());
    blocks += dataBlock(block, s.points);
    plots += (plots.empty() ? "plot " : ", ") + block + " using 1:2 with " + styleText(s.style) +
             colorText(s.rgb ? *s.rgb : kPalette[painted++ % kPalette.size()]) +
             (s.name.empty() ? " notitle" : " title " + gnuplotString(s.name));
  }
  if (plots.empty()) return "set xrange [0:1]\nset yrange [0:1]\nplot NaN notitle\n";
  return blocks + plots + '\n';
}

// ---- the program
// ----------------------------------------------------------------------------------

using File = std::unique_ptr<FILE, int (*)(FILE*)>;

/** A nameless file that vanishes when it is closed. */
File temporaryFile() { return {std::tmpfile(), std::fclose}; }

/** What gnuplot calls an error stands behind the number of its line: "line 3: unknown command". */
std::string firstComplaint(FILE* file)
{
  std::rewind(file);
  std::array<char, 1024> buffer{};
  while (std::fgets(buffer.data(), static_cast<int>(buffer.size()), file))
  {
    const std::string line = buffer.data();
    const std::size_t number = line.find("line "), colon = line.find(':', number);
    if (number == std::string::npos || colon == std::string::npos) continue;
    const std::size_t text = line.find_first_not_of(' ', colon + 1);
    if (text != std::string::npos) return line.substr(text, line.find('\n') - text);
  }
  return "no reason given";
}

/** Starts gnuplot; 0 or an error number. */
int start(FILE* script, FILE* complaints, pid_t& process)
{
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, fileno(script), STDIN_FILENO);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&files, fileno(complaints), STDERR_FILENO);
  std::string program = "gnuplot", settings = "--default-settings";
  std::array<char*, 3> arguments{program.data(), settings.data(), nullptr};
  const int error =
      posix_spawnp(&process, program.c_str(), &files, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  return error;
}
}  // namespace

std::string gnuplotString(const std::string& text)
{
  std::string quoted = "'";
  for (const char c : text)
  {
    quoted += std::iscntrl(static_cast<unsigned char>(c)) ? ' ' : c;
    if (c == '\'') quoted += c;
  }
  return quoted + '\'';
}

std::string gnuplotCommands(const Chart& chart)
{
  return "set title " + gnuplotString(chart.title) + "\nset xlabel " + gnuplotString(chart.xLabel) +
         "\nset ylabel " + gnuplotString(chart.yLabel) + "\nset xrange " + rangeText(chart.xRange) +
         "set yrange " + rangeText(chart.yRange) + (chart.equalAspect ? kMap : kGraph) +
         plotCommand(chart.series);
}

std::string runGnuplot(const std::string& script)
{
  const File input = temporaryFile(), complaints = temporaryFile();
  if (!input || !complaints) return "no temporary file can be made";
  std::fwrite(script.data(), 1, script.size(), input.get());
  std::rewind(input.get());

  pid_t process = 0;
  if (const int error = start(input.get(), complaints.get(), process))
    return std::string("gnuplot cannot be run: ") + std::strerror(error);
  int status = 0;
  waitpid(process, &status, 0);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return "";
  return "gnuplot failed: " + firstComplaint(complaints.get());
}
}  // namespace psmks
