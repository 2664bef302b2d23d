/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/core/Matcher.h>
#include <psmks/eval/PairError.h>
#include <psmks/eval/PairsFile.h>
#include <psmks/eval/Statistics.h>

#include <cstdlib>
#include <fstream>

namespace psmks
{
namespace
{
/** The path of a file in the folder of test data; empty if there is no such folder or file. */
std::string dataFile(const std::string& name)
{
  const char* folder = std::getenv("PSMKS_DATA_DIR");
  const std::string path = folder ? std::string(folder) + "/" + name : "";
  return std::ifstream(path) ? path : "";
}
}  // namespace

TEST(PairFiles, TheFirstFiftyPairsOfL180MediumAllSucceed)
{
  constexpr int kPairs = 50;
  const std::string path = dataFile("pairs/L180_medium.pairs.gz");
  if (path.empty()) GTEST_SKIP() << "no pairs/L180_medium.pairs.gz in PSMKS_DATA_DIR";

  PairsReader reader(path);
  const Matcher matcher;
  MatcherWorkspace workspace;
  std::vector<double> errors_m, errors_deg;
  ScanPair pair;
  while (static_cast<int>(errors_m.size()) < kPairs && reader.read(pair))
  {
    const MatchResult result = matcher.match(pair.reference, pair.current, {}, workspace);
    const PairError error = pairError(result.T_ref_cur, pair.T_ref_cur_true);
    EXPECT_TRUE(result.usable() && isSuccess(error))
        << "pair " << pair.id << ": " << result.report();
    errors_m.push_back(error.translation_m);
    errors_deg.push_back(radToDeg(error.rotation_rad));
  }
  ASSERT_EQ(errors_m.size(), std::size_t{kPairs});
  EXPECT_LE(median(errors_m), 0.0016);
  EXPECT_LE(median(errors_deg), 0.015);
}
}  // namespace psmks
