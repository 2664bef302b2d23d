/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/support/Outputs.h>
#include <gtest/gtest.h>
#include <tests/support/Program.h>
#include <tests/support/ScratchFolder.h>

#include <ostream>

namespace psmks
{
TEST(Outputs, OneThatCannotBeWrittenStopsNoOther)
{
  const test::ScratchFolder folder;
  Outputs outputs;
  const auto hello = [](std::ostream& out) { out << "hello"; };
  outputs.addText(folder.path("no/a.txt"), hello);
  outputs.addText(folder.path("b.txt"), hello);
  outputs.add(folder.path("c.txt"), [](const std::string&) { return false; });
  outputs.note("d.txt", false);
  outputs.note("e.txt", true);
  EXPECT_EQ(fileText(folder.path("b.txt")), "hello");
  EXPECT_FALSE(outputs.isComplete());
  EXPECT_EQ(outputs.complaint(), "cannot write '" + folder.path("no/a.txt") + "', '" +
                                     folder.path("c.txt") + "', 'd.txt'");
  try
  {
    outputs.requireComplete();
    ADD_FAILURE() << "not thrown";
  }
  catch (const ProgramError& error)
  {
    EXPECT_EQ(error.exitCode, kOutputFailed);
  }
}

TEST(Outputs, OfWhichAllAreWrittenAreComplete)
{
  Outputs outputs;
  EXPECT_TRUE(outputs.isComplete());
  EXPECT_EQ(outputs.complaint(), "");
  EXPECT_NO_THROW(outputs.requireComplete());
}
}  // namespace psmks
