/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-evaluate/Comparison.h>
#include <psmks/eval/Figure.h>
#include <psmks/eval/Trajectory.h>

#include <optional>
#include <vector>

namespace psmks
{
/** A figure of the paths, and of the errors along them or over the spans of the relations. */
Figure errorFigure(const std::vector<Comparison>& comparisons,
                   const std::optional<Trajectory>& truth);
}  // namespace psmks
