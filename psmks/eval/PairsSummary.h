/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/PairBound.h>
#include <psmks/eval/PairError.h>
#include <psmks/eval/Table.h>
#include <psmks/geometry/Pose2.h>
#include <psmks/match/MatchResult.h>

#include <optional>
#include <string>
#include <vector>

namespace psmks
{
/** What one matcher made of one pair. */
struct PairRecord
{
  int id = 0;
  MatchResult result;
  Pose2 T_ref_cur_true;
  Pose2 T_ref_cur_guess;        //!< where the match started
  double time_s = 0;            //!< both scans raw
  double sequentialTime_s = 0;  //!< reference prepared beforehand, as where a sequence is matched;
                                //!< NaN where it was not measured

  PairError error() const { return pairError(result.T_ref_cur, T_ref_cur_true); }

  /** True where the match is to be trusted and says how far. */
  bool statesAccuracy() const;
};

/** The records of one matcher from one kind of guess. */
struct PairsRun
{
  std::string matcher;
  std::string guess;
  std::vector<PairRecord> records;
};

/** A run in figures. A failed match counts with the error of its guess. Figures that do not exist
 * are NaN. */
struct PairsSummary
{
  int pairs = 0;
  double successShare = 0;
  double translationMedian_m = 0, translationP95_m = 0;
  double rotationMedian_rad = 0, rotationP95_rad = 0;
  int acceptedAndWrong = 0, failed = 0, degenerate = 0;
  double neesMean = 0;        //!< over usable matches that state a covariance; 3 is right
  double ellipsoidShare = 0;  //!< of these, inside the 95 % ellipsoid
  double timeMedian_s = 0, timeP95_s = 0;
  double sequentialTimeMedian_s = 0;
};

/** @param limit of a success */
PairsSummary summarize(const std::vector<PairRecord>& records,
                       const PairError& limit = kSuccessLimit);

/** One row a run, and before the first run of every guess one for the bound, where there is one.
 *  @param bound of the errors of the same pairs
 *  @param baseline name of the matcher whose median time with the same guess is the unit of the
 *  column of time ratios; where it is not among the runs the ratios are NaN
 *  @param limit of a success */
Table pairsTable(const std::string& title, const std::vector<PairsRun>& runs,
                 const std::optional<BoundSummary>& bound, const std::string& baseline,
                 const PairError& limit = kSuccessLimit);

/** Every record of every run as CSV: header once, then one row a pair and matcher. */
std::string dumpHeader();
std::string dumpRows(const PairsRun& run);
}  // namespace psmks
