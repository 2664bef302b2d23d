/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-convert/LogSink.h>
#include <psmks/eval/SensorSurvey.h>
#include <psmks/motion/SequenceDeskewer.h>
#include <psmks/mrpt/Convert.h>

#include <string>

namespace psmks
{
/** Prints what the scans of a log tell of their scanner's noise, and writes it as a sensor file
 * with a picture beside it. */
class SensorSink : public LogSink
{
 public:
  /** @param path of the sensor file, ending in .ini; empty: nothing is written */
  explicit SensorSink(std::string path) : path_(std::move(path)), survey_(MatcherOptions()) {}

  void write(const LaserFrame& frame) override;
  std::string finish() override;

 private:
  std::string path_;
  ScanConverter converter_;
  SequenceDeskewer deskewer_;
  SensorSurvey survey_;
  int scans_ = 0;
};
}  // namespace psmks
