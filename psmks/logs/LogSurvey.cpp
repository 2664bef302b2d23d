/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/logs/LogSurvey.h>

#include <algorithm>

namespace psmks
{
LogSurvey surveyLog(LogReader& reader)
{
  /** Scans of a log that are looked at. Unit: scans. Definition: five minutes of a common scanner,
   * so that a long log is not read twice. */
  constexpr int kMost = 3000;
  LogSurvey survey;
  PhantomRings rings;
  LaserFrame frame;
  for (int scan = 0; scan < kMost && reader.next(frame); ++scan) rings.add(*frame.scan);
  survey.phantomRings = rings.bands();
  const auto& scans = reader.scansOfSensors();
  const auto busiest = std::max_element(
      scans.begin(), scans.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  if (busiest != scans.end()) survey.busiestSensor = busiest->first;
  return survey;
}
}  // namespace psmks
