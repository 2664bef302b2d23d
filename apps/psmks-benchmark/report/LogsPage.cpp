/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/report/LogsPage.h>
#include <apps/psmks-benchmark/report/PairDrawings.h>

namespace psmks
{
namespace
{
void addDrawings(HtmlPage& page, const DrawnRun& run, const std::string& name)
{
  PairDrawings drawings(name, run.pairs);
  std::string drawn;
  for (std::size_t place = 0; place < run.records.size(); ++place)
    drawn += drawings.draw(place, run.records[place]);
  page.addDetails(run.title, "<div class=\"drawings\">\n" + drawn + "</div>\n");
  page.addHtml(drawings.outlines());
}
}  // namespace

std::string logsPage(const PageOrigin& origin, const std::vector<Table>& tables,
                     const std::vector<DrawnRun>& runs)
{
  HtmlPage page("Scan matchers on logs", origin);
  for (const Table& table : tables) page.addTable(table);
  if (runs.empty()) return page.text();

  page.addHeading("Where paths are furthest from the truth");
  page.addHtml(std::string("<p>By the last scan's place in the log; ") + PairDrawings::kLegend +
               "</p>\n");
  for (const DrawnRun& run : runs)
    addDrawings(page, run, "run" + std::to_string(&run - runs.data()));
  return page.text();
}
}  // namespace psmks
