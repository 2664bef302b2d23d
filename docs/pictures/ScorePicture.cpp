/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <docs/pictures/Pictures.h>
#include <psmks/eval/Gnuplot.h>
#include <psmks/features/FreeSpaceScore.h>
#include <psmks/features/ScanFeatures.h>

#include <sstream>

namespace psmks
{
namespace
{
constexpr double kReach_m = 1.5, kStep_m = 0.05;

/** Share of the rays of both scans that the other scan explains. */
double scoreAt(const ScanFeatures& reference, const ScanFeatures& current, const Pose2& T_ref_cur)
{
  const double sigma_m =
      std::max(reference.scan->shownRangeSigma_m(), current.scan->shownRangeSigma_m());
  RayCounts counts =
      countRays(current.points, reference.surface, T_ref_cur, surfaceTolerance_m(sigma_m));
  counts += countRays(reference.points, current.surface, T_ref_cur.inverse(),
                      surfaceTolerance_m(sigma_m));
  return freeSpaceScore(counts);
}

/** Lines "x y score" of a square about the result, at the heading of the result. */
std::string scoreBlock(const std::string& name, const ExamplePair& pair)
{
  ScanFeatures reference, current;
  reference.build(pair.reference);
  current.build(pair.current);
  const int steps = static_cast<int>(std::lround(kReach_m / kStep_m));
  std::ostringstream out;
  out << '$' << name << " << end_of_data\n";
  for (int row = -steps; row <= steps; ++row)
  {
    for (int column = -steps; column <= steps; ++column)
    {
      Pose2 T_ref_cur = pair.result.T_ref_cur;
      T_ref_cur.x_m += column * kStep_m;
      T_ref_cur.y_m += row * kStep_m;
      out << T_ref_cur.x_m << ' ' << T_ref_cur.y_m << ' ' << scoreAt(reference, current, T_ref_cur)
          << '\n';
    }
    out << '\n';
  }
  out << "end_of_data\n";
  return out.str();
}

std::string panel(const std::string& name, const std::string& title, const ExamplePair& pair)
{
  const Pose2& result = pair.result.T_ref_cur;
  const Pose2& guess = pair.guess.T_ref_cur;
  std::ostringstream out;
  out << "set title " << gnuplotString(title) << "\nset xrange [" << result.x_m - kReach_m << ':'
      << result.x_m + kReach_m << "]\nset yrange [" << result.y_m - kReach_m << ':'
      << result.y_m + kReach_m << "]\n$result << end_of_data\n"
      << result.x_m << ' ' << result.y_m << "\nend_of_data\n$guess << end_of_data\n"
      << guess.x_m << ' ' << guess.y_m << "\nend_of_data\nplot $" << name
      << " with image notitle, $guess with points pointtype 4 pointsize 2 linewidth 3 "
         "linecolor rgb 'white' title 'guess', $result with points pointtype 6 pointsize 2 "
         "linewidth 3 linecolor rgb '#d55e00' title 'result'\n";
  return out.str();
}
}  // namespace

std::string drawScores(const ExamplePair& fixed, const ExamplePair& open, const std::string& path)
{
  const std::string look =
      "set encoding utf8\nset terminal pngcairo noenhanced size 1400,640 font 'DejaVu Sans,14' "
      "background '#ffffff'\nset output " +
      gnuplotString(path) +
      "\nset size ratio -1\nset xlabel 'x of the current scanner, m'\n"
      "set ylabel 'y of the current scanner, m'\nset cblabel 'share of the rays explained'\n"
      "set cbrange [0:1]\nset palette defined (0 '#440154', 1 '#3b528b', 2 '#21918c', 3 '#5ec962', "
      "4 '#fde725')\nset key bmargin center horizontal textcolor rgb 'black' opaque fillcolor rgb "
      "'#a0a0a0'\n";
  return runGnuplot(
             look + scoreBlock("fixed", fixed) + scoreBlock("open", open) +
             "set multiplot layout 1,2\n" +
             panel("fixed",
                   "Walls in all directions: " + std::string(toString(fixed.result.status)),
                   fixed) +
             panel("open", "A bare corridor: " + std::string(toString(open.result.status)), open) +
             "unset multiplot\nunset output\n")
      .failure;
}
}  // namespace psmks
