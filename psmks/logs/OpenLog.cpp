/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/gzip/GzipInput.h>
#include <psmks/logs/CarmenReader.h>
#include <psmks/logs/LogSurvey.h>
#include <psmks/logs/OpenLog.h>
#include <psmks/logs/QuietReader.h>
#include <psmks/logs/RawlogReader.h>

#include <algorithm>
#include <array>
#include <utility>

namespace psmks
{
namespace
{
std::unique_ptr<LogReader> openSensor(const std::string& path,
                                      const std::optional<std::string>& sensor,
                                      const LogOptions& options)
{
  if (isText(path)) return std::make_unique<CarmenReader>(path, sensor, options.carmen);
  return std::make_unique<RawlogReader>(path, sensor);
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

bool isText(const std::string& path)
{
  GzipInput file(path);
  if (!file.isOpen()) return false;
  std::array<char, 256> start{};
  const auto end =
      start.begin() + static_cast<std::ptrdiff_t>(file.Read(start.data(), start.size()));
  const auto isControl = [](char c)
  {
    const auto byte = static_cast<unsigned char>(c);
    return byte < ' ' && c != '\t' && c != '\r' && c != '\n';
  };
  return end != start.begin() && std::none_of(start.begin(), end, isControl);
}
}  // namespace psmks
