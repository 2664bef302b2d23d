/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/logs/LogReader.h>
#include <psmks/logs/PhantomRings.h>

#include <optional>
#include <string>
#include <vector>

namespace psmks
{
/** What is looked for in a log before it is read: in its first 3,000 scans. */
struct LogSurvey
{
  std::optional<std::string> busiestSensor;  //!< the one with most scans; none where there is none
  std::vector<RangeBand> phantomRings;       //!< of the sensor that was read
};

/** Surveys a log that has been opened, which is read meanwhile. */
LogSurvey surveyLog(LogReader& reader);
}  // namespace psmks
