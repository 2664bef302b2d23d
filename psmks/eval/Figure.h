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

/** Charts and heat maps in one picture, row by row. */
struct Figure
{
  std::string title;  //!< above all panels; empty = none
  std::vector<Panel> panels;
  int columns = 2;
  int panelWidth_px = 700, panelHeight_px = 600;
};

/** Draws a picture with gnuplot, which must be installed. The format is SVG if the path ends in
 * `.svg`, else PNG. An existing file is replaced.
 *  @param[out] reason one sentence that says why it failed; may be null
 *  @return false if no picture was written */
bool save(const Figure& figure, const std::string& path, std::string* reason = nullptr);

/** Draws the figure as an SVG document with gnuplot.
 *  @param[out] reason one sentence that says why it failed; may be null
 *  @return the document; empty if it cannot be drawn */
std::string svgText(const Figure& figure, std::string* reason = nullptr);
}  // namespace psmks
