/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-evaluate/Comparison.h>
#include <apps/psmks-evaluate/ErrorFigure.h>
#include <apps/psmks-evaluate/ErrorTables.h>
#include <apps/psmks-evaluate/Evaluate.h>
#include <apps/support/ExitCode.h>
#include <apps/support/GroundTruth.h>
#include <apps/support/ReplacedFile.h>
#include <apps/support/TextFile.h>
#include <apps/support/UnitHints.h>
#include <psmks/eval/PathErrors.h>

#include <iomanip>
#include <iostream>

namespace psmks
{
namespace
{
/** What the estimates are compared with: a ground truth, relations, or both. */
struct Truth
{
  std::optional<Trajectory> trajectory;
  std::vector<Relation> relations;
};

Truth readTruth(const CommandLine& c)
{
  Truth truth;
  if (!c.groundTruth.empty()) truth.trajectory = readGroundTruth(c.groundTruth);
  if (!c.relations.empty()) truth.relations = readTrueRelations(c.relations);
  return truth;
}

std::vector<Comparison> compare(const CommandLine& c, const Truth& truth)
{
  const auto names = namesOf(c.estimates);
  std::vector<Comparison> comparisons;
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    const std::string& path = c.estimates[i];
    Comparison comparison{names[i], readEstimate(path), {}, {}};
    const Trajectory& estimate = comparison.estimate;
    if (truth.trajectory)
      comparison.common = requireCommonPoses(path, estimate, *truth.trajectory, c.skippedPoses);
    for (const std::string& hint : unitHints(comparison.common))
      std::cerr << "psmks-evaluate: '" << path << "': " << hint << '\n';
    if (!truth.relations.empty())
      comparison.relations = requireRelationErrors(path, estimate, truth.relations);
    comparisons.push_back(std::move(comparison));
  }
  return comparisons;
}

/** Prints how much of the input could be compared. */
void printCoverage(std::ostream& out, const std::vector<Comparison>& comparisons,
                   const Truth& truth)
{
  out << std::fixed << std::setprecision(1);
  for (const auto& [name, estimate, common, relations] : comparisons)
  {
    out << name << ": " << estimate.size() << " poses";
    if (truth.trajectory)
      out << ", " << common.size() << " with a true one, along " << truePathLengths_m(common).back()
          << " m";
    if (!truth.relations.empty())
      out << ", " << relations.size() << " of " << truth.relations.size() << " relations";
    out << '\n';
  }
}

/** Draws beside the place of the picture.
 *  @throws ProgramError that says why it cannot be drawn */
void draw(const std::string& path, const std::vector<Comparison>& comparisons, const Truth& truth)
{
  std::string reason;
  ReplacedFile file(path);
  const Figure figure = errorFigure(comparisons, truth.trajectory);
  if (!save(figure, file.beside(), &reason))
  {
    const auto at = reason.find(file.beside());
    if (at != std::string::npos) reason.replace(at, file.beside().size(), path);
    throw ProgramError(kOutputFailed, reason);
  }
  requireWritten(file.moveIntoPlace(), path);
}
}  // namespace

void evaluate(CommandLine& commandLine)
{
  const Truth truth = readTruth(commandLine);
  const auto comparisons = compare(commandLine, truth);
  const auto tables = errorTables(comparisons, commandLine);
  printCoverage(std::cout, comparisons, truth);
  for (const Table& table : tables) std::cout << '\n' << toText(table);
  if (!commandLine.plot.empty()) draw(commandLine.plot, comparisons, truth);
  commandLine.files.save(tables);
}
}  // namespace psmks
