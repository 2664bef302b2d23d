/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/report/CommandLine.h>

#include <filesystem>
#include <fstream>

namespace psmks
{
namespace
{
std::string shellWord(const std::string& word)
{
  const bool plain = word.find_first_not_of(
                         "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                         "0123456789-_=+.,:/@%") == std::string::npos;
  if (plain && !word.empty()) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + '\'';
}
}  // namespace

std::string commandLine()
{
  std::ifstream words("/proc/self/cmdline");
  std::string text, word;
  if (std::getline(words, word, '\0'))
    text = shellWord(std::filesystem::path(word).filename().string());
  while (std::getline(words, word, '\0')) text += ' ' + shellWord(word);
  return text;
}
}  // namespace psmks
