/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/Chart.h>
#include <psmks/eval/HeatMap.h>

#include <string>
#include <variant>
#include <vector>

namespace psmks
{
using Panel = std::variant<Chart, HeatMap>;

/** Charts and maps side by side in one picture, row by row. */
struct Figure
{
  std::string title;  //!< above all; empty = none
  std::vector<Panel> panels;
  int columns = 2;
  int panelWidth_px = 700, panelHeight_px = 600;
};

/** Draws with gnuplot, which must be installed: PNG, or SVG where the path ends in `.svg`. An
 * existing file is replaced.
 *  @param[out] reason why it failed, one sentence; may be null
 *  @return false where no picture was written */
bool save(const Figure& figure, const std::string& path, std::string* reason = nullptr);

/** The figure as an SVG document, drawn with gnuplot.
 *  @param[out] reason why there is none, one sentence; may be null
 *  @return empty where it cannot be drawn */
std::string svgText(const Figure& figure, std::string* reason = nullptr);
}  // namespace psmks
