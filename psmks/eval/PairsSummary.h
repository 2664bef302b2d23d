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
/** The result of one matcher on one pair. */
struct PairRecord
{
  int id = 0;
  MatchResult result;
  Pose2 T_ref_cur_true;
  Pose2 T_ref_cur_guess;        //!< guess of the match
  double time_s = 0;            //!< time of a match from two raw scans
  double sequentialTime_s = 0;  //!< time with a reference prepared before, as in a sequence of
                                //!< scans; NaN if not measured

  PairError error() const { return pairError(result.T_ref_cur, T_ref_cur_true); }

  /** Whether the match is usable and has a covariance. */
  bool statesAccuracy() const;
};

/** The records of one matcher with one kind of guess. */
struct PairsRun
{
  std::string matcher;
  std::string guess;
  std::vector<PairRecord> records;
};

/** Statistics of a run. A failed match counts with the error of its guess. Values that do not exist
 * are NaN. */
struct PairsSummary
{
  int pairs = 0;
  double successShare = 0;
  double translationMedian_m = 0, translationP95_m = 0;
  double rotationMedian_rad = 0, rotationP95_rad = 0;
  int acceptedAndWrong = 0, failed = 0, degenerate = 0;
  double neesMean = 0;  //!< over usable matches with a covariance; 3 if the covariances are right
  double ellipsoidShare = 0;  //!< share of these with the truth inside the 95 % ellipsoid
  double timeMedian_s = 0, timeP95_s = 0;
  double sequentialTimeMedian_s = 0;
};

/** Computes the statistics of a run.
 *  @param limit of the errors of a success */
PairsSummary summarize(const std::vector<PairRecord>& records,
                       const PairError& limit = kSuccessLimit);

/** A table with a row for each run, and a row for the bound, if there is one, before the first run
 * of each kind of guess.
 *  @param bound of the errors on the same pairs
 *  @param baseline name of the matcher whose median time with the same guess is the unit of the
 *         column of time ratios; without a run of it the ratios are NaN
 *  @param limit of the errors of a success */
Table pairsTable(const std::string& title, const std::vector<PairsRun>& runs,
                 const std::optional<BoundSummary>& bound, const std::string& baseline,
                 const PairError& limit = kSuccessLimit);

/** The header of a CSV file with a row for each record of each run. */
std::string dumpHeader();
std::string dumpRows(const PairsRun& run);
}  // namespace psmks
