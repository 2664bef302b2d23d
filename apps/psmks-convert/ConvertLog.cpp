/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-convert/ConvertLog.h>
#include <apps/psmks-convert/LogSink.h>
#include <apps/support/LogScan.h>
#include <apps/support/Progress.h>
#include <apps/support/StopSignal.h>
#include <psmks/base/ShortText.h>
#include <psmks/logs/OpenLog.h>

#include <iostream>

namespace psmks
{
namespace
{
void complain(const std::string& input, const std::string& sentence)
{
  std::cerr << "psmks-convert: '" << input << "': " << sentence << '\n';
}

/** Reports a log of which nothing could be read.
 *  @throws ProgramError always */
[[noreturn]] void refuse(const std::string& input, const LogReader& reader)
{
  for (const auto& remark : reader.remarks()) complain(input, remark);
  if (!reader.damage().empty())
    throw ProgramError(kInputDamaged, "'" + input + "': " + reader.damage());
  const std::string others = quotedSensors(reader);
  throw ProgramError(kNothingToDo, others.empty()
                                       ? "'" + input + "' holds no 2D laser scan"
                                       : "'" + input + "' holds no scan of the sensor '" +
                                             *reader.sensorLabel() + "', but of " + others);
}

void report(const std::string& input, const LogReader& reader)
{
  for (const auto& remark : reader.remarks()) complain(input, remark);
  if (reader.stampsMadeUp() > 0)
    complain(input, std::to_string(reader.stampsMadeUp()) +
                        " scans without a stamp got one, 0.1 s after the scan before");
  if (reader.scansOfSensors().size() > 1)
    complain(input, "took the scanner '" + shortText(*reader.sensorLabel()) + "' of " +
                        quotedSensors(reader));
}
}  // namespace

ExitCode convertLog(const CommandLine& commandLine)
{
  const auto reader = openLog(commandLine.input, commandLine.logFlags.options());
  LaserFrame frame;
  if (!reader->next(frame)) refuse(commandLine.input, *reader);

  const auto sink = makeLogSink(commandLine);
  Progress progress("psmks-convert");
  int scans = 0;
  do
  {
    sink->write(frame);
    progress.show(reader->shareRead());
  } while (++scans != commandLine.maxScans && !isToStop() && reader->next(frame));

  report(commandLine.input, *reader);
  const std::string& made = commandLine.output.empty() ? commandLine.input : commandLine.output;
  const std::string content = sink->finish();
  std::cout << made << ": " << content << " of '" << shortText(*reader->sensorLabel()) << "'\n";
  if (reader->damage().empty()) return kOk;
  complain(commandLine.input, reader->damage());
  return kInputDamaged;
}
}  // namespace psmks
