/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <string>

namespace psmks
{
/** Escapes a text for the content of elements and for quoted attributes, so that nothing in it is
 * markup. */
std::string htmlText(const std::string& text);
}  // namespace psmks
