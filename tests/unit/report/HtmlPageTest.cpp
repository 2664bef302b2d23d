/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/report/CommandLine.h>
#include <apps/psmks-benchmark/report/HtmlPage.h>
#include <apps/psmks-benchmark/report/InlineSvg.h>
#include <gtest/gtest.h>
#include <tests/unit/report/Markup.h>

#include <cstdlib>

namespace psmks
{
namespace
{
using test::countOf;

Chart slope(const std::string& title)
{
  Chart chart;
  chart.title = title;
  chart.series = {{"a < b", {{0, 0}, {1, 1}}}};
  return chart;
}
}  // namespace

TEST(HtmlPage, TextsAreNoMarkup)
{
  HtmlPage page("a < b & c", {"machine <1>", "run 'a&b' > \"c\""});
  page.addHeading("<h>");
  page.addTable({"t & t", {{"x < y", "x"}}, {{std::string("<td>")}}});
  page.addDetails("<more>", "<p>all</p>");
  const std::string html = page.text();
  EXPECT_EQ(test::firstFlaw(html), "");
  for (const char* text : {"<title>a &lt; b &amp; c</title>", "machine &lt;1&gt;",
                           "run 'a&amp;b' &gt; &quot;c&quot;", "<h2>&lt;h&gt;</h2>",
                           "<td>&lt;td&gt;</td>", "<summary>&lt;more&gt;</summary>", "<p>all</p>"})
    EXPECT_NE(html.find(text), std::string::npos) << text << " in " << html;
}

TEST(HtmlPage, ChartsArePartOfTheDocument)
{
  HtmlPage page("charts", {"", ""});
  page.addCharts({slope("one"), slope("two")});
  const std::string html = page.text();
  if (html.find("cannot be run") != std::string::npos) GTEST_SKIP() << "gnuplot is not installed";
  EXPECT_EQ(test::firstFlaw(html), "");
  EXPECT_EQ(countOf("<svg", html), 2);
  EXPECT_EQ(countOf(" id=", html), 0);
  for (const char* reference : {"src=", "<link", "<script", "@import", "url("})
    EXPECT_EQ(countOf(reference, html), 0) << reference;
}

TEST(HtmlPage, WithoutGnuplotOneSentenceSaysSo)
{
  const std::string before = std::getenv("PATH");
  setenv("PATH", "/nonexistent", 1);
  HtmlPage page("charts", {"", ""});
  page.addCharts({slope("one"), slope("two")});
  page.addCharts({slope("three")});
  setenv("PATH", before.c_str(), 1);
  const std::string html = page.text();
  EXPECT_EQ(test::firstFlaw(html), "");
  EXPECT_EQ(countOf("<svg", html), 0);
  EXPECT_EQ(countOf("There are no charts: gnuplot cannot be run", html), 1) << html;
}

TEST(InlineSvg, KeepsWhatIsDrawnAndDropsNames)
{
  EXPECT_EQ(inlineSvg("<?xml version=\"1.0\"?>\n<svg width=\"7\">\n<title>Gnuplot</title>"
                      "<desc>by</desc><defs><path id='gp'/></defs><g id=\"g\"><path/></g></svg>\n",
                      "a < b"),
            "<svg width=\"7\"><title>a &lt; b</title>\n<g><path/></g></svg>\n");
  EXPECT_EQ(inlineSvg("", "nothing"), "");
}

TEST(CommandLine, IsThatOfThisProgram)
{
  EXPECT_EQ(commandLine().rfind("psmks_report_tests", 0), 0U) << commandLine();
}
}  // namespace psmks
