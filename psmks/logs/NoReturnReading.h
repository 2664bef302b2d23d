/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <vector>

namespace psmks
{
/** Finds out from the ranges of a log what its scanner reads where nothing is met: many logs do not
 * say.
 *
 * SICK's scanners count to 8191 cm and use the values from 8183 on as codes, at up to 80 m of
 * range. Of other scanners the largest reading is taken for "no return" where it stands out:
 *
 *     readings |                                #
 *              |  # #                           #
 *              |# # # # #   #                   #
 *              +------------------------+-------#--> range
 *                                  0.9 max     max    more often than all from 0.9 max to max */
class NoReturnReading
{
 public:
  NoReturnReading();

  /** @param range_m anything, NaN and infinity included */
  void add(double range_m);

  /** Readings at or beyond it are no returns; beyond all readings where none stands out. */
  double limit_m() const;

  /** Whether the largest readings are a SICK's codes, whatever range the log claims. */
  bool isCode() const;

 private:
  double readingsBelowLargest() const;

  std::vector<double> bins_;  //!< readings by range
  double largest_m_ = 0;
  double timesLargest_ = 0;
};
}  // namespace psmks
