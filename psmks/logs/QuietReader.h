/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/logs/LogReader.h>
#include <psmks/logs/PhantomRings.h>

#include <memory>
#include <vector>

namespace psmks
{
/** Reads a log and makes the readings invalid that are phantom rings. remarks() tells which values
 * these are, and of how many readings. */
class QuietReader : public LogReader
{
 public:
  QuietReader(std::unique_ptr<LogReader> log, std::vector<RangeBand> rings);

  bool next(LaserFrame& frame) override;
  std::vector<std::string> remarks() const override;
  const std::string& damage() const override { return log_->damage(); }
  int entriesRead() const override { return log_->entriesRead(); }
  const std::optional<std::string>& sensorLabel() const override { return log_->sensorLabel(); }
  const std::map<std::string, int>& scansOfSensors() const override
  {
    return log_->scansOfSensors();
  }
  int stampsMadeUp() const override { return log_->stampsMadeUp(); }
  double shareRead() const override { return log_->shareRead(); }

 private:
  std::unique_ptr<LogReader> log_;
  std::vector<RangeBand> rings_;  //!< with the readings that were made invalid
  long long readings_ = 0;
};
}  // namespace psmks
