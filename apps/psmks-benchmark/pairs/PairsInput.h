/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/PairsFile.h>
#include <psmks/sim/PairFamily.h>

#include <optional>
#include <string>
#include <vector>

namespace psmks
{
/** Scan pairs to match, from a file or generated. */
struct PairsInput
{
  std::string title;  //!< the file's name without folder and extensions, or that of the set
  PairsHeader header;
  std::vector<ScanPair> pairs;
  RangeNoise rangeNoise{0.01};
  bool hasMovingObjects = false;
  bool isDamaged = false;  //!< a file that was missing or broken; the pairs before are there
};

/** How many pairs of a set, and which. */
struct PairsChoice
{
  unsigned seed = 1;    //!< of generated sets
  int generated = 200;  //!< pairs in each
  int read = 0;         //!< of each file at most; 0 = all
};

/** True where an argument of the command line means a set to be generated: it is the name of one,
 * and no file. */
bool isGenerated(const std::string& argument);

/** True where an argument can only have been meant as the name of a set: it looks like no path. */
bool looksLikeASet(const std::string& argument);

/** One line a set: its name and what it holds. */
std::string listOfSets();

/** The pairs that an argument of the command line means. A file may say by its name that it holds a
 * set saved by savePairs(): noise and moving objects are then those of the set. What is wrong with
 * a file, or that there is no pair, is said on stderr. */
PairsInput inputPairs(const std::string& argument, const PairsChoice& choice);

/** Writes FOLDER/TITLE.pairs.gz.
 *  @throws PairsFileError where it exists already or cannot be written */
void savePairs(const std::string& folder, const PairsInput& input);
}  // namespace psmks
