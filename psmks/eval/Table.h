/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <string>
#include <variant>
#include <vector>

namespace psmks
{
/** A table of results that can be written for people (text, Markdown, HTML) and for programs (CSV).
 */
struct Table
{
  struct Column
  {
    std::string heading;  //!< shown to people
    std::string key;      //!< name in CSV: without spaces, with the unit at its end
    int decimals = 0;     //!< digits after the point of the numbers shown to people
  };

  /** A NaN stands for a value that does not exist. It is shown as a dash to people and left empty
   * in CSV. Columns without any value are left out for people. */
  using Cell = std::variant<std::string, double>;

  std::string title;
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;  //!< each as long as columns
};

/** The table as text with aligned columns. */
std::string toText(const Table& table);

/** The table in Markdown. */
std::string toMarkdown(const Table& table);

/** The table as an HTML element `table`, with the title as its caption. Cells with numbers have the
 * class `number`. */
std::string toHtml(const Table& table);

/** The tables as CSV: the keys as a header, then the rows of all tables, each row after the title
 * of its table. Numbers have 7 significant digits.
 *  @param tables at least one, all with the same columns */
std::string toCsv(const std::vector<Table>& tables);

/** A number with 7 significant digits; empty for NaN. */
std::string csvNumber(double value);
}  // namespace psmks
