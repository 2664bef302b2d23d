/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <mrpt/maps/CSimpleMap.h>
#include <psmks/core/MatcherOptions.h>
#include <psmks/slam/KeyframeMap.h>
#include <psmks/slam/ScanMap.h>

#include <optional>
#include <string>
#include <vector>

namespace psmks
{
/** What a run found, for the files that are written of it. */
class RunResults
{
 public:
  /** @param scans of the trajectory, and `keyframes` of the same; both must outlive this object
   *  @param observations the observations of the references at their poses
   *  @param title of pictures of the map */
  RunResults(const std::vector<PosedScan>& scans, const KeyframeMap& keyframes,
             const MatcherOptions& options, mrpt::maps::CSimpleMap observations, std::string title)
      : scans_(scans),
        keyframes_(keyframes),
        options_(options),
        observations_(std::move(observations)),
        title_(std::move(title))
  {
  }

  const std::vector<PosedScan>& scans() const { return scans_; }
  const KeyframeMap& keyframes() const { return keyframes_; }
  const MatcherOptions& options() const { return options_; }
  const mrpt::maps::CSimpleMap& observations() const { return observations_; }
  const std::string& title() const { return title_; }

  /** The map for pictures, which is made when it is first asked for. */
  const ScanMap& scanMap()
  {
    if (!scanMap_) scanMap_ = makeScanMap(scans_, options_);
    return *scanMap_;
  }

 private:
  const std::vector<PosedScan>& scans_;
  const KeyframeMap& keyframes_;
  MatcherOptions options_;
  mrpt::maps::CSimpleMap observations_;
  std::string title_;
  std::optional<ScanMap> scanMap_;
};
}  // namespace psmks
