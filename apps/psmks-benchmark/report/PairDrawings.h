/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/PairsFile.h>
#include <psmks/eval/PairsSummary.h>

#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace psmks
{
/** Pictures of matched pairs as inline SVG in the frame of the reference. They show the reference
 * scan, the current scan at the matched and at the true pose, and the sensor at the guess.
 *
 * The outline of a scan is on the page once, however many pictures show it, see outlines(). The
 * colours are those of the classes reference, truth, estimate and guess of the page. */
class PairDrawings
{
 public:
  /** @param name a word that no other drawings on the page have
   *  @param pairs must outlive this object */
  PairDrawings(std::string name, const std::vector<ScanPair>& pairs)
      : name_(std::move(name)), pairs_(pairs)
  {
  }

  /** A description of the pictures, as the end of a sentence. */
  static constexpr const char* kLegend =
      "the <span class=\"reference\">reference</span> scan, the current scan where it "
      "<span class=\"truth\">truly</span> was and where the match "
      "<span class=\"estimate\">put</span> it; the sensor at the "
      "<span class=\"guess\">guess</span>.";

  /** Draws a pair as a `figure` element with its caption.
   *  @param place index of the pair */
  std::string draw(std::size_t place, const PairRecord& record);

  /** The outlines that the pictures refer to. They have to be on the page, outside of folded parts.
   */
  std::string outlines() const;

 private:
  std::string outlineName(std::size_t place, const char* scan) const;
  std::string use(std::size_t place, const char* scan, const char* role,
                  const Pose2& T_ref_scan) const;

  std::string name_;
  const std::vector<ScanPair>& pairs_;
  std::set<std::size_t> drawn_;  // indices of the pairs
};
}  // namespace psmks
