/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <string>
#include <variant>
#include <vector>

namespace psmks
{
/** Results for people (text, Markdown) and for programs (CSV). */
struct Table
{
  struct Column
  {
    std::string heading;  //!< for people
    std::string key;      //!< for programs: no spaces, unit at the end
    int decimals = 0;     //!< of its numbers, for people
  };

  /** A NaN stands for a value that does not exist; it is shown as a dash and left empty in CSV.
   * Columns without any value are for programs only. */
  using Cell = std::variant<std::string, double>;

  std::string title;
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;  //!< each as long as columns
};

/** Aligned columns. */
std::string toText(const Table& table);

std::string toMarkdown(const Table& table);

/** A `table` element: the title as its caption, cells with numbers of class `number`. */
std::string toHtml(const Table& table);

/** Keys as header, then the rows of all tables, each after the title of its table; numbers with 7
 *  significant digits.
 *  @param tables at least one, all with the same columns */
std::string toCsv(const std::vector<Table>& tables);

/** A number with 7 significant digits, "" for NaN. */
std::string csvNumber(double value);
}  // namespace psmks
