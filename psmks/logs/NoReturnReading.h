/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <vector>

namespace psmks
{
/** Finds out from the ranges of a log which reading means "no return", for many logs do not say it.
 *
 * SICK scanners with ranges up to 80 m count to 8191 cm and use the values from 8183 on as error
 * codes. For other scanners the largest reading means "no return" if it is much more frequent than
 * the readings near it:
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

  /** Counts a reading.
   *  @param range_m may be NaN or infinite */
  void add(double range_m);

  /** The reading at or beyond which there is no return. If no reading stands out, it is larger than
   * all readings. */
  double limit_m() const;

  /** Whether the largest readings are the error codes of a SICK scanner. They are then no returns
   * whatever maximum range the log states. */
  bool isCode() const;

 private:
  double readingsBelowLargest() const;

  std::vector<double> bins_;  //!< number of readings by range
  double largest_m_ = 0;
  double timesLargest_ = 0;
};
}  // namespace psmks
