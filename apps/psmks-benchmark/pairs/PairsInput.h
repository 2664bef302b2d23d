/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/PairsFile.h>
#include <psmks/sim/PairFamily.h>

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

namespace psmks
{
/** Scan pairs to match, read from a file or generated. */
struct PairsInput
{
  std::string title;  //!< name of the file without folder and extensions, or of the set
  PairsHeader header;
  std::vector<ScanPair> pairs;
  RangeNoise rangeNoise{0.01};
  bool hasMovingObjects = false;
  bool isDamaged = false;  //!< whether the file was missing or damaged
};

/** The number of pairs of a set, and the seed. */
struct PairsChoice
{
  unsigned seed = 1;    //!< seed of generated sets
  int generated = 200;  //!< number of pairs in a generated set
  int read = 0;         //!< largest number of pairs from a file; 0 = all
};

/** Adds --seed, --pairs and --max-pairs. */
void addChoiceFlags(CLI::App& app, PairsChoice& choice);

/** Whether an argument of the command line means a set to be generated: it is the name of a set,
 * and there is no such file. */
bool isGenerated(const std::string& argument);

/** Whether an argument can only be meant as the name of a set, for it does not look like a path. */
bool looksLikeASet(const std::string& argument);

/** A list of the sets with a line for each: its name and its description. */
std::string listOfSets();

/** The pairs that an argument of the command line means. If the name of a file is that of a set
 * saved by savePairs(), its noise and its moving objects are those of the set. Damage of a file,
 * and that there are no pairs, is reported on stderr. */
PairsInput inputPairs(const std::string& argument, const PairsChoice& choice);

/** Writes the pairs to FOLDER/TITLE.pairs.gz.
 *  @throws PairsFileError if this file exists or cannot be written */
void savePairs(const std::string& folder, const PairsInput& input);
}  // namespace psmks
