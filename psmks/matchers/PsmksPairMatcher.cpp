/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/base/Stopwatch.h>
#include <psmks/core/Matcher.h>
#include <psmks/matchers/BuiltSolvers.h>
#include <psmks/matchers/PairMatcherRegistration.h>

namespace psmks
{
namespace
{
/** psmks::Matcher with a workspace of its own. A prepared scan is a segmented one. */
class PsmksPairMatcher : public PairMatcher
{
 public:
  /** @throws OptionError where the options choose a solver that was not built */
  PsmksPairMatcher(std::string name, MatcherOptions options)
      : name_(std::move(name)), matcher_(options, builtSolvers())
  {
  }

  std::string name() const override { return name_; }

  MatchResult match(const Scan& reference, const Scan& current, const Guess& guess) override
  {
    return matcher_.match(reference, current, guess, workspace_);
  }

  std::unique_ptr<PreparedScan> prepare(const Scan& scan, const ScannerNoise& scanner) override
  {
    SegmentedScan segmented;
    matcher_.segment(scan, workspace_, segmented, scanner);
    const bool showsMoreNoise = segmented.showsMoreNoise;
    return std::make_unique<PreparedAs<SegmentedScan>>(std::move(segmented), showsMoreNoise);
  }

  MatchResult matchPrepared(const PreparedScan& reference, const PreparedScan& current,
                            const Guess& guess, SearchScope scope) override
  {
    return matcher_.match(dataOf<SegmentedScan>(reference), dataOf<SegmentedScan>(current), guess,
                          workspace_, nullptr, scope);
  }

 private:
  std::string name_;
  Matcher matcher_;
  MatcherWorkspace workspace_;
};

std::unique_ptr<PairMatcher> makePsmks(const std::string& name, MatcherOptions options)
{
  return std::make_unique<PsmksPairMatcher>(name, options);
}

std::unique_ptr<PairMatcher> makePaper(const std::string& name, MatcherOptions options)
{
  if (options.scheme != Scheme::Paper) options.choosePaperScheme();
  return makePsmks(name, options);
}

const PairMatcherRegistration kPsmks({"psmks", "PSM-KS, its options as they are",
                                      PairMatcherFamily::Psmks, 0, makePsmks});
const PairMatcherRegistration kPaper({"psmks-paper", "PSM-KS as in the paper",
                                      PairMatcherFamily::Psmks, 2, makePaper});

#ifdef PSMKS_WITH_CERES
void chooseCeres(MatcherOptions& options)
{
  options.joint.solver = JointSolver::Ceres;
  options.paper.translationSolver = TranslationSolver::Ceres;
}

std::unique_ptr<PairMatcher> makePsmksCeres(const std::string& name, MatcherOptions options)
{
  chooseCeres(options);
  return makePsmks(name, options);
}

std::unique_ptr<PairMatcher> makePaperCeres(const std::string& name, MatcherOptions options)
{
  chooseCeres(options);
  return makePaper(name, options);
}

const PairMatcherRegistration kCeres({"psmks-ceres", "psmks, solved by Ceres",
                                      PairMatcherFamily::Psmks, 1, makePsmksCeres});
const PairMatcherRegistration kPaperCeres({"psmks-paper-ceres", "psmks-paper, solved by Ceres",
                                           PairMatcherFamily::Psmks, 3, makePaperCeres});
#endif
}  // namespace
}  // namespace psmks
