/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/eval/PairsFile.h>
#include <tests/support/ScratchFolder.h>

#include <filesystem>
#include <fstream>

namespace psmks
{
namespace
{
class PairsFile : public testing::Test
{
 protected:
  std::string path(const std::string& name) const { return folder_.path(name); }

  std::string write(const std::string& text) const
  {
    std::ofstream(path("written.pairs"), std::ios::binary) << text;
    return path("written.pairs");
  }

  /** The message that reading all pairs of such a file ends with; empty without an error. */
  std::string errorOf(const std::string& text) const
  {
    try
    {
      PairsReader reader(write(text));
      for (ScanPair pair; reader.read(pair);)
      {
      }
      return "";
    }
    catch (const PairsFileError& error)
    {
      return error.what();
    }
  }

  const test::ScratchFolder folder_;
};

const std::string kHeader = "PSMPAIRS 1\nlaser 3 -0.5 0.5 30\nnpairs 1\n";
const std::string kPair = "pair 7 1 2 0.1 1.1 2.1 0.2\n1 2 3\n4 0 6\n";

ScanPair examplePair(const BeamGrid& grid)
{
  ScanPair pair;
  pair.id = 7;
  pair.T_ref_cur_true = {0.123456789, -2.5, 0.0596};
  pair.T_ref_cur_odometry = {0.2, -2.25, 0.0625};
  pair.reference.grid = pair.current.grid = grid;
  pair.reference.range_m = {1.2345, 0, 29.999};
  pair.current.range_m = {0.001, 3, 0};
  return pair;
}

void expectSamePose(const Pose2& a, const Pose2& b)
{
  EXPECT_DOUBLE_EQ(a.x_m, b.x_m);
  EXPECT_DOUBLE_EQ(a.y_m, b.y_m);
  EXPECT_DOUBLE_EQ(a.phi_rad, b.phi_rad);
}

void expectRoundTrip(const std::string& path)
{
  const PairsHeader header{BeamGrid(-0.5, 0.5, 3), 30, 1};
  const ScanPair written = examplePair(header.grid);
  PairsWriter writer(path, header);
  writer.write(written);
  writer.close();

  PairsReader reader(path);
  EXPECT_EQ(reader.header().pairs, 1);
  ScanPair read;
  ASSERT_TRUE(reader.read(read));
  EXPECT_EQ(read.id, written.id);
  expectSamePose(read.T_ref_cur_true, written.T_ref_cur_true);
  expectSamePose(read.T_ref_cur_odometry, written.T_ref_cur_odometry);
  EXPECT_EQ(read.reference.range_m, written.reference.range_m);
  EXPECT_EQ(read.current.range_m, written.current.range_m);
  EXPECT_EQ(read.current.grid, header.grid);
  EXPECT_EQ(read.current.maxRange_m, 30);
  EXPECT_FALSE(reader.read(read));
}
}  // namespace

TEST_F(PairsFile, ReadsWhatItWrote) { expectRoundTrip(path("plain.pairs")); }

TEST_F(PairsFile, ReadsWhatItWroteCompressed) { expectRoundTrip(path("small.pairs.gz")); }

TEST_F(PairsFile, CompressesOnlyWhereTheNameSaysSo)
{
  expectRoundTrip(path("plain.pairs"));
  expectRoundTrip(path("small.pairs.gz"));
  const auto firstByte = [this](const char* name) { return std::ifstream(path(name)).get(); };
  EXPECT_EQ(firstByte("plain.pairs"), 'P');
  EXPECT_EQ(firstByte("small.pairs.gz"), 0x1f);
}

TEST_F(PairsFile, SkipsCommentsAndBlankLines)
{
  EXPECT_EQ(errorOf("PSMPAIRS 1\n# made by hand\n\nlaser 3 -0.5 0.5 30\nnpairs 1\n" + kPair), "");
}

TEST_F(PairsFile, MissingFileIsNamed)
{
  try
  {
    PairsReader reader(path("absent.pairs"));
    FAIL() << "no exception";
  }
  catch (const PairsFileError& error)
  {
    EXPECT_EQ(error.what(), path("absent.pairs") + ": cannot be opened");
  }
}

TEST_F(PairsFile, DamageIsReportedWithItsLine)
{
  const auto expectError = [this](const std::string& text, const std::string& message)
  { EXPECT_EQ(errorOf(text), path("written.pairs") + ", line " + message); };

  expectError("",
              "1: the file ends where 'PSMPAIRS 1', the mark of a scan pairs file, should follow");
  expectError("PSMPAIRS 2\n", "1: unknown format version");
  expectError("PSMPAIRS 1\nlaser 3 -0.5 0 30\nnpairs 1\n" + kPair,
              "2: BeamGrid: the increment must be at least 1e-05 rad, got 0");
  expectError("PSMPAIRS 1\nlaser 3 -0.5\n", "2: the increment is missing");
  expectError(kHeader, "4: the file ends where pair 1 of 1 should follow");
  expectError(kHeader + "pair 7 1 2 0.1 1.1 2.1\n", "4: the odometry's pose is missing");
  expectError(kHeader + "pair 7 1 2 0.1 1.1 2.1 0.2\n1 2 x3\n", "5: a range: 'x3' is not a number");
  expectError(kHeader + "pair 7 1 2 0.1 1.1 2.1 0.2\n1 2\n", "5: a range is missing");
  expectError(kHeader + "pair 7 1 2 0.1 1.1 2.1 0.2\n1 2 3 4\n", "5: more numbers than expected");
  expectError(kHeader + "pair 7 1 2 0.1 1.1 2.1 0.2\n1 2 3\n",
              "6: the file ends where the ranges of a scan should follow");
}

TEST_F(PairsFile, PairsBeforeTheDamageStayGood)
{
  PairsReader reader(write("PSMPAIRS 1\nlaser 3 -0.5 0.5 30\nnpairs 2\n" + kPair));
  ScanPair pair;
  EXPECT_TRUE(reader.read(pair));
  EXPECT_THROW(reader.read(pair), PairsFileError);
  EXPECT_EQ(pair.id, 7);
}

TEST_F(PairsFile, ACutOffCompressedFileIsReported)
{
  expectRoundTrip(path("small.pairs.gz"));
  std::filesystem::resize_file(path("small.pairs.gz"),
                               std::filesystem::file_size(path("small.pairs.gz")) / 2);
  EXPECT_THROW(
      {
        PairsReader reader(path("small.pairs.gz"));
        for (ScanPair pair; reader.read(pair);)
        {
        }
      },
      PairsFileError);
}
}  // namespace psmks
