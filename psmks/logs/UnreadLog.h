/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/logs/LogKind.h>
#include <psmks/logs/LogReader.h>

#include <map>
#include <optional>
#include <string>

namespace psmks
{
/** Stands for a file that is no log. damage() says what it seems to be, and what psmks reads. */
class UnreadLog : public LogReader
{
 public:
  explicit UnreadLog(const LogKind& kind)
      : damage_("seems to be " + kind.seems +
                "; psmks reads MRPT rawlogs, CARMEN logs and ROS 1 bags" +
                (kind.advice.empty() ? "" : ": " + kind.advice))
  {
  }

  bool next(LaserFrame&) override { return false; }
  const std::string& damage() const override { return damage_; }
  int entriesRead() const override { return 0; }
  const std::optional<std::string>& sensorLabel() const override { return sensorLabel_; }
  const std::map<std::string, int>& scansOfSensors() const override { return scansOfSensors_; }
  int stampsMadeUp() const override { return 0; }
  double shareRead() const override { return 1; }

 private:
  std::string damage_;
  std::optional<std::string> sensorLabel_;
  std::map<std::string, int> scansOfSensors_;
};
}  // namespace psmks
