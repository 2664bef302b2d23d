/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/eval/HtmlText.h>
#include <psmks/eval/Table.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>

namespace psmks
{
namespace
{
constexpr int kCsvDigits = 7;

std::string shownText(const Table::Cell& cell, int decimals)
{
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  const double value = std::get<double>(cell);
  if (std::isnan(value)) return "-";
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << std::fixed << std::setprecision(decimals) << value;
  return out.str();
}

bool hasValue(const Table::Cell& cell)
{
  return std::holds_alternative<std::string>(cell) || !std::isnan(std::get<double>(cell));
}

/** The table without the columns that have no value in any row. */
Table withoutEmptyColumns(Table table)
{
  for (std::size_t c = table.columns.size(); c-- > 0;)
  {
    const auto hasValueHere = [c](const auto& row) { return hasValue(row[c]); };
    if (table.rows.empty() || std::any_of(table.rows.begin(), table.rows.end(), hasValueHere))
      continue;
    const auto place = static_cast<std::ptrdiff_t>(c);
    table.columns.erase(table.columns.begin() + place);
    for (auto& row : table.rows) row.erase(row.begin() + place);
  }
  return table;
}

/** The headings and the rows as texts. */
std::vector<std::vector<std::string>> shownLines(const Table& table)
{
  std::vector<std::vector<std::string>> lines(1);
  for (const auto& column : table.columns) lines.front().push_back(column.heading);
  for (const auto& row : table.rows)
  {
    lines.emplace_back();
    for (std::size_t c = 0; c < row.size(); ++c)
      lines.back().push_back(shownText(row[c], table.columns[c].decimals));
  }
  return lines;
}

bool isNumeric(const Table& table, std::size_t column)
{
  return !table.rows.empty() && std::holds_alternative<double>(table.rows.front()[column]);
}

std::vector<std::size_t> widths(const std::vector<std::vector<std::string>>& lines)
{
  std::vector<std::size_t> result(lines.front().size(), 0);
  for (const auto& line : lines)
    for (std::size_t c = 0; c < line.size(); ++c) result[c] = std::max(result[c], line[c].size());
  return result;
}

std::string csvRow(const std::vector<Table::Cell>& row)
{
  std::string text;
  for (const auto& cell : row)
  {
    const auto* word = std::get_if<std::string>(&cell);
    text += ',' + (word ? *word : csvNumber(std::get<double>(cell)));
  }
  return text;
}
}  // namespace

std::string toText(const Table& whole)
{
  const Table table = withoutEmptyColumns(whole);
  const auto lines = shownLines(table);
  const auto width = widths(lines);
  std::ostringstream out;
  if (!table.title.empty()) out << table.title << '\n';
  for (const auto& line : lines)
  {
    for (std::size_t c = 0; c < line.size(); ++c)
      out << (c == 0 ? "" : "  ") << (isNumeric(table, c) ? std::right : std::left)
          << std::setw(static_cast<int>(width[c])) << line[c];
    out << '\n';
  }
  return out.str();
}

std::string toMarkdown(const Table& whole)
{
  const Table table = withoutEmptyColumns(whole);
  const auto lines = shownLines(table);
  std::ostringstream out;
  for (std::size_t l = 0; l < lines.size(); ++l)
  {
    for (const auto& text : lines[l]) out << "| " << text << ' ';
    out << "|\n";
    if (l > 0) continue;
    for (std::size_t c = 0; c < table.columns.size(); ++c)
      out << (isNumeric(table, c) ? "|---:" : "|---");
    out << "|\n";
  }
  return out.str();
}

std::string toHtml(const Table& whole)
{
  const Table table = withoutEmptyColumns(whole);
  const auto lines = shownLines(table);
  std::string html = "<table>\n<caption>" + htmlText(table.title) + "</caption>\n";
  for (std::size_t l = 0; l < lines.size(); ++l)
  {
    const std::string cell = l == 0 ? "th" : "td";
    html += "<tr>";
    for (std::size_t c = 0; c < lines[l].size(); ++c)
      html += '<' + cell + (isNumeric(table, c) ? " class=\"number\">" : ">") +
              htmlText(lines[l][c]) + "</" + cell + '>';
    html += "</tr>\n";
  }
  return html + "</table>\n";
}

std::string toCsv(const std::vector<Table>& tables)
{
  std::string text = "table";
  for (const auto& column : tables.front().columns) text += ',' + column.key;
  text += '\n';
  for (const auto& table : tables)
    for (const auto& row : table.rows) text += table.title + csvRow(row) + '\n';
  return text;
}

std::string csvNumber(double value)
{
  if (std::isnan(value)) return "";
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << std::setprecision(kCsvDigits) << value;
  return out.str();
}
}  // namespace psmks
