/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/report/DistributionCharts.h>
#include <apps/psmks-benchmark/report/PairDrawings.h>
#include <apps/psmks-benchmark/report/PairsPage.h>
#include <apps/psmks-benchmark/report/WorstPairs.h>

#include <algorithm>

namespace psmks
{
namespace
{
constexpr std::size_t kWorstPairs = 10;

std::vector<std::string> guessesOf(const PairsSetResult& set)
{
  std::vector<std::string> guesses;
  for (const PairsRun& run : set.runs)
    if (std::find(guesses.begin(), guesses.end(), run.guess) == guesses.end())
      guesses.push_back(run.guess);
  return guesses;
}

void addDistributions(HtmlPage& page, const PairsSetResult& set)
{
  for (const std::string& guess : guessesOf(set))
  {
    const std::vector<Chart> charts = distributionCharts(set, guess);
    page.addHeading(set.title + ", guess: " + guess);
    page.addCharts({charts.begin(), charts.end()});
  }
}

void addConvergence(HtmlPage& page, const PairsSetResult& set)
{
  if (set.convergence.empty()) return;
  page.addHeading(set.title + ", areas of convergence");
  page.addCharts(set.convergence);
}

void addWorstPairs(HtmlPage& page, const PairsSetResult& set, PairDrawings drawings)
{
  page.addHtml(std::string("<p>The worst pairs of each matcher, by the larger of both errors as "
                           "shares of what a success may have: ") +
               PairDrawings::kLegend + "</p>\n");
  for (const PairsRun& run : set.runs)
  {
    std::string drawn;
    for (const std::size_t place : worstRecords(run.records, kWorstPairs, set.successLimit))
      drawn += drawings.draw(place, run.records[place]);
    page.addDetails(set.title + ", " + run.matcher + ", guess: " + run.guess,
                    "<div class=\"drawings\">\n" + drawn + "</div>\n");
  }
  page.addHtml(drawings.outlines());
}
}  // namespace

std::string pairsPage(const PageOrigin& origin, const std::vector<Table>& tables,
                      const std::vector<PairsSetResult>& sets)
{
  HtmlPage page("Scan matchers on pairs of scans", origin);
  for (const Table& table : tables) page.addTable(table);
  for (const PairsSetResult& set : sets)
  {
    addDistributions(page, set);
    addConvergence(page, set);
    const std::string name = "set" + std::to_string(&set - sets.data());
    addWorstPairs(page, set, PairDrawings(name, set.pairs));
  }
  return page.text();
}
}  // namespace psmks
