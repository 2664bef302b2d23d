/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/logs/OpenLog.h>

#include <optional>
#include <string>
#include <vector>

namespace CLI
{
class App;
}

namespace psmks
{
/** The flags that say how a log is read. */
class LogFlags
{
 public:
  /** Adds --sensor and the flags that begin with --carmen and --bag. */
  void addTo(CLI::App& app);

  LogOptions options() const;

  const std::optional<std::string>& sensor() const { return sensor_; }

 private:
  std::optional<std::string> sensor_;
  std::optional<double> increment_deg_, fieldOfView_deg_, maxRange_m_;
  std::optional<std::string> stamp_, bagOdometry_;
  std::vector<double> bagSensorPose_;  //!< x in m, y in m, phi in degrees, or nothing
};
}  // namespace psmks
