/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/logs/LogInput.h>
#include <apps/support/ExitCode.h>
#include <apps/support/GroundTruth.h>
#include <psmks/segmentation/Preprocessing.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

namespace psmks
{
namespace
{
bool isUsable(const std::vector<LogScan>& scans)
{
  return std::any_of(scans.begin(), scans.end(),
                     [](const LogScan& scan) { return hasReturns(scan.scan); });
}

/** The name of a file without its extensions. */
std::string titleOf(const std::filesystem::path& path)
{
  const std::filesystem::path name = path.extension() == ".gz" ? path.stem() : path.filename();
  return name.stem().string();
}

/** The path that a flag names, else the one beside the log. */
std::optional<std::string> chosen(const std::string& flag, const std::optional<std::string>& beside)
{
  return flag.empty() ? beside : std::make_optional(flag);
}
}  // namespace

void LogInput::addLogFlags(CLI::App& app)
{
  app.add_option("LOG", paths_, "MRPT rawlogs and CARMEN logs, compressed or not")->required();
  app.add_option("--skip-scans", skipScans_, "at the beginning of each log")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_option("--max-scans", maxScans_, "of each log; 0 = all")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  flags_.addTo(app);
}

void LogInput::addGroundTruthFlag(CLI::App& app)
{
  app.add_option("--ground-truth", groundTruth_,
                 "true trajectory of the one LOG X; default: X.reference.tum, X.gt.tum, X.GT.txt, "
                 "X_GT.txt or X.rawlog.GT.txt beside it, where there is one")
      ->type_name("FILE");
}

void LogInput::addRelationsFlag(CLI::App& app)
{
  app.add_option("--relations", relations_,
                 "true motions between scans of the one LOG X; default: X.relations beside it, "
                 "where there is one")
      ->type_name("FILE");
}

void LogInput::check() const
{
  const auto requireOneLog = [this](const char* flag, const std::string& value)
  {
    if (!value.empty() && paths_.size() > 1)
      throw CLI::ValidationError(flag, "belongs to one LOG, but there are several");
  };
  requireOneLog("--ground-truth", groundTruth_);
  requireOneLog("--relations", relations_);
}

std::vector<Log> LogInput::read(const ScanMatcherOptions& options)
{
  std::vector<Log> logs;
  for (const auto& path : paths_)
  {
    Log log = readLog(path, options);
    if (isUsable(log.scans)) logs.push_back(std::move(log));
  }
  return logs;
}

Log LogInput::readLog(const std::string& path, const ScanMatcherOptions& options)
{
  Log log;
  log.title = titleOf(path);
  readScans(path, options, log.scans);
  if (const auto truth = chosen(groundTruth_, groundTruthBeside(path)))
    log.groundTruth = readGroundTruth(*truth);
  if (const auto relations = chosen(relations_, relationsBeside(path)))
    log.relations = readTrueRelations(*relations);
  return log;
}

void LogInput::readScans(const std::string& path, const ScanMatcherOptions& options,
                         std::vector<LogScan>& scans)
{
  const auto reader = openLog(path, flags_.options());
  ScanConverter converter;
  int met = 0;
  for (LaserFrame frame; reader->next(frame); ++met)
  {
    if (met < skipScans_) continue;
    if (maxScans_ > 0 && met == skipScans_ + maxScans_) break;
    scans.push_back(toLogScan(frame, converter, options));
  }
  for (const std::string& remark : reader->remarks())
    std::cerr << "psmks-benchmark: '" << path << "': " << remark << '\n';
  if (!reader->damage().empty())
  {
    damaged_ = true;
    std::cerr << "psmks-benchmark: '" << path << "': " << reader->damage() << '\n';
  }
  else if (!isUsable(scans))
    std::cerr << "psmks-benchmark: '" << path << "' holds no usable 2D laser scan\n";
}
}  // namespace psmks
