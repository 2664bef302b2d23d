/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/Machine.h>
#include <apps/psmks-benchmark/TableOutput.h>

#include <cmath>
#include <iostream>
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

Json toJson(const Machine& machine)
{
  return {{"processor", machine.processor},
          {"compiler", machine.compiler},
          {"flags", machine.flags},
          {"build_type", machine.buildType},
          {"commit", machine.commit}};
}
}  // namespace

std::ofstream createFile(const std::string& flag, const std::string& path)
{
  std::ofstream file(path, std::ios::binary);
  if (!file) throw CLI::ValidationError(flag, "'" + path + "' cannot be created");
  return file;
}

void TableOutput::addFlags(CLI::App& command)
{
  command.add_option("--csv", csvPath_, "write the tables as CSV")->type_name("FILE");
  command.add_option("--json", jsonPath_, "write the tables as JSON")->type_name("FILE");
  command.add_option("--markdown", markdownPath_, "write the tables as Markdown")
      ->type_name("FILE");
}

void TableOutput::open()
{
  if (!csvPath_.empty()) csv_ = createFile("--csv", csvPath_);
  if (!jsonPath_.empty()) json_ = createFile("--json", jsonPath_);
  if (!markdownPath_.empty()) markdown_ = createFile("--markdown", markdownPath_);
}

void TableOutput::write(const std::vector<Table>& tables)
{
  print(tables);
  save(tables);
}

void TableOutput::print(const std::vector<Table>& tables)
{
  std::cout << Machine::present().line() << '\n';
  for (const auto& table : tables) std::cout << '\n' << toText(table);
}

void TableOutput::save(const std::vector<Table>& tables)
{
  const Machine machine = Machine::present();
  if (csv_.is_open()) csv_ << toCsv(tables);
  if (markdown_.is_open())
  {
    for (const auto& table : tables)
      markdown_ << "### " << table.title << "\n\n" << toMarkdown(table) << '\n';
    markdown_ << "Measured on: " << machine.line() << '\n';
  }
  if (json_.is_open())
  {
    Json all = Json::array();
    for (const auto& table : tables) all.push_back(toJson(table));
    json_ << Json{{"machine", toJson(machine)}, {"tables", all}}.dump(2) << '\n';
  }
}
}  // namespace psmks
