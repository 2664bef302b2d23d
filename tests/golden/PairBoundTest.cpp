/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/eval/PairBound.h>
#include <psmks/eval/Statistics.h>
#include <psmks/sim/PairSets.h>
#include <psmks/sim/PoseBound.h>

#include <Eigen/LU>
#include <cmath>

namespace psmks
{
namespace
{
double positionSigma_m(const Eigen::Matrix3d& information)
{
  return std::sqrt(information.inverse().topLeftCorner<2, 2>().trace());
}

/** For each pair, the standard deviation of the position from the scans alone over that with a map
 * of the world. */
std::vector<double> sigmaRatios(const std::string& family, int pairs)
{
  const PairSet set = makePairSet(pairFamily(family), 1, pairs);
  const RangeNoise noise = set.family.rangeNoise();
  std::vector<double> ratios;
  for (const SimulatedPair& pair : set.pairs)
  {
    const PairBound alone =
        pairBound(pair.reference.scan, pair.current.scan, pair.T_ref_cur_true, noise);
    const PoseBound withMap = poseBound(set.worlds[pair.world].world(), pair.T_world_ref,
                                        pair.reference, pair.T_world_cur(), pair.current, noise);
    ratios.push_back(positionSigma_m(alone.information) / positionSigma_m(withMap.information));
  }
  return ratios;
}
}  // namespace

TEST(PairBoundOnGeneratedPairs, IsThatOfTheKnownWorld)
{
  for (const char* family : {"L180_small", "L180_medium", "L360_medium", "rays1081"})
  {
    const std::vector<double> ratios = sigmaRatios(family, 60);
    EXPECT_NEAR(median(ratios), 1, 0.05) << family;
    EXPECT_GT(quantile(ratios, 0.05), 0.95) << family << ": the bound must not be too small";
    EXPECT_LT(quantile(ratios, 0.95), 1.3) << family;
  }
}

TEST(PairBoundOnGeneratedPairs, NoiseThatGrowsIsCountedAsInTheKnownWorld)
{
  const std::vector<double> ratios = sigmaRatios("rplidar", 60);
  EXPECT_NEAR(median(ratios), 1, 0.08);
  EXPECT_GT(quantile(ratios, 0.05), 0.9);
}

TEST(PairBoundOnGeneratedPairs, PeopleAreNotTakenForWalls)
{
  const std::vector<double> ratios = sigmaRatios("L180dyn_medium", 60);
  EXPECT_NEAR(median(ratios), 1, 0.08);
  EXPECT_GT(quantile(ratios, 0.05), 0.9);
}
}  // namespace psmks
