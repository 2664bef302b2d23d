/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
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
}  // namespace

std::ofstream createFile(const std::string& flag, const std::string& path)
{
  std::ofstream file(path, std::ios::binary);
  if (!file) throw CLI::ValidationError(flag, "'" + path + "' cannot be created");
  return file;
}

void TableFiles::addFlags(CLI::App& command)
{
  command.add_option("--csv", csvPath_, "write the tables as CSV")->type_name("FILE");
  command.add_option("--json", jsonPath_, "write the tables as JSON")->type_name("FILE");
  command.add_option("--markdown", markdownPath_, "write the tables as Markdown")
      ->type_name("FILE");
}

void TableFiles::open()
{
  if (!csvPath_.empty()) csv_ = createFile("--csv", csvPath_);
  if (!jsonPath_.empty()) json_ = createFile("--json", jsonPath_);
  if (!markdownPath_.empty()) markdown_ = createFile("--markdown", markdownPath_);
}

void TableFiles::save(const std::vector<Table>& tables, const TableOrigin* origin)
{
  if (csv_.is_open()) csv_ << toCsv(tables);
  if (json_.is_open()) json_ << toJson(tables, origin).dump(2) << '\n';
  if (!markdown_.is_open()) return;
  for (const auto& table : tables)
    markdown_ << "### " << table.title << "\n\n" << toMarkdown(table) << '\n';
  if (origin) markdown_ << origin->line << '\n';
}
}  // namespace psmks
