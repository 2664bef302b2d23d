/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/support/Outputs.h>
#include <apps/support/ReplacedFile.h>
#include <apps/support/TableFiles.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

namespace psmks
{
namespace
{
using Json = nlohmann::ordered_json;

Json toJson(const Table::Cell& cell)
{
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  const double value = std::get<double>(cell);
  return std::isnan(value) ? Json() : Json(value);
}

Json toJson(const Table& table)
{
  Json rows = Json::array();
  for (const auto& row : table.rows)
  {
    Json fields;
    for (std::size_t c = 0; c < row.size(); ++c) fields[table.columns[c].key] = toJson(row[c]);
    rows.push_back(fields);
  }
  return {{"table", table.title}, {"rows", rows}};
}

Json toJson(const std::vector<Table>& tables, const TableOrigin* origin)
{
  Json document;
  if (origin)
    for (const auto& [key, value] : origin->fields) document[origin->key][key] = value;
  document["tables"] = Json::array();
  for (const auto& table : tables) document["tables"].push_back(toJson(table));
  return document;
}

/** Names of files need not be UTF-8. */
void writeJson(std::ostream& out, const std::vector<Table>& tables, const TableOrigin* origin)
{
  out << toJson(tables, origin).dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

void writeMarkdown(std::ostream& out, const std::vector<Table>& tables, const TableOrigin* origin)
{
  for (const auto& table : tables)
    out << "### " << table.title << "\n\n" << toMarkdown(table) << '\n';
  if (origin) out << origin->line << '\n';
}
}  // namespace

void requireCreatable(const std::string& flag, const std::string& path)
{
  if (!isCreatable(path)) throw CLI::ValidationError(flag, "'" + path + "' cannot be created");
}

void TableFiles::addFlags(CLI::App& command)
{
  command.add_option("--csv", csvPath_, "write the tables as CSV")->type_name("FILE");
  command.add_option("--json", jsonPath_, "write the tables as JSON")->type_name("FILE");
  command.add_option("--markdown", markdownPath_, "write the tables as Markdown")
      ->type_name("FILE");
}

void TableFiles::check() const
{
  if (!csvPath_.empty()) requireCreatable("--csv", csvPath_);
  if (!jsonPath_.empty()) requireCreatable("--json", jsonPath_);
  if (!markdownPath_.empty()) requireCreatable("--markdown", markdownPath_);
}

void TableFiles::save(const std::vector<Table>& tables, const TableOrigin* origin) const
{
  Outputs outputs;
  if (!csvPath_.empty())
    outputs.addText(csvPath_, [&](std::ostream& csv) { csv << toCsv(tables); });
  if (!jsonPath_.empty())
    outputs.addText(jsonPath_, [&](std::ostream& json) { writeJson(json, tables, origin); });
  if (!markdownPath_.empty())
    outputs.addText(markdownPath_,
                    [&](std::ostream& markdown) { writeMarkdown(markdown, tables, origin); });
  outputs.requireComplete();
}
}  // namespace psmks
