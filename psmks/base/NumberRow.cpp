/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/base/NumberRow.h>

#include <charconv>
#include <cmath>

namespace psmks
{
std::optional<std::vector<double>> parseNumberRow(std::string_view line, NonFinite nonFinite)
{
  constexpr std::string_view kBlanks = " \t\r";
  std::vector<double> numbers;
  while (true)
  {
    const std::size_t begin = line.find_first_not_of(kBlanks);
    if (begin == std::string_view::npos) return numbers;
    line.remove_prefix(begin);
    const std::string_view word = line.substr(0, line.find_first_of(kBlanks));
    line.remove_prefix(word.size());
    double number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    const bool isWhole = error == std::errc() && end == word.data() + word.size();
    const bool isAdmitted = std::isfinite(number) || nonFinite == NonFinite::Admitted;
    if (!isWhole || !isAdmitted) return std::nullopt;
    numbers.push_back(number);
  }
}
}  // namespace psmks
