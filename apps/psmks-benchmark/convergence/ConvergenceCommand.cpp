/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/Machine.h>
#include <apps/psmks-benchmark/convergence/ConvergenceCommand.h>
#include <apps/psmks-benchmark/convergence/ConvergenceFigures.h>
#include <apps/psmks-benchmark/report/CommandLine.h>
#include <apps/psmks-benchmark/report/HtmlPage.h>
#include <apps/support/Progress.h>
#include <apps/support/StopSignal.h>
#include <apps/support/TextFile.h>

namespace psmks
{
ConvergenceCommand::ConvergenceCommand(CLI::App& app)
{
  options_.matchers = {"psmks", "psmks-paper", "psm", "icp-classic"};
  app.add_option("SET", sets_, "files of scan pairs (.pairs or .pairs.gz), or names of sets")
      ->required();
  addMatchersFlag(app, options_.matchers);
  app.add_option("--pairs", pairs_, "of each set; each is matched from every guess")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--max-distance_m", maxDistance_m_, "of a guess from the truth")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--max-rotation_deg", maxRotation_deg_, "of a guess from the truth")
      ->check(CLI::Range(0.0, 180.0))
      ->capture_default_str();
  app.add_option("--steps", steps_, "of distance and of rotation, from 0 to the largest")
      ->check(CLI::Range(2, 100))
      ->capture_default_str();
  app.add_option("--seed", options_.seed, "of the directions, and of generated sets")
      ->capture_default_str();
  optionFlags_.addTo(app);
  app.add_option("--output", folder_, "where convergence-MATCHER.png go")->type_name("DIR");
  app.add_option("--html", htmlPath_, "write tables and pictures as one page")->type_name("FILE");
  output_.addFlags(app);
}

ExitCode ConvergenceCommand::run()
{
  for (const auto& set : sets_)
    if (looksLikeASet(set)) pairFamily(set);
  options_.matcherOptions = optionFlags_.options().matching.matcher;
  checkMatchers(options_.matchers, options_.matcherOptions);
  options_.grid = ConvergenceGrid::even(maxDistance_m_, degToRad(maxRotation_deg_), steps_);
  output_.check();
  if (!htmlPath_.empty()) requireCreatable("--html", htmlPath_);
  if (!folder_.empty()) pictures_.emplace(folder_, "");

  for (const auto& set : sets_)
    if (!isToStop()) measure(inputPairs(set, {options_.seed, pairs_, pairs_}));
  if (!results_.empty()) write();
  if (damaged_) return kInputDamaged;
  return results_.empty() ? kNothingToDo : kOk;
}

void ConvergenceCommand::measure(const PairsInput& input)
{
  damaged_ = damaged_ || input.isDamaged;
  if (input.pairs.empty()) return;
  Progress progress(input.title);
  const auto show = [&progress](double share) { progress.show(share); };
  auto maps = measureConvergence(input.pairs, options_, show);
  if (!isToStop()) results_.push_back({input.title, std::move(maps)});
}

void ConvergenceCommand::write()
{
  std::vector<Table> tables;
  for (const SetResult& result : results_)
    tables.push_back(convergenceTable(result.title, options_.grid, result.maps));
  output_.write(tables);
  if (pictures_) savePictures();
  if (!htmlPath_.empty())
    writeTextFile(htmlPath_, [&](std::ostream& html) { html << page(tables); });
}

/** Saves a picture for each matcher, with all sets side by side. */
void ConvergenceCommand::savePictures()
{
  for (std::size_t m = 0; m < options_.matchers.size(); ++m)
  {
    const std::string& matcher = options_.matchers[m];
    Figure figure;
    figure.title = matcher;
    for (const SetResult& result : results_)
      figure.panels.emplace_back(convergencePicture(result.title, options_.grid, result.maps[m]));
    pictures_->add("convergence-" + matcher, "Area of convergence of " + matcher, figure);
  }
}

std::string ConvergenceCommand::page(const std::vector<Table>& tables) const
{
  HtmlPage page("Areas of convergence", {Machine::present().line(), commandLine()});
  for (std::size_t s = 0; s < results_.size(); ++s)
  {
    page.addHeading(results_[s].title);
    page.addCharts(convergencePictures(options_.grid, results_[s].maps));
    page.addTable(tables[s]);
  }
  return page.text();
}
}  // namespace psmks
