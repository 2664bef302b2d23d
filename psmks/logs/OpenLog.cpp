/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/logs/CarmenReader.h>
#include <psmks/logs/LogKind.h>
#include <psmks/logs/LogSurvey.h>
#include <psmks/logs/OpenLog.h>
#include <psmks/logs/QuietReader.h>
#include <psmks/logs/RawlogReader.h>
#include <psmks/logs/RosBagReader.h>
#include <psmks/logs/UnreadLog.h>

#include <utility>

namespace psmks
{
namespace
{
std::unique_ptr<LogReader> openSensor(const std::string& path,
                                      const std::optional<std::string>& sensor,
                                      const LogOptions& options)
{
  const LogKind kind = recogniseLog(path);
  if (kind.reading == LogReading::None) return std::make_unique<UnreadLog>(kind);
  if (kind.reading == LogReading::Rawlog) return std::make_unique<RawlogReader>(path, sensor);
  if (kind.reading == LogReading::RosBag)
    return std::make_unique<RosBagReader>(path, sensor, options.rosBag);
  auto carmen = std::make_unique<CarmenReader>(path, sensor, options.carmen);
  if (!carmen->damage().empty() && !kind.seems.empty()) return std::make_unique<UnreadLog>(kind);
  return carmen;
}
}  // namespace

std::unique_ptr<LogReader> openLog(const std::string& path, const LogOptions& options)
{
  std::optional<std::string> sensor = options.sensorLabel;
  const auto surveyed = openSensor(path, sensor, options);
  LogSurvey survey = surveyLog(*surveyed);
  if (!sensor && survey.busiestSensor != surveyed->sensorLabel())
  {
    sensor = survey.busiestSensor;
    survey = surveyLog(*openSensor(path, sensor, options));
  }
  auto log = openSensor(path, sensor, options);
  if (survey.phantomRings.empty()) return log;
  return std::make_unique<QuietReader>(std::move(log), survey.phantomRings);
}
}  // namespace psmks
