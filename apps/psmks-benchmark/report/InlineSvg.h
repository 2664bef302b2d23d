/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <string>

namespace psmks
{
/** What of an SVG document by gnuplot may stand inside a page beside others: without document head,
 * names and definitions, which would clash. Lines, areas and texts stay; point symbols are lost.
 *  @param title for those who cannot see it */
std::string inlineSvg(const std::string& document, const std::string& title);
}  // namespace psmks
