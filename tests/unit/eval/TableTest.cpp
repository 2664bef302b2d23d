/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/eval/Table.h>

#include <limits>

namespace psmks
{
namespace
{
const Table kTable{"two matchers",
                   {{"matcher", "matcher", 0}, {"median mm", "median_mm", 1}},
                   {{std::string("a"), 12.3456789},
                    {std::string("long name"), std::numeric_limits<double>::quiet_NaN()}}};
}

TEST(Table, TextIsAligned)
{
  EXPECT_EQ(toText(kTable),
            "two matchers\n"
            "matcher    median mm\n"
            "a               12.3\n"
            "long name          -\n");
}

TEST(Table, MarkdownAlignsNumbersToTheRight)
{
  EXPECT_EQ(toMarkdown(kTable),
            "| matcher | median mm |\n"
            "|---|---:|\n"
            "| a | 12.3 |\n"
            "| long name | - |\n");
}

TEST(Table, PeopleDoNotSeeColumnsWithoutAnyValue)
{
  Table table = kTable;
  table.columns.push_back({"wrong", "wrong", 0});
  for (auto& row : table.rows) row.emplace_back(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(toText(table), toText(kTable));
  EXPECT_EQ(toMarkdown(table), toMarkdown(kTable));
  EXPECT_EQ(toHtml(table), toHtml(kTable));
  EXPECT_EQ(toCsv({table}).substr(0, 30), "table,matcher,median_mm,wrong\n");
  table.rows.clear();
  EXPECT_EQ(toMarkdown(table).substr(0, 33), "| matcher | median mm | wrong |\n|");
}

TEST(Table, HtmlHasACaptionAndNoMarkupFromTexts)
{
  Table table = kTable;
  table.title = "a < b & c";
  table.rows.resize(1);
  EXPECT_EQ(toHtml(table),
            "<table>\n<caption>a &lt; b &amp; c</caption>\n"
            "<tr><th>matcher</th><th class=\"number\">median mm</th></tr>\n"
            "<tr><td>a</td><td class=\"number\">12.3</td></tr>\n"
            "</table>\n");
}

TEST(Table, CsvHasKeysAndSevenDigits)
{
  EXPECT_EQ(toCsv({kTable}),
            "table,matcher,median_mm\ntwo matchers,a,12.34568\ntwo matchers,long name,\n");
}
}  // namespace psmks
