/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-convert/LogSink.h>
#include <apps/psmks-convert/PairsSink.h>
#include <apps/psmks-convert/SensorSink.h>
#include <apps/support/TextFile.h>
#include <psmks/logs/CarmenWriter.h>
#include <psmks/logs/RawlogWriter.h>

namespace psmks
{
namespace
{
class RawlogSink : public LogSink
{
 public:
  RawlogSink(const std::string& path, RawlogFormat format)
      : writer_(RawlogWriter::Options{format, {}, {}})
  {
    requireWritten(writer_.open(path), path);
  }

  void write(const LaserFrame& frame) override
  {
    writer_.write(frame);
    ++scans_;
  }

  std::string finish() override { return std::to_string(scans_) + " scans"; }

 private:
  RawlogWriter writer_;
  int scans_ = 0;
};

class CarmenSink : public LogSink
{
 public:
  explicit CarmenSink(const std::string& path) : path_(path)
  {
    requireWritten(writer_.open(path), path);
  }

  void write(const LaserFrame& frame) override
  {
    requireWritten(writer_.write(frame), path_);
    ++scans_;
  }

  std::string finish() override
  {
    requireWritten(writer_.close(), path_);
    return std::to_string(scans_) + " scans";
  }

 private:
  std::string path_;
  CarmenWriter writer_;
  int scans_ = 0;
};
}  // namespace

std::unique_ptr<LogSink> makeLogSink(const CommandLine& c)
{
  if (c.sensorReport) return std::make_unique<SensorSink>(c.output);
  switch (c.outputKind())
  {
    case OutputKind::Rawlog:
      return std::make_unique<RawlogSink>(
          c.output, c.observations ? RawlogFormat::Observations : RawlogFormat::Actions);
    case OutputKind::Carmen:
      return std::make_unique<CarmenSink>(c.output);
    case OutputKind::Pairs:
      return std::make_unique<PairsSink>(c.output, c.groundTruth, c.every);
    default:
      throw ProgramError(kUsage,
                         "'" + c.input + "' is a log, of which no '" + c.output + "' can be made");
  }
}
}  // namespace psmks
