/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/report/InlineSvg.h>
#include <psmks/eval/HtmlText.h>

namespace psmks
{
namespace
{
/** Removes each part of a text from `begin` to the next `end`, both included. */
void drop(std::string& text, const std::string& begin, const std::string& end)
{
  std::string kept;
  std::size_t from = 0;
  for (std::size_t at = text.find(begin); at != std::string::npos; at = text.find(begin, from))
  {
    const std::size_t last = text.find(end, at + begin.size());
    if (last == std::string::npos) break;
    kept.append(text, from, at - from);
    from = last + end.size();
  }
  text = kept.append(text, from, std::string::npos);
}
}  // namespace

std::string inlineSvg(const std::string& document, const std::string& title)
{
  std::string svg = document;
  drop(svg, "<?xml", "?>");
  drop(svg, "<title>", "</title>");
  drop(svg, "<desc>", "</desc>");
  drop(svg, "<defs>", "</defs>");
  drop(svg, " id=\"", "\"");
  drop(svg, " xmlns:xlink=\"", "\"");
  const std::size_t head = svg.find("<svg"), headEnd = svg.find('>', head);
  if (headEnd == std::string::npos) return "";
  svg.insert(headEnd + 1, "<title>" + htmlText(title) + "</title>");
  return svg.substr(head);
}
}  // namespace psmks
