/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/Figure.h>
#include <psmks/eval/Table.h>

#include <string>
#include <vector>

namespace psmks
{
/** Where the values on a page come from. */
struct PageOrigin
{
  std::string machine;  //!< description in one line
  std::string command;  //!< command that makes the page again
};

/** An HTML page that needs no other file and can be read offline, in print and on a phone. Its
 * parts come in the order in which they are added. Texts are shown as they are, without markup. */
class HtmlPage
{
 public:
  HtmlPage(const std::string& title, const PageOrigin& origin);

  void addHeading(const std::string& text);
  void addTable(const Table& table);

  /** Adds charts side by side, as far as the width of the window allows. If they cannot be drawn,
   * as without gnuplot, one sentence on the page says so. */
  void addCharts(const std::vector<Panel>& charts);

  /** Adds markup. */
  void addHtml(const std::string& html) { body_ += html; }

  /** Adds markup that is folded under a summary. */
  void addDetails(const std::string& summary, const std::string& html);

  /** The whole document. */
  std::string text() const;

 private:
  std::string title_;
  std::string body_;
  bool chartsFailed_ = false;
};
}  // namespace psmks
