/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <string>

namespace psmks
{
/** The part of an SVG document by gnuplot that can be embedded in a page together with others. The
 * head of the document, names and definitions are removed, for they would clash. Lines, areas and
 * texts remain; point symbols are lost.
 *  @param title description for readers who cannot see the picture */
std::string inlineSvg(const std::string& document, const std::string& title);
}  // namespace psmks
