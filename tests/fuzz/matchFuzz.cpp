/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <fuzzer/FuzzedDataProvider.h>
#include <psmks/core/Matcher.h>
#include <psmks/geometry/Covariance.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

namespace
{
using namespace psmks;

/** Sets some options to texts that look like their values; those that are not accepted stay. */
MatcherOptions anyOptions(FuzzedDataProvider& input)
{
  MatcherOptions options;
  if (input.ConsumeBool()) options.choosePaperScheme();
  OptionTable table = optionTable(options);
  const auto fields = table.fields();
  for (int changes = input.ConsumeIntegralInRange(0, 8); changes > 0; --changes)
  {
    const OptionField& field =
        fields[input.ConsumeIntegralInRange<std::size_t>(0, fields.size() - 1)];
    const std::string choice = field.constraint.find('|') != std::string::npos
                                   ? field.constraint.substr(field.constraint.rfind(' ') + 1)
                                   : std::to_string(input.ConsumeFloatingPointInRange(-2.0, 60.0));
    try
    {
      field.set(choice);
    }
    catch (const OptionError&)
    {
      continue;
    }
  }
  return options;
}

Scan anyScan(FuzzedDataProvider& input)
{
  Scan scan;
  const int rays = input.ConsumeIntegralInRange(0, 360);
  const double first_rad = input.ConsumeFloatingPointInRange(-14.0, 14.0);
  const double increment_rad = input.ConsumeFloatingPointInRange(0.0, 0.1);
  if (BeamGrid::accepts(first_rad, increment_rad, rays))
    scan.grid = BeamGrid(first_rad, increment_rad, rays);
  else
    scan.grid = BeamGrid::centered(kPi, rays);
  scan.maxRange_m = input.ConsumeFloatingPoint<double>();
  scan.rangeSigma_m = input.ConsumeFloatingPointInRange(-0.1, 1.0);
  const double wall_m = input.ConsumeFloatingPointInRange(0.5, 20.0);
  for (int ray = 0; ray < rays; ++ray)
  {
    const int kind = input.ConsumeIntegralInRange(0, 15);
    const double bearing_rad = scan.grid.bearing_rad(ray);
    const double box_m =
        wall_m / std::max(std::abs(std::cos(bearing_rad)), std::abs(std::sin(bearing_rad)));
    scan.range_m.push_back(kind == 0   ? input.ConsumeFloatingPoint<double>()
                           : kind == 1 ? input.ConsumeFloatingPointInRange(0.0, 30.0)
                                       : box_m + 0.001 * kind);
  }
  return scan;
}

Guess anyGuess(FuzzedDataProvider& input)
{
  Guess guess;
  guess.T_ref_cur = {input.ConsumeFloatingPointInRange(-3.0, 3.0),
                     input.ConsumeFloatingPointInRange(-3.0, 3.0),
                     input.ConsumeFloatingPointInRange(-7.0, 7.0)};
  if (input.ConsumeIntegralInRange(0, 15) == 0)
    guess.T_ref_cur.x_m = input.ConsumeFloatingPoint<double>();
  if (!input.ConsumeBool()) return guess;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (int i = 0; i < 3; ++i) covariance(i, i) = input.ConsumeFloatingPointInRange(0.0, 4.0);
  if (input.ConsumeBool())
    covariance(1, 0) = covariance(0, 1) = input.ConsumeFloatingPoint<double>();
  guess.covariance = covariance;
  return guess;
}
}  // namespace

/** Two scans with any options and any guess end in a finite pose with a valid covariance. */
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  FuzzedDataProvider input(data, size);
  const MatcherOptions options = anyOptions(input);
  const auto scope = static_cast<SearchScope>(input.ConsumeIntegralInRange(0, 2));
  const Guess guess = anyGuess(input);
  const Scan reference = anyScan(input);
  const Scan current = input.ConsumeIntegralInRange(0, 3) ? reference : anyScan(input);
  try
  {
    const Matcher matcher(options);
    MatcherWorkspace workspace;
    const MatchResult result = matcher.match(reference, current, guess, workspace, nullptr, scope);
    const bool isValid = result.T_ref_cur.isFinite() && isCovariance(result.covariance) &&
                         result.score >= 0 && result.score <= 1;
    if (!isValid || result.report().size() > 1000) std::abort();
  }
  catch (const OptionError&)  // options that do not go together, or Ceres
  {
    return 0;
  }
  return 0;
}
