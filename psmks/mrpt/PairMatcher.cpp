/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/mrpt/BuiltSolvers.h>
#include <psmks/mrpt/GuessPairMatcher.h>
#include <psmks/mrpt/IcpPairMatcher.h>
#include <psmks/mrpt/PairMatcher.h>
#include <psmks/mrpt/PsmksPairMatcher.h>

#include <functional>

namespace psmks
{
namespace
{
using mrpt::slam::TICPAlgorithm;

using Maker = std::function<std::unique_ptr<PairMatcher>(const std::string&, MatcherOptions)>;

std::unique_ptr<PairMatcher> makePsmks(const std::string& name, MatcherOptions options)
{
  return std::make_unique<PsmksPairMatcher>(name, std::move(options));
}

std::unique_ptr<PairMatcher> makePsmksPaper(const std::string& name, MatcherOptions options)
{
  if (options.scheme != Scheme::Paper) options.choosePaperScheme();
  return makePsmks(name, std::move(options));
}

std::unique_ptr<PairMatcher> makePsmksCeres(const std::string& name, MatcherOptions options)
{
  options.joint.solver = JointSolver::Ceres;
  options.paper.translationSolver = TranslationSolver::Ceres;
  return makePsmks(name, std::move(options));
}

template <TICPAlgorithm algorithm>
std::unique_ptr<PairMatcher> makeIcp(const std::string& name, MatcherOptions)
{
  return std::make_unique<IcpPairMatcher>(name, algorithm);
}

std::unique_ptr<PairMatcher> makeGuess(const std::string& name, MatcherOptions)
{
  return std::make_unique<GuessPairMatcher>(name);
}

using Makers = std::vector<std::pair<std::string, Maker>>;

Makers builtMakers()
{
  Makers makers{{"psmks", makePsmks},
                {"psmks-paper", makePsmksPaper},
                {"icp-classic", makeIcp<mrpt::slam::icpClassic>},
                {"icp-lm", makeIcp<mrpt::slam::icpLevenbergMarquardt>},
                {"guess", makeGuess}};
  if (builtSolvers()) makers.insert(makers.begin() + 1, {"psmks-ceres", makePsmksCeres});
  return makers;
}

const Makers& makers()
{
  static const Makers all = builtMakers();
  return all;
}
}  // namespace

std::vector<std::string> pairMatcherNames()
{
  std::vector<std::string> names;
  for (const auto& [name, maker] : makers()) names.push_back(name);
  return names;
}

std::unique_ptr<PairMatcher> makePairMatcher(const std::string& name, const MatcherOptions& options)
{
  std::string known;
  for (const auto& [knownName, make] : makers())
  {
    if (knownName == name) return make(name, options);
    known += (known.empty() ? "" : " | ") + knownName;
  }
  throw OptionError("matcher '" + name + "' is not known, allowed: " + known);
}
}  // namespace psmks
