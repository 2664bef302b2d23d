/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <mrpt/slam/CICP.h>
#include <psmks/mrpt/PairMatcher.h>

namespace psmks
{
/** MRPT's CICP with its default parameters on two point maps, each made of a scan with MRPT's
 * default insertion options.
 *
 *  A match is a failure (NoImprovement) below the share of correspondences that MRPT's map builder
 *  accepts, kAcceptedGoodness. `score` is that share, at most 1; times.segmentation_s is the time
 * of making the maps. */
class IcpPairMatcher : public PairMatcher
{
 public:
  static constexpr double kAcceptedGoodness = 0.40;

  IcpPairMatcher(std::string name, mrpt::slam::TICPAlgorithm algorithm);

  std::string name() const override { return name_; }
  MatchResult match(const Scan& reference, const Scan& current, const Guess& guess) override;

 private:
  std::string name_;
  mrpt::slam::CICP icp_;
};
}  // namespace psmks
