/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/ConvergenceCommand.h>
#include <apps/psmks-benchmark/ConvergenceFigures.h>
#include <apps/psmks-benchmark/Machine.h>
#include <apps/psmks-benchmark/report/CommandLine.h>
#include <apps/psmks-benchmark/report/HtmlPage.h>
#include <apps/support/Assignment.h>
#include <apps/support/ExitCode.h>
#include <apps/support/Progress.h>
#include <psmks/mrpt/PairMatcher.h>

#include <iostream>

namespace psmks
{
ConvergenceCommand::ConvergenceCommand(CLI::App& app)
{
  options_.matchers = {"psmks", "psmks-paper", "psm", "icp-classic"};
  app.add_option("SET", sets_, "files of scan pairs (.pairs or .pairs.gz), or names of sets")
      ->required();
  app.add_option("--matchers", options_.matchers, "see psmks-benchmark matchers")
      ->delimiter(',')
      ->capture_default_str();
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
  app.add_option("--set", assignments_, "one option of psmks")->type_name("SECTION.KEY=VALUE");
  app.add_option("--output", folder_, "where convergence-MATCHER.png go")->type_name("DIR");
  app.add_option("--html", htmlPath_, "write tables and pictures as one page")->type_name("FILE");
  output_.addFlags(app);
}

int ConvergenceCommand::run()
{
  for (const auto& set : sets_)
    if (looksLikeASet(set)) pairFamily(set);
  OptionTable table = optionTable(options_.matcherOptions);
  assignOptions(table, assignments_);
  for (const auto& name : options_.matchers) makePairMatcher(name, options_.matcherOptions);
  options_.grid = ConvergenceGrid::even(maxDistance_m_, degToRad(maxRotation_deg_), steps_);
  output_.open();
  if (!htmlPath_.empty()) html_ = createFile("--html", htmlPath_);
  if (!folder_.empty()) pictures_.emplace(folder_, "");

  for (const auto& set : sets_) measure(input(set));
  if (!results_.empty()) write();
  if (damaged_) return kInputDamaged;
  return results_.empty() ? kNothingToDo : kOk;
}

PairsInput ConvergenceCommand::input(const std::string& argument)
{
  if (isGenerated(argument)) return generatedPairs(pairFamily(argument), options_.seed, pairs_);
  PairsInput input;
  try
  {
    readPairs(argument, pairs_, input);
  }
  catch (const PairsFileError& error)
  {
    damaged_ = true;
    std::cerr << "psmks-benchmark: " << error.what() << '\n';
  }
  return input;
}

void ConvergenceCommand::measure(const PairsInput& input)
{
  if (input.pairs.empty()) return;
  Progress progress(input.title);
  const auto show = [&progress](double share) { progress.show(share); };
  results_.push_back({input.title, measureConvergence(input.pairs, options_, show)});
}

void ConvergenceCommand::write()
{
  std::vector<Table> tables;
  for (const SetResult& result : results_)
    tables.push_back(convergenceTable(result.title, options_.grid, result.maps));
  output_.write(tables);
  if (pictures_) savePictures();
  if (html_.is_open()) html_ << page(tables);
}

/** One a matcher, all sets beside each other. */
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
    std::vector<Panel> pictures;
    for (const ConvergenceMap& map : results_[s].maps)
      pictures.emplace_back(convergencePicture(map.matcher, options_.grid, map));
    page.addHeading(results_[s].title);
    page.addCharts(pictures);
    page.addTable(tables[s]);
  }
  return page.text();
}
}  // namespace psmks
