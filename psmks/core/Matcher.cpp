/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/base/Stopwatch.h>
#include <psmks/core/Matcher.h>
#include <psmks/geometry/Covariance.h>
#include <psmks/joint/JointScheme.h>
#include <psmks/match/KeptGuess.h>
#include <psmks/paper/PaperScheme.h>
#include <psmks/segmentation/Segmentation.h>

#include <utility>

namespace psmks
{
struct MatcherWorkspace::Buffers
{
  SegmentationBuffers segmentation;
  SegmentedScan reference, current;
  JointBuffers joint;
  PaperBuffers paper;
};

MatcherWorkspace::MatcherWorkspace() : buffers_(std::make_unique<Buffers>()) {}
MatcherWorkspace::~MatcherWorkspace() = default;
MatcherWorkspace::MatcherWorkspace(MatcherWorkspace&&) noexcept = default;
MatcherWorkspace& MatcherWorkspace::operator=(MatcherWorkspace&&) noexcept = default;

namespace
{
bool needsExternalSolvers(const MatcherOptions& options)
{
  return options.paper.translationSolver == TranslationSolver::Ceres ||
         options.joint.solver == JointSolver::Ceres;
}

/** Whether a guess is a place that single precision can compute with. */
bool isPlace(const Pose2& pose)
{
  /** Farthest place. Definition: its square, and that of what is near it, is a float. */
  constexpr double kFarthest_m = 1e15;
  return pose.isFinite() && pose.translation().norm() < kFarthest_m;
}

bool isUsable(const Guess& guess)
{
  return isPlace(guess.T_ref_cur) && (!guess.covariance || isCovariance(*guess.covariance));
}
}  // namespace

Matcher::Matcher(MatcherOptions options, std::shared_ptr<const ExternalSolvers> externalSolvers)
    : options_(options), externalSolvers_(std::move(externalSolvers))
{
  options_.validate();
  if (needsExternalSolvers(options_) && !externalSolvers_)
    throw OptionError(
        "option 'solver' or 'translation_solver': 'ceres' is not accepted, no Ceres solvers were "
        "given to the matcher");
}

void Matcher::segment(const Scan& scan, MatcherWorkspace& workspace, SegmentedScan& result,
                      const ScannerNoise& scanner) const
{
  segmentScan(scan, options_.preprocessing, options_.segmentation, workspace.buffers_->segmentation,
              result, scanner);
}

MatchResult Matcher::match(const SegmentedScan& reference, const SegmentedScan& current,
                           const Guess& guess, MatcherWorkspace& workspace, MatchTrace* trace,
                           SearchScope scope) const
{
  const bool usable = isUsable(guess) && reference.hasValidRay() && current.hasValidRay();
  if (!usable) return keptGuess(MatchStatus::InvalidInput, guess);
  const Guess bounded = boundedGuess(guess);
  MatchResult result =
      options_.scheme == Scheme::Paper
          ? matchByPaperScheme(reference, current, bounded, options_.paper, externalSolvers_.get(),
                               workspace.buffers_->paper, trace)
          : matchByJointScheme(reference, current, bounded, scope, options_.joint,
                               externalSolvers_.get(), workspace.buffers_->joint, trace);
  addWholeScanErrors(options_.wholeScan, result);
  settleCovariance(bounded, result);
  return result;
}

MatchResult Matcher::match(const Scan& reference, const Scan& current, const Guess& guess,
                           MatcherWorkspace& workspace, MatchTrace* trace, SearchScope scope) const
{
  Stopwatch watch;
  MatcherWorkspace::Buffers& buffers = *workspace.buffers_;
  segment(reference, workspace, buffers.reference);
  segment(current, workspace, buffers.current);
  const double segmentation_s = watch.lap_s();
  MatchResult result = match(buffers.reference, buffers.current, guess, workspace, trace, scope);
  result.times.segmentation_s += segmentation_s;
  return result;
}
}  // namespace psmks
