/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <string>

namespace psmks
{
/** A text in which nothing is markup, for elements and for quoted attributes. */
std::string htmlText(const std::string& text);
}  // namespace psmks
