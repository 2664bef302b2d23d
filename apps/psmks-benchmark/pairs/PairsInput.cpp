/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/pairs/PairsInput.h>
#include <apps/psmks-benchmark/pairs/ScanPairs.h>
#include <apps/support/ReplacedFile.h>

#include <filesystem>
#include <iomanip>
#include <iostream>
#include <sstream>

namespace psmks
{
namespace
{
constexpr const char* kExtension = ".pairs";

void describe(PairsInput& input, const PairFamily& family)
{
  input.rangeNoise = family.equivalentWhiteNoise();
  input.hasMovingObjects = family.people > 0;
}

PairsInput generatedPairs(const PairFamily& family, unsigned seed, int count)
{
  PairsInput input;
  input.title = family.name;
  input.header = {family.laser.grid, family.laser.maxRange_m, count};
  describe(input, family);
  input.pairs = scanPairs(makePairSet(family, seed, count));
  return input;
}

/** Reads the pairs of a file.
 *  @param[out] input has the pairs before the damage if an exception is thrown
 *  @throws PairsFileError if the file cannot be read */
void readPairs(const std::string& path, int maxPairs, PairsInput& input)
{
  const std::string name = std::filesystem::path(path).filename().string();
  input.title = name.substr(0, name.find(kExtension));
  if (const PairFamily* family = findPairFamily(input.title)) describe(input, *family);
  PairsReader reader(path);
  input.header = reader.header();
  const auto wanted = static_cast<std::size_t>(maxPairs);
  for (ScanPair pair; (maxPairs == 0 || input.pairs.size() < wanted) && reader.read(pair);)
    input.pairs.push_back(pair);
}
/** A file of pairs states one grid for all scans. */
void requireOneGrid(const PairsInput& input)
{
  for (const ScanPair& pair : input.pairs)
    if (pair.reference.grid != input.header.grid || pair.current.grid != input.header.grid)
      throw PairsFileError(
          input.title +
          ": cannot be saved, for scans of a moving sensor have bearings of their own");
}
}  // namespace

void addChoiceFlags(CLI::App& app, PairsChoice& choice)
{
  app.add_option("--seed", choice.seed, "of generated sets")->capture_default_str();
  app.add_option("--pairs", choice.generated, "in each generated set")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--max-pairs", choice.read, "of each file; 0 = all")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
}

bool isGenerated(const std::string& argument)
{
  return findPairFamily(argument) != nullptr && !std::filesystem::exists(argument);
}

bool looksLikeASet(const std::string& argument)
{
  return argument.find_first_of("./\\") == std::string::npos && !std::filesystem::exists(argument);
}

std::string listOfSets()
{
  constexpr int kNameWidth = 16;
  std::ostringstream text;
  for (const PairFamily& family : pairFamilies())
    text << std::left << std::setw(kNameWidth) << family.name << family.description << '\n';
  return text.str();
}

PairsInput inputPairs(const std::string& argument, const PairsChoice& choice)
{
  PairsInput input;
  try
  {
    if (isGenerated(argument))
      input = generatedPairs(pairFamily(argument), choice.seed, choice.generated);
    else
      readPairs(argument, choice.read, input);
    if (input.pairs.empty()) std::cerr << "psmks-benchmark: " << argument << ": holds no pair\n";
  }
  catch (const PairsFileError& error)
  {
    input.isDamaged = true;
    std::cerr << "psmks-benchmark: " << error.what() << '\n';
  }
  return input;
}

void savePairs(const std::string& folder, const PairsInput& input)
{
  std::error_code ignored;  // if it cannot be created, writing to it fails
  std::filesystem::create_directories(folder, ignored);
  const std::string path =
      (std::filesystem::path(folder) / (input.title + kExtension + ".gz")).string();
  if (std::filesystem::exists(path)) throw PairsFileError(path + ": exists already");
  requireOneGrid(input);
  PairsHeader header = input.header;
  /** May be fewer than the header of the file announced. */
  header.pairs = static_cast<int>(input.pairs.size());
  const auto write = [&](const std::string& beside)
  {
    PairsWriter writer(beside, header);
    for (const ScanPair& pair : input.pairs) writer.write(pair);
    writer.close();
    return true;
  };
  if (!replaceFile(path, write)) throw PairsFileError(path + ": cannot be written");
}
}  // namespace psmks
