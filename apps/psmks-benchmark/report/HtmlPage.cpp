/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/report/HtmlPage.h>
#include <apps/psmks-benchmark/report/InlineSvg.h>
#include <psmks/eval/HtmlText.h>

namespace psmks
{
namespace
{
constexpr int kPanelWidth_px = 500, kPanelHeight_px = 380;
constexpr int kLegendRow_px = 20;  // height of a row with two names

const char* const kStyle = R"(
body { font: 16px/1.5 "DejaVu Sans", sans-serif; color: #222; max-width: 1760px; margin: 0 auto;
  padding: 0 1rem; }
h1, h2, h3 { line-height: 1.2; }
code { overflow-wrap: anywhere; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: 14px; margin: 1rem 0; }
caption { text-align: left; font-weight: bold; }
th, td { padding: 2px 8px; text-align: left; white-space: nowrap; border-bottom: 1px solid #ddd; }
.number { text-align: right; font-variant-numeric: tabular-nums; }
.charts { display: flex; flex-wrap: wrap; align-items: flex-start; gap: 0.5rem; }
.charts svg { flex: 1 1 320px; max-width: 560px; width: 100%; height: auto; }
.drawings { display: grid; grid-template-columns: repeat(auto-fill, minmax(220px, 1fr)); gap: 1rem; }
figure { margin: 0; break-inside: avoid; }
figcaption { font-size: 13px; }
.drawing { width: 100%; height: auto; border: 1px solid #ddd; }
.drawing text { fill: #222; }
.outline { fill: none; stroke-linecap: round; stroke-linejoin: round;
  vector-effect: non-scaling-stroke; }
.outlines { position: absolute; width: 0; height: 0; }
.reference { stroke: #bbb; color: #777; stroke-width: 3px; }
.truth { stroke: #009e73; color: #009e73; stroke-width: 2px; }
.estimate { stroke: #d55e00; color: #d55e00; stroke-width: 1px; }
.guess { stroke: #0072b2; color: #0072b2; stroke-width: 1.5px; }
@media print { body { font-size: 11px; } table { font-size: 8px; } .wide { overflow: visible; } }
)";

const std::string& titleOf(const Panel& panel)
{
  return std::visit([](const auto& content) -> const std::string& { return content.title; }, panel);
}

/** The height of a chart. That of its legend is added, so that the plot itself has the same height
 * with many curves. */
int heightOf_px(const Panel& panel)
{
  const Chart* chart = std::get_if<Chart>(&panel);
  const int names = chart == nullptr ? 0 : static_cast<int>(chart->series.size());
  return kPanelHeight_px + (names + 1) / 2 * kLegendRow_px;
}

std::string drawnChart(const Panel& chart, std::string& reason)
{
  Figure figure;
  figure.panels = {chart};
  figure.panelWidth_px = kPanelWidth_px;
  figure.panelHeight_px = heightOf_px(chart);
  return inlineSvg(svgText(figure, &reason), titleOf(chart));
}
}  // namespace

HtmlPage::HtmlPage(const std::string& title, const PageOrigin& origin) : title_(title)
{
  body_ = "<h1>" + htmlText(title) + "</h1>\n<p>Measured on: " + htmlText(origin.machine) +
          "</p>\n<p><code>" + htmlText(origin.command) + "</code></p>\n";
}

void HtmlPage::addHeading(const std::string& text) { body_ += "<h2>" + htmlText(text) + "</h2>\n"; }

void HtmlPage::addTable(const Table& table)
{
  body_ += "<div class=\"wide\">\n" + toHtml(table) + "</div>\n";
}

void HtmlPage::addCharts(const std::vector<Panel>& charts)
{
  if (chartsFailed_) return;
  std::string drawn, reason;
  for (const Panel& chart : charts)
    if (reason.empty()) drawn += drawnChart(chart, reason);
  chartsFailed_ = !reason.empty();
  body_ += chartsFailed_ ? "<p>There are no charts: " + htmlText(reason) + ".</p>\n"
                         : "<div class=\"charts\">\n" + drawn + "</div>\n";
}

void HtmlPage::addDetails(const std::string& summary, const std::string& html)
{
  body_ += "<details><summary>" + htmlText(summary) + "</summary>\n" + html + "</details>\n";
}

std::string HtmlPage::text() const
{
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<title>" +
         htmlText(title_) + "</title>\n<style>" + kStyle + "</style>\n</head>\n<body>\n" + body_ +
         "</body>\n</html>\n";
}
}  // namespace psmks
