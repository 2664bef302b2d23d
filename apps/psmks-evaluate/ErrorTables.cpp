/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-evaluate/ErrorTables.h>
#include <psmks/eval/ErrorStatistics.h>
#include <psmks/eval/PathErrors.h>
#include <psmks/eval/RelationStatistics.h>
#include <psmks/geometry/Angle.h>

#include <functional>
#include <limits>
#include <sstream>

namespace psmks
{
namespace
{
constexpr int kDecimals_m = 4, kDecimals_deg = 3, kDecimals_m2 = 4;
constexpr double kPercent = 100;

/** Computes the errors of one estimate by one measure. */
using Measure = std::function<std::vector<PairError>(const Comparison&)>;

std::string numberText(double number)
{
  std::ostringstream text;
  text << number;
  return text.str();
}

void addColumns(std::vector<Table::Column>& columns, const std::string& unit,
                const std::string& key, int decimals)
{
  columns.push_back({"mean " + unit, "mean_" + key, decimals});
  for (const char* name : {"std", "rms", "median"})
    columns.push_back({name, std::string(name) + '_' + key, decimals});
  columns.push_back({"95 %", "p95_" + key, decimals});
  columns.push_back({"max", "max_" + key, decimals});
}

std::vector<Table::Column> columnsFor(const PairError& limit)
{
  std::vector<Table::Column> columns{{"estimate", "estimate", 0},
                                     {"n", "count", 0},
                                     {"% < " + numberText(limit.translation_m) + " m, " +
                                          numberText(radToDeg(limit.rotation_rad)) + " deg",
                                      "within_percent", 1}};
  addColumns(columns, "m", "m", kDecimals_m);
  addColumns(columns, "deg", "deg", kDecimals_deg);
  columns.push_back({"mean m^2", "mean_squared_m2", kDecimals_m2});
  columns.push_back({"std", "std_squared_m2", kDecimals_m2});
  return columns;
}

void addCells(std::vector<Table::Cell>& row, const ErrorStatistics& s, double unit)
{
  for (const double value : {s.mean, s.std, s.rms, s.median, s.p95, s.max})
    row.emplace_back(unit * value);
}

/** Whether a table has columns of squared errors. They are published for relations only. */
enum class Squares
{
  Given,
  Empty
};

std::vector<Table::Cell> rowOf(const std::string& name, const PairErrorStatistics& s,
                               Squares squares)
{
  std::vector<Table::Cell> row{name, static_cast<double>(s.count), kPercent * s.withinLimit};
  addCells(row, s.translation_m, 1);
  addCells(row, s.rotation_rad, radToDeg(1));
  const ErrorStatistics squared_m2 =
      squares == Squares::Given ? s.squaredTranslation_m2 : ErrorStatistics();
  row.emplace_back(squared_m2.mean);
  row.emplace_back(squared_m2.std);
  return row;
}

/** Makes the tables of some estimates, one for each measure. */
class TablesOf
{
 public:
  TablesOf(const std::vector<Comparison>& comparisons, const PairError& limit, Squares squares)
      : comparisons_(comparisons), limit_(limit), squares_(squares)
  {
  }

  void add(const std::string& title, const Measure& measure)
  {
    Table table{title, columnsFor(limit_), {}};
    for (const Comparison& c : comparisons_)
      table.rows.push_back(rowOf(c.name, errorStatistics(measure(c), limit_), squares_));
    tables.push_back(table);
  }

  std::vector<Table> tables;

 private:
  const std::vector<Comparison>& comparisons_;
  PairError limit_;
  Squares squares_;
};

Measure relationsSpanning(double min_s, double end_s)
{
  return [=](const Comparison& comparison)
  { return errorsSpanning(comparison.relations, min_s, end_s); };
}

std::vector<Table> poseTables(const std::vector<Comparison>& comparisons, const CommandLine& c)
{
  TablesOf of(comparisons, c.limit, Squares::Empty);
  of.add("poses, first laid over", [](const Comparison& comparison)
         { return absoluteErrors(comparison.common, alignAtFirstPose(comparison.common)); });
  of.add("poses, aligned", [](const Comparison& comparison)
         { return absoluteErrors(comparison.common, align(comparison.common)); });
  of.add("steps", [](const Comparison& comparison) { return stepErrors(comparison.common); });
  for (const double length_m : c.driftLengths_m)
    of.add("over " + numberText(length_m) + " m", [length_m](const Comparison& comparison)
           { return driftErrors(comparison.common, length_m); });
  return of.tables;
}

std::vector<Table> relationTables(const std::vector<Comparison>& comparisons, const CommandLine& c)
{
  constexpr double kForever_s = std::numeric_limits<double>::infinity();
  const std::string span = numberText(c.shortSpan_s) + " s";
  TablesOf of(comparisons, c.limit, Squares::Given);
  of.add("relations", relationsSpanning(0, kForever_s));
  of.add("relations < " + span, relationsSpanning(0, c.shortSpan_s));
  of.add("relations >= " + span, relationsSpanning(c.shortSpan_s, kForever_s));
  return of.tables;
}
}  // namespace

std::vector<Table> errorTables(const std::vector<Comparison>& comparisons,
                               const CommandLine& commandLine)
{
  std::vector<Table> tables;
  if (!commandLine.groundTruth.empty()) tables = poseTables(comparisons, commandLine);
  if (commandLine.relations.empty()) return tables;
  const auto ofRelations = relationTables(comparisons, commandLine);
  tables.insert(tables.end(), ofRelations.begin(), ofRelations.end());
  return tables;
}
}  // namespace psmks
