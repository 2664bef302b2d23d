/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <string>
#include <vector>

namespace psmks::test
{
/** The first reason why a document is not well-formed, or "": a tag that is not closed, is closed
 * in the wrong order or was never opened, or a bare ampersand. */
inline std::string firstFlaw(const std::string& html)
{
  std::vector<std::string> open;
  for (std::size_t at = html.find('<'); at != std::string::npos; at = html.find('<', at + 1))
  {
    const std::size_t end = html.find('>', at);
    if (end == std::string::npos) return "the last tag has no end";
    const std::string tag = html.substr(at + 1, end - at - 1);
    if (tag[0] == '!' || tag.back() == '/') continue;
    const std::string name = tag.substr(0, tag.find_first_of(" \n"));
    if (name[0] != '/')
      open.push_back(name);
    else if (open.empty() || open.back() != name.substr(1))
      return '<' + name + "> where " + (open.empty() ? "nothing" : open.back()) + " is open";
    else
      open.pop_back();
  }
  for (std::size_t at = html.find('&'); at != std::string::npos; at = html.find('&', at + 1))
    if (html.find(';', at) > at + 6) return "a bare ampersand: " + html.substr(at, 20);
  return open.empty() ? "" : '<' + open.back() + "> is not closed";
}

/** The number of occurrences of a word in a text. */
inline int countOf(const std::string& word, const std::string& text)
{
  int count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
    ++count;
  return count;
}
}  // namespace psmks::test
