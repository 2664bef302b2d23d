/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/Machine.h>
#include <apps/psmks-benchmark/experiments/DrivePictures.h>
#include <apps/psmks-benchmark/experiments/ExperimentsCommand.h>
#include <apps/psmks-benchmark/experiments/OrientationFigure.h>
#include <apps/psmks-benchmark/experiments/Report.h>
#include <apps/psmks-benchmark/experiments/ResultTables.h>
#include <apps/support/Progress.h>
#include <apps/support/StopSignal.h>
#include <apps/support/TextFile.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

namespace psmks
{
namespace
{
constexpr double kSecondsPerMinute = 60;
constexpr double kLongRange_m = 30;

// Worlds of drives by the Area Center driver, with all maximum ranges of the command line.
const std::vector<std::string> kRoamed{"room", "clutter", "curved", "corridors"};

// Worlds of drives along a route, with the long maximum range.
const std::vector<std::string> kDriven{"office", "campus"};

const std::string kDefaultFolder = "docs";
const std::string kPictureFolder = "img/experiments";
const std::string kMappedMethod = "joint-map";

std::vector<std::string> knownMethods()
{
  std::vector<std::string> keys;
  for (const auto& method : experimentMethods()) keys.push_back(method.key);
  return keys;
}

bool contains(const std::vector<std::string>& words, const std::string& word)
{
  return std::find(words.begin(), words.end(), word) != words.end();
}
}  // namespace

ExperimentsCommand::ExperimentsCommand(CLI::App& app) : methodKeys_(knownMethods())
{
  worlds_ = kRoamed;
  worlds_.insert(worlds_.end(), kDriven.begin(), kDriven.end());
  app.add_flag("--quick", quick_, "one drive of at most a minute in each world at 30 m");
  app.add_option("--worlds", worlds_, "where to drive")
      ->delimiter(',')
      ->check(CLI::IsMember(worlds_))
      ->capture_default_str();
  app.add_option("--methods", methodKeys_, "what follows the robot")
      ->delimiter(',')
      ->check(CLI::IsMember(methodKeys_))
      ->capture_default_str();
  app.add_option("--ranges_m", ranges_m_, "of the laser, in the worlds without a route")
      ->delimiter(',')
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--seeds", seeds_, "drives in each world")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--first-seed", firstSeed_, "of the worlds, the wheels and the laser")
      ->capture_default_str();
  app.add_option("--minutes", minutes_, "of a drive at most")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  optionFlags_.addTo(app);
  app.add_option("--output", folder_,
                 "where experiments.md and its pictures go; default: " + kDefaultFolder +
                     ", with --quick nowhere")
      ->type_name("DIR");
  output_.addFlags(app);
}

ExitCode ExperimentsCommand::run()
{
  if (quick_) shorten();
  if (folder_.empty() && !quick_) folder_ = kDefaultFolder;
  setOptions();
  for (const auto& method : experimentMethods())
    if (contains(methodKeys_, method.key)) methods_.push_back(method);
  output_.check();
  if (!folder_.empty()) pictures_.emplace(folder_, kPictureFolder);

  const auto drives = plans();
  std::vector<DriveResult> results;
  {
    Progress progress("experiments");
    for (const auto& plan : drives)
    {
      if (isToStop()) break;
      progress.show(static_cast<double>(results.size()) / static_cast<double>(drives.size()));
      results.push_back(measure(plan));
    }
  }
  const std::vector<ResultGroup> groups = grouped(results);
  TableOutput::print(
      {driftTable(groups), reliabilityTable(groups), workTable(groups), driveTable(groups)});
  output_.save({runTable(results)});
  if (!folder_.empty()) save(results);
  return kOk;
}

void ExperimentsCommand::shorten()
{
  seeds_ = 1;
  minutes_ = std::min(minutes_, 1.0);
  ranges_m_ = {kLongRange_m};
}

void ExperimentsCommand::setOptions()
{
  const SlamOptions options = optionFlags_.options();
  matcherOptions_ = options.matching.matcher;
  odometryOptions_ = options.odometry;
}

std::vector<DrivePlan> ExperimentsCommand::plans() const
{
  std::vector<DrivePlan> plans;
  const auto add = [&](const std::string& world, double maxRange_m)
  {
    for (unsigned seed = firstSeed_; contains(worlds_, world) && seed < firstSeed_ + seeds_; ++seed)
      plans.push_back({world, seed, maxRange_m, minutes_ * kSecondsPerMinute});
  };
  for (const double range_m : ranges_m_)
    for (const auto& world : kRoamed) add(world, range_m);
  for (const auto& world : kDriven) add(world, kLongRange_m);
  return plans;
}

DriveResult ExperimentsCommand::measure(const DrivePlan& plan)
{
  const Drive drive = makeDrive(plan);
  std::vector<MethodRun> runs;
  for (const auto& method : methods_)
    runs.push_back(runMethod(drive, method, matcherOptions_, odometryOptions_));
  if (isPictured(plan)) draw(drive, runs);
  return summarise(drive, runs);
}

/** Pictures are made of the first drive in each world. */
bool ExperimentsCommand::isPictured(const DrivePlan& plan) const
{
  return pictures_ && plan.seed == firstSeed_ && plan.maxRange_m == kLongRange_m;
}

void ExperimentsCommand::draw(const Drive& drive, const std::vector<MethodRun>& runs)
{
  const std::string& site = drive.plan.site;
  const std::string drawn = site + ", first drive: ";
  pictures_->add(site, drawn + "paths, and errors along the way", pathFigure(drive, runs));
  for (const auto& run : runs)
    if (run.method.key == kMappedMethod)
      pictures_->add(site + "-maps", drawn + "maps", mapFigure(drive, run, matcherOptions_));
}

void ExperimentsCommand::save(const std::vector<DriveResult>& results)
{
  pictures_->add("orientation-search",
                 "The error of the orientation search on exact scans, without and with bad "
                 "associations: the paper's Fig. 1 (c) and (d)",
                 orientationExperiment(firstSeed_).figure);
  const auto path = std::filesystem::path(folder_) / "experiments.md";
  writeTextFile(path.string(), [&](std::ostream& out)
                { writeReport(out, results, pictures_->saved(), Machine::present().line()); });
  std::cout << "\nWrote " << path.string() << '\n';
}
}  // namespace psmks
