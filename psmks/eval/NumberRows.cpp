/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/eval/NumberRows.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace psmks
{
namespace
{
/** Empty where something else stands among the numbers. */
std::vector<double> numbersOf(const std::string& text)
{
  std::istringstream words(text);
  std::vector<double> numbers;
  for (double x; words >> x;) numbers.push_back(x);
  if (!words.eof()) numbers.clear();
  return numbers;
}

bool isBlank(const std::string& text) { return text.find_first_not_of(" \t\r") == text.npos; }
}  // namespace

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
    line.erase(std::min(line.find_first_of("#%"), line.size()));
    if (!isBlank(line)) rows.push_back({number, numbersOf(line)});
  }
  if (rows.empty()) throw TrajectoryFileError(path + ": holds no " + content);
  return rows;
}

void refuse(const std::string& path, const NumberRow& row, const std::string& reason)
{
  throw TrajectoryFileError(path + ":" + std::to_string(row.line) + ": " + reason);
}
}  // namespace psmks
