/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/Figure.h>
#include <psmks/eval/Table.h>

#include <string>
#include <vector>

namespace psmks
{
/** What the figures of a page come from. */
struct PageOrigin
{
  std::string machine;  //!< one line
  std::string command;  //!< that makes the page again
};

/** One HTML page that needs no other file: readable offline, in print and on a phone. Parts stand
 * in the order in which they are added; texts are shown as they are. */
class HtmlPage
{
 public:
  HtmlPage(const std::string& title, const PageOrigin& origin);

  void addHeading(const std::string& text);
  void addTable(const Table& table);

  /** Charts beside each other as far as the window is wide. Where they cannot be drawn - gnuplot is
   * not installed - one sentence says so, on the whole page once. */
  void addCharts(const std::vector<Panel>& charts);

  /** Markup as it is. */
  void addHtml(const std::string& html) { body_ += html; }

  /** Markup that is shown on demand. */
  void addDetails(const std::string& summary, const std::string& html);

  /** The whole document. */
  std::string text() const;

 private:
  std::string title_;
  std::string body_;
  bool chartsFailed_ = false;
};
}  // namespace psmks
