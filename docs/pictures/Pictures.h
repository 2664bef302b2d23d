/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <docs/pictures/ExamplePair.h>
#include <psmks/eval/Figure.h>

#include <string>

/** \file
 * The pictures of the guide. Each shows one step of the method on real scans; only the bare
 * corridor of the scores is computed. The colours are those
 * of Okabe and Ito, which colour-blind readers tell apart. */

namespace psmks
{
constexpr unsigned kBlack = 0x000000, kGrey = 0xb0b0b0, kDarkGrey = 0x606060;
constexpr unsigned kBlue = 0x0072b2, kVermillion = 0xd55e00, kGreen = 0x009e73;

/** Rays and segments of a scan, and how well the line of each segment is known. */
Figure segmentFigure(const ExamplePair& pair);

/** The current scan seen from the viewpoint of the reference scan: what is hidden from there. */
Figure projectionFigure(const ExamplePair& pair);

/** The pairs of lines at the guess and at the result. */
Figure associationFigure(const ExamplePair& pair);

/** Draws the free-space score over the position of the current scan into a file: two heat maps, one
 * of a pair that fixes the position and one of a pair that leaves it open along a corridor.
 *  @return why it failed; empty where it did not */
std::string drawScores(const ExamplePair& fixed, const ExamplePair& open, const std::string& path);

/** Keyframes, the links between them, and the scans that they carry.
 *  @param log of a robot */
Figure mapFigure(const std::string& log);
}  // namespace psmks
