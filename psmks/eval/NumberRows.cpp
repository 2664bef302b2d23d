/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/eval/NumberRows.h>

#include <filesystem>
#include <fstream>

namespace psmks
{
namespace
{
/** Whether a path can have rows that end: a file, or a pipe from another program. */
bool isReadable(const std::string& path)
{
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  return std::filesystem::is_regular_file(status) || std::filesystem::is_fifo(status);
}
}  // namespace

std::vector<NumberRow> readNumberRows(const std::string& path, const std::string& content,
                                      NonFinite nonFinite)
{
  std::ifstream file(path);
  if (!file || !isReadable(path))
    throw TrajectoryFileError(path + ": no such file, or not to be read");
  std::vector<NumberRow> rows;
  int number = 0;
  for (std::string line; std::getline(file, line);)
  {
    ++number;
    const auto text = std::string_view(line).substr(0, line.find_first_of("#%"));
    const auto numbers = parseNumberRow(text, nonFinite);
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
