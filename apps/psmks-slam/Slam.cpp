/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-slam/MapWindow.h>
#include <apps/psmks-slam/Slam.h>
#include <apps/support/GroundTruth.h>
#include <apps/support/LogScan.h>
#include <apps/support/Overwriting.h>
#include <apps/support/Progress.h>
#include <apps/support/StopSignal.h>
#include <apps/support/TextFile.h>
#include <apps/support/UnitHints.h>
#include <psmks/base/ShortText.h>
#include <psmks/segmentation/Preprocessing.h>

#include <algorithm>
#include <iostream>

namespace psmks
{
namespace
{
/** The path of the output folder. By default "folder/My log.rawlog.gz" gives "My log-slam". */
std::string outputPath(const CommandLine& commandLine)
{
  if (!commandLine.output.empty()) return commandLine.output;
  std::string name = std::filesystem::path(commandLine.log).filename().string();
  for (const char* extension : {".gz", ".rawlog", ".log", ".clf", ".bag"})
  {
    const std::string ending(extension);
    if (name.size() > ending.size() &&
        name.compare(name.size() - ending.size(), ending.size(), ending) == 0)
      name.erase(name.size() - ending.size());
  }
  return name + "-slam";
}

/** Checks the command line before the output folder is created. */
const CommandLine& checked(const CommandLine& commandLine)
{
  if (commandLine.view) requireDisplay();
  for (const auto* file : {&commandLine.rawlog, &commandLine.graph})
    if (!file->empty()) requireReplaceable(*file, commandLine.overwrite);
  return commandLine;
}

std::optional<Trajectory> groundTruthOf(const CommandLine& commandLine)
{
  if (commandLine.groundTruth.empty()) return std::nullopt;
  return readGroundTruth(commandLine.groundTruth);
}

std::vector<Relation> relationsOf(const CommandLine& commandLine)
{
  if (commandLine.relations.empty()) return {};
  return readTrueRelations(commandLine.relations);
}

bool isOdometryAlone(const CommandLine& commandLine) { return commandLine.matcher == "odometry"; }

std::unique_ptr<PairMatcher> makeMatcher(const CommandLine& commandLine, const SlamOptions& options)
{
  return makePairMatcher(isOdometryAlone(commandLine) ? "guess" : commandLine.matcher,
                         options.matching.matcher);
}
}  // namespace

Slam::Slam(const CommandLine& commandLine, const SlamOptions& options)
    : commandLine_(checked(commandLine)),
      options_(options),
      groundTruth_(groundTruthOf(commandLine)),
      relations_(relationsOf(commandLine)),
      output_(outputPath(commandLine), commandLine.overwrite),
      reader_(openLog(commandLine.log, commandLine.logFlags.options())),
      builder_(makeMatcher(commandLine, options), options.reference, options.odometry)
{
  if (commandLine.rawlog.empty()) return;
  rawlogFile_.emplace(commandLine.rawlog);
  rawlog_.emplace();
  requireCreated(rawlog_->open(rawlogFile_->beside()), commandLine.rawlog);
}

ExitCode Slam::run()
{
  buildTrajectory();
  reportLog();
  if (isToStop() && builder_.scans().empty()) return kOk;  // nothing was done
  requireScans();

  const RunSummary summary = writeResults();
  printSummary(std::cout, summary);
  std::cout << "results          " << output_.path() << '\n';
  if (commandLine_.view && !isToStop())
    showMap(makeScanMap(builder_.scans(), options_.matching.matcher));
  return exitCodeOfRun(summary);
}

RunSummary Slam::writeResults()
{
  RunSummary summary{trajectorySummary(), std::nullopt, remarks(), {}};
  if (!relations_.empty())
    summary.relations = relationStatistics(trajectoryOf(builder_.scans()), relations_);
  RunResults results = runResults();
  writeFiles(results);
  times_.output_s += watch_.lap_s();
  summary.times = times_;
  output_.writeSummary(summary, options_);
  return summary;
}

RunResults Slam::runResults() const
{
  const std::string log = std::filesystem::path(commandLine_.log).filename().string();
  return {builder_.scans(), builder_.map(), options_.matching.matcher, simpleMap(),
          log + ", matcher " + commandLine_.matcher};
}

void Slam::writeFiles(RunResults& results)
{
  Progress progress("psmks-slam, writing");
  output_.write(results, commandLine_.outputs, [&progress](double share) { progress.show(share); });
  if (!commandLine_.graph.empty())
    output_.outputs().addText(commandLine_.graph,
                              [this](std::ostream& out) { writeGraph(out, builder_.map()); });
  if (rawlog_)
    output_.outputs().note(commandLine_.rawlog, rawlog_->close() && rawlogFile_->moveIntoPlace());
}

void Slam::buildTrajectory()
{
  Progress progress("psmks-slam");
  LaserFrame frame;
  const auto limit = static_cast<std::size_t>(commandLine_.maxScans);
  const auto isMoreWanted = [&]
  { return !isToStop() && (limit == 0 || builder_.scans().size() < limit); };
  while (isMoreWanted() && reader_->next(frame))
  {
    add(frame);
    progress.show(reader_->shareRead());
  }
  times_.reading_s += watch_.lap_s();
  builder_.optimise();
  divideBuildingTime();
}

/** The time of building that matches did not take is that of the references. */
void Slam::divideBuildingTime()
{
  times_.map_s += watch_.lap_s();
  for (const auto& scan : builder_.scans())
    for (const auto* matches : {&scan.matches, &scan.links})
      for (const auto& match : *matches)
      {
        const double segmentation_s = match.result.times.segmentation_s;
        times_.segmentation_s += segmentation_s;
        times_.matching_s += match.time_s - segmentation_s;
        times_.map_s -= match.time_s;
      }
}

void Slam::add(const LaserFrame& frame)
{
  LogScan scan = toLogScan(frame, converter_, options_.matching);
  const bool isFirst = builder_.scans().empty();
  if (!isFirst && !frame.odometry) ++scansWithoutOdometry_;
  times_.reading_s += watch_.lap_s();
  const PosedScan& posed = builder_.add(std::move(scan.scan), scan.T_robot_sensor, scan.odometry);
  times_.map_s += watch_.lap_s();
  keepKeyframes(frame);
  if (rawlog_) rawlog_->write(posed, frame);
  times_.output_s += watch_.lap_s();
  if (!commandLine_.verbose) return;
  for (const auto& match : posed.matches)
    std::cerr << "scan " << builder_.scans().size() << " to " << match.reference + 1 << ": "
              << match.result.report() << '\n';
}

/** A scan becomes a reference when it is added, or when the next scan is added. */
void Slam::keepKeyframes(const LaserFrame& frame)
{
  const auto& scans = builder_.scans();
  const std::size_t last = scans.size() - 1;
  if (lastFrame_ && scans[last - 1].isReference) keyframes_.emplace_back(last - 1, *lastFrame_);
  lastFrame_.reset();
  if (scans[last].isReference)
    keyframes_.emplace_back(last, frame);
  else
    lastFrame_ = frame;
}

/** The key frames with the final poses of their scans. */
mrpt::maps::CSimpleMap Slam::simpleMap() const
{
  mrpt::maps::CSimpleMap map;
  for (const auto& [index, frame] : keyframes_) addKeyframe(builder_.scans()[index], frame, map);
  return map;
}

void Slam::requireScans() const
{
  const auto& scans = builder_.scans();
  if (scans.empty() && !reader_->damage().empty())
    throw ProgramError(kInputDamaged, "'" + commandLine_.log + "': " + reader_->damage());
  if (scans.empty() && commandLine_.logFlags.sensor() && !reader_->scansOfSensors().empty())
    throw ProgramError(kNothingToDo, "'" + commandLine_.log + "' holds no scan of the sensor '" +
                                         *commandLine_.logFlags.sensor() + "', but of " +
                                         quotedSensors(*reader_));
  if (std::none_of(scans.begin(), scans.end(),
                   [](const PosedScan& posed) { return hasReturns(posed.scan); }))
    throw ProgramError(kNothingToDo, "'" + commandLine_.log + "' holds no usable 2D laser scan");
  const auto withoutOdometry = static_cast<std::size_t>(scansWithoutOdometry_);
  if (isOdometryAlone(commandLine_) && scans.size() > 1 && withoutOdometry + 1 == scans.size())
    throw ProgramError(kNothingToDo, "'" + commandLine_.log + "' holds no odometry");
}

/** Those of the reader, and what looks wrong in what was read. */
std::vector<std::string> Slam::remarks() const
{
  std::vector<std::string> remarks = reader_->remarks();
  for (const std::string& hint : unitHints(builder_.scans())) remarks.push_back(hint);
  return remarks;
}

void Slam::reportLog() const
{
  for (const auto& remark : remarks())
    std::cerr << "psmks-slam: '" << commandLine_.log << "': " << remark << '\n';
  if (commandLine_.logFlags.sensor() || reader_->scansOfSensors().size() < 2) return;
  std::cerr << "psmks-slam: used the scanner '" << shortText(*reader_->sensorLabel()) << "' of "
            << quotedSensors(*reader_) << ", --sensor chooses another\n";
}

LogSummary Slam::logSummary() const
{
  LogSummary log;
  log.path = commandLine_.log;
  log.sensor = reader_->sensorLabel().value_or("");
  log.entriesRead = reader_->entriesRead();
  log.damage = reader_->damage();
  log.scansWithoutOdometry = scansWithoutOdometry_;
  log.stampsMadeUp = reader_->stampsMadeUp();
  return log;
}

Summary Slam::trajectorySummary() const
{
  Summary result = summarise(builder_.scans(), groundTruth_);
  result.log = logSummary();
  result.matcher = commandLine_.matcher;
  if (isOdometryAlone(commandLine_)) result.unmatched = result.scans - 1;
  return result;
}

ExitCode Slam::exitCodeOfRun(const RunSummary& run)
{
  const Summary& result = run.trajectory;
  if (!output_.outputs().isComplete())
  {
    std::cerr << "psmks-slam: " << output_.outputs().complaint() << '\n';
    return kOutputFailed;
  }
  if (!reader_->damage().empty())
  {
    std::cerr << "psmks-slam: '" << commandLine_.log << "': " << reader_->damage() << '\n';
    return kInputDamaged;
  }
  if (groundTruth_ && !result.error)
  {
    std::cerr << "psmks-slam: ground truth '" << commandLine_.groundTruth
              << "' has no pose at the time of a scan\n";
    return kInputDamaged;
  }
  if (run.relations && run.relations->all.count == 0)
  {
    std::cerr << "psmks-slam: none of the relations '" << commandLine_.relations
              << "' is between two scans\n";
    return kInputDamaged;
  }
  if (result.matches > 0 && result.failures() == result.matches)
  {
    std::cerr << "psmks-slam: every match failed, the trajectory is that of the odometry\n";
    return kEveryMatchFailed;
  }
  return kOk;
}
}  // namespace psmks
