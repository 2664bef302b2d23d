/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/base/NumberRow.h>
#include <psmks/eval/NumberRows.h>

#include <filesystem>
#include <fstream>

namespace psmks
{
std::vector<NumberRow> readNumberRows(const std::string& path, const std::string& content)
{
  std::ifstream file(path);
  if (!file || std::filesystem::is_directory(path))
    throw TrajectoryFileError(path + ": no such file, or not to be read");
  std::vector<NumberRow> rows;
  int number = 0;
  for (std::string line; std::getline(file, line);)
  {
    ++number;
    const auto text = std::string_view(line).substr(0, line.find_first_of("#%"));
    const auto numbers = parseNumberRow(text);
    const bool isBlank = numbers && numbers->empty();
    if (!isBlank) rows.push_back({number, numbers.value_or(std::vector<double>())});
  }
  if (rows.empty()) throw TrajectoryFileError(path + ": holds no " + content);
  return rows;
}

void refuse(const std::string& path, const NumberRow& row, const std::string& reason)
{
  throw TrajectoryFileError(path + ":" + std::to_string(row.line) + ": " + reason);
}
}  // namespace psmks
