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
/** Pictures of matched pairs, as inline SVG in the frame of the reference: the reference scan, and
 * the current scan where the match put it and where it truly was; the sensor at the guess.
 *
 * However many pictures show a scan, its outline stands on the page once: see outlines(). Colours
 * come from the classes reference, truth, estimate and guess of the page. */
class PairDrawings
{
 public:
  /** @param name unique on the page, a word
   *  @param pairs must outlive this */
  PairDrawings(std::string name, const std::vector<ScanPair>& pairs)
      : name_(std::move(name)), pairs_(pairs)
  {
  }

  /** What the pictures show, as the end of a sentence. */
  static constexpr const char* kLegend =
      "the <span class=\"reference\">reference</span> scan, the current scan where it "
      "<span class=\"truth\">truly</span> was and where the match "
      "<span class=\"estimate\">put</span> it; the sensor at the "
      "<span class=\"guess\">guess</span>.";

  /** A `figure` element with its caption.
   *  @param place of the pair and its record */
  std::string draw(std::size_t place, const PairRecord& record);

  /** What the pictures drawn so far refer to; belongs on the page, outside of what can be folded.
   */
  std::string outlines() const;

 private:
  std::string outlineName(std::size_t place, const char* scan) const;
  std::string use(std::size_t place, const char* scan, const char* role,
                  const Pose2& T_ref_scan) const;

  std::string name_;
  const std::vector<ScanPair>& pairs_;
  std::set<std::size_t> drawn_;  // places of pairs
};
}  // namespace psmks
