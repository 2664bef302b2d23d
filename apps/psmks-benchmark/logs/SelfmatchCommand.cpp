/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/logs/SelfmatchCommand.h>
#include <psmks/segmentation/Preprocessing.h>

namespace psmks
{
namespace
{
constexpr PairError kSuccess{0.01, degToRad(0.5)};
}  // namespace

SelfmatchCommand::SelfmatchCommand(CLI::App& app) : benchmark_(app, kSuccess)
{
  app.add_option("--displacement_m", displacement_m_, "of the guess, at most")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_option("--rotation_deg", rotation_deg_, "of the guess, at most, either way")
      ->check(CLI::Range(0.0, 180.0))
      ->capture_default_str();
  app.add_option("--seed", seed_, "of the guesses")->capture_default_str();
}

ExitCode SelfmatchCommand::run()
{
  return benchmark_.run([this](const Log& log, const SlamOptions&)
                        { return std::vector<LogPairs>{pairs(log)}; });
}

LogPairs SelfmatchCommand::pairs(const Log& log) const
{
  std::mt19937_64 random(seed_);
  std::uniform_real_distribution<double> share(0, 1);
  LogPairs set;
  Guesses guesses{"displaced", {}};
  for (std::size_t s = 0; s < log.scans.size(); ++s)
  {
    const Scan& scan = log.scans[s].scan;
    if (!hasReturns(scan)) continue;
    const double distance_m = displacement_m_ * share(random);
    const double rotation_rad = degToRad(rotation_deg_) * share(random);
    set.pairs.push_back({static_cast<int>(s), {}, {}, scan, scan});
    guesses.ofPair.push_back(displacedGuess({}, distance_m, rotation_rad, random));
  }
  set.title = log.title + ": " + std::to_string(set.pairs.size()) + " scans";
  set.guesses = {guesses};
  return set;
}
}  // namespace psmks
