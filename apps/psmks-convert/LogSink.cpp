/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-convert/LogSink.h>
#include <apps/psmks-convert/PairsSink.h>
#include <apps/psmks-convert/SensorSink.h>
#include <apps/support/ReplacedFile.h>
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
      : path_(path), file_(path), writer_(RawlogWriter::Options{format, {}, {}})
  {
    requireCreated(writer_.open(file_.beside()), path);
  }

  void write(const LaserFrame& frame) override
  {
    requireWritten(writer_.write(frame), path_);
    ++scans_;
  }

  std::string finish() override
  {
    requireWritten(writer_.close() && file_.moveIntoPlace(), path_);
    return std::to_string(scans_) + " scans";
  }

 private:
  std::string path_;
  ReplacedFile file_;
  RawlogWriter writer_;
  int scans_ = 0;
};

class CarmenSink : public LogSink
{
 public:
  explicit CarmenSink(const std::string& path) : path_(path), file_(path)
  {
    requireCreated(writer_.open(file_.beside()), path);
  }

  void write(const LaserFrame& frame) override
  {
    requireWritten(writer_.write(frame), path_);
    ++scans_;
  }

  std::string finish() override
  {
    requireWritten(writer_.close() && file_.moveIntoPlace(), path_);
    return std::to_string(scans_) + " scans";
  }

 private:
  std::string path_;
  ReplacedFile file_;
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
