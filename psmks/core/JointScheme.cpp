/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/core/FreeSpaceScore.h>
#include <psmks/core/JointScheme.h>
#include <psmks/core/JointSolver.h>
#include <psmks/core/Stopwatch.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace psmks
{
namespace
{
using Candidate = RefinedPose;

class JointMatch
{
 public:
  JointMatch(const Guess& guess, const JointOptions& options, const ExternalSolvers* external,
             JointBuffers& buffers, MatchTrace* trace)
      : guess_(guess), options_(options), external_(external), buffers_(buffers), trace_(trace)
  {
    const double sigma_m =
        std::max(buffers.reference.scan->rangeSigma_m, buffers.current.scan->rangeSigma_m);
    tolerance_m_ = surfaceTolerance_m(sigma_m);
    fewRaysSigma_m_ = kFewRays * sigma_m;
    result_.T_ref_cur = guess.T_ref_cur;
    if (!guess.covariance) return;
    result_.covariance = *guess.covariance;
    guessPrior_ = {guess.T_ref_cur, guess.covariance->inverse()};
  }

  MatchResult run()
  {
    const double guessScore = roughScore(guess_.T_ref_cur);
    result_.errorBefore = result_.errorAfter = 1 - guessScore;
    if (guessScore >= kPromising) consider(guess_.T_ref_cur);
    if (!isConvincing(best_)) searchFurther();
    if (!guess_.covariance && isConvincing(best_) && isWeaklyHeld()) challenge();
    return conclude();
  }

 private:
  static constexpr double kHopeless =
      0.75;  //!< rough score, as a share of the best, not worth a look
  static constexpr double kPromising = 0.5;  //!< rough score from which a guess is refined first

  // Two rays on a wall ahead, one of each scan, know the distance to sqrt(2) sigma: as well as this
  // by eight such pairs.
  static constexpr double kFewRays = 0.5;

  // ---- scores ---------------------------------------------------------------------------------

  /** Cheap score of a start that may be off by some centimetres: every fourth ray, one way. */
  double roughScore(const Pose2& T_ref_cur) const
  {
    constexpr float kRoughTolerance_m = 0.15f;
    constexpr int kStride = 4;
    return freeSpaceScore(countRays(buffers_.current.points, buffers_.reference.surface, T_ref_cur,
                                    kRoughTolerance_m, kStride));
  }

  /** Rays of both scans against the surfaces of the other: of scans with many rays every second,
   * every third, ..., for a share needs no more. */
  RayCounts allCounts(const Pose2& T_ref_cur) const
  {
    constexpr std::size_t kEnoughRays = 180;
    const auto strideOf = [&](const RayPoints& points)
    { return std::max(1, static_cast<int>(points.size() / kEnoughRays)); };
    const RayPoints &current = buffers_.current.points, &reference = buffers_.reference.points;
    RayCounts counts =
        countRays(current, buffers_.reference.surface, T_ref_cur, tolerance_m_, strideOf(current));
    counts += countRays(reference, buffers_.current.surface, T_ref_cur.inverse(), tolerance_m_,
                        strideOf(reference));
    return counts;
  }

  /** Rays of a scan that lie on surfaces of the other, mean of both scans. */
  double raysOn(const RayCounts& counts) const
  {
    const auto points =
        static_cast<double>(buffers_.current.points.size() + buffers_.reference.points.size());
    return 0.5 * points * counts.on / std::max(1, counts.counted());
  }

  /** Whether a candidate leaves no doubt: it has settled, its score is high, and lines hold it in
   * place where rays lie on surfaces. A pose half a degree off can still have its rays within the
   * tolerance of most surfaces, but the lines there are then no pairs. */
  bool isConvincing(const Candidate& candidate) const
  {
    const double enough =
        agreesWithGuess(candidate) ? options_.agreedScore : options_.confidentScore;
    return candidate.converged && candidate.score >= enough && isHeldByLines(candidate) &&
           (guess_.covariance || isPositionFixed(candidate));
  }

  static bool isHeldByLines(const Candidate& candidate)
  {
    constexpr double kFewestHeld = 0.5;
    return candidate.associations >= kFewestHeld * candidate.raysOn;
  }

  bool isPositionFixed(const Candidate& candidate) const
  {
    return candidate.observability.weakSigma_m <= options_.weakDirectionSigma_m;
  }

  /** What candidates are compared by. Along a wall poses explain the scans alike wherever they are,
   * but for a door jamb: one that has found it is worth more than one that slides. */
  double merit(const Candidate& candidate) const
  {
    constexpr double kSliding = 0.02;
    return candidate.score - (isPositionFixed(candidate) ? 0 : kSliding);
  }

  /** Whether the guess was measured and the candidate lies within its 95 % ellipsoid: two witnesses
   * for one pose. */
  bool agreesWithGuess(const Candidate& candidate) const
  {
    constexpr double kChi2At95With3Dof = 7.81;
    return guess_.covariance && chi2FromGuess(candidate.T_ref_cur) <= kChi2At95With3Dof;
  }

  /** Whether the guess was measured and the pose lies outside its 99.9 % ellipsoid. */
  bool contradictsGuess(const Pose2& T_ref_cur) const
  {
    constexpr double kChi2At999With3Dof = 16.27;
    return guess_.covariance && chi2FromGuess(T_ref_cur) > kChi2At999With3Dof;
  }

  double chi2FromGuess(const Pose2& T_ref_cur) const
  {
    const Pose2 &a = T_ref_cur, &b = guess_.T_ref_cur;
    const Eigen::Vector3d apart(a.x_m - b.x_m, a.y_m - b.y_m, wrapAngle(a.phi_rad - b.phi_rad));
    return apart.dot(guessPrior_.information * apart);
  }

  // ---- refinement -----------------------------------------------------------------------------

  /** Associations with gates that narrow, each followed by Gauss-Newton; where the last one moves
   * the pose far it is made again.
   *  @param firstShare of the gates, for the first association */
  Candidate refine(const Pose2& start, double firstShare)
  {
    constexpr double kLastShare = 0.25, kSettled = 0.1;
    constexpr int kMostRepeats = 2;
    Candidate candidate;
    candidate.T_ref_cur = start;
    for (int round = 0; round + 1 < options_.reassociations; ++round)
    {
      const double share = std::ldexp(firstShare, -round);
      const Pose2 motion = associate(share, false, candidate);
      if (candidate.associations < options_.minAssociations) return candidate;
      if (pairsMostRays(candidate) && isWithin(motion, share * kLastShare)) break;
    }
    const double lastShare = options_.reassociations > 1 ? kLastShare : firstShare;
    for (int repeat = 0; repeat <= kMostRepeats; ++repeat)
    {
      const Pose2 motion = associate(lastShare, true, candidate);
      if (candidate.associations < options_.minAssociations) break;
      if (isWithin(motion, lastShare * kSettled)) break;
    }
    return candidate;
  }

  /** One association and the pose that follows from it.
   *  @param share of the gates
   *  @param last whether to pair short lines and circles too, and to settle to the end
   *  @return the motion of the pose */
  Pose2 associate(double share, bool last, Candidate& candidate)
  {
    // A start is off by a tenth of the gates or so. Until then whole lines lead the way: single
    // rays are many, and those on other objects than their partners too.
    constexpr double kSlack = 0.1;
    PairingGates gates{share * options_.distanceGate_m, share * options_.angleGate_rad,
                       options_.singleRayWeight};
    gates.singleRaySlack_m = last ? 0 : kSlack * gates.distance_m;
    gates.fine = last;
    const Pose2 before = candidate.T_ref_cur;
    JointProblem& problem = buffers_.problem;
    problem.clear();
    problem.kernelWidth = options_.kernelWidth;
    problem.prior = guess_.covariance ? guessPrior_ : startPrior(before);
    candidate.associations =
        pairLines(buffers_.reference, buffers_.current, before, gates, problem);
    if (candidate.associations < options_.minAssociations) return {};
    candidate.converged =
        solve(problem, last ? finalLimits() : limitsWithin(gates), candidate.T_ref_cur);
    return before.inverse() * candidate.T_ref_cur;
  }

  bool pairsMostRays(const Candidate& candidate) const
  {
    return 2 * candidate.associations > buffers_.current.scan->rays();
  }

  bool pairsManyRays(const Candidate& candidate) const
  {
    return 4 * candidate.associations > buffers_.current.scan->rays();
  }

  /** Whether a motion is small beside this share of the gates. */
  bool isWithin(const Pose2& motion, double share) const
  {
    return motion.translation().norm() < share * options_.distanceGate_m &&
           std::abs(motion.phi_rad) < share * options_.angleGate_rad;
  }

  /** A pull towards the start of an association so weak that it acts only along what the scans do
   * not fix: there the estimate would wander with the noise. */
  static PriorTerm startPrior(const Pose2& start)
  {
    constexpr double kSigma_m = 0.3, kSigma_rad = degToRad(20);
    const Eigen::Vector3d information(1 / (kSigma_m * kSigma_m), 1 / (kSigma_m * kSigma_m),
                                      1 / (kSigma_rad * kSigma_rad));
    return {start, information.asDiagonal()};
  }

  SolverLimits finalLimits() const
  {
    return {options_.maxIterations, options_.stopTranslation_m, options_.stopRotation_rad};
  }

  /** Before another association, with gates half as wide, a pose need not settle to the end. */
  SolverLimits limitsWithin(const PairingGates& gates) const
  {
    constexpr double kShare = 0.01;
    return {options_.maxIterations, std::max(options_.stopTranslation_m, kShare * gates.distance_m),
            std::max(options_.stopRotation_rad, kShare * gates.angle_rad)};
  }

  bool solve(const JointProblem& problem, const SolverLimits& limits, Pose2& T_ref_cur)
  {
    if (options_.solver == JointSolver::Ceres) return external_->solveJoint(problem, T_ref_cur);
    const JointSolution solution = solveByGaussNewton(problem, limits, T_ref_cur);
    result_.iterations += solution.iterations;
    return solution.converged;
  }

  /** Refines a start and scores what comes of it; without enough associations the score is -1. */
  Candidate scored(const Pose2& start, double firstShare = 1)
  {
    Stopwatch watch;
    Candidate candidate = refine(start, firstShare);
    result_.times.refinement_s += watch.lap_s();
    if (candidate.associations < options_.minAssociations) return candidate;
    const RayCounts counts = allCounts(candidate.T_ref_cur);
    candidate.score = freeSpaceScore(counts);
    candidate.raysOn = raysOn(counts);
    candidate.information = linearise(buffers_.problem, candidate.T_ref_cur, false).H;
    candidate.observability = observability(candidate.information);
    candidate.angleVariance_rad2 = std::numeric_limits<double>::infinity();
    for (const LinePairTerm& pair : buffers_.problem.linePairs)
      candidate.angleVariance_rad2 =
          std::min(candidate.angleVariance_rad2, pair.angleVariance_rad2);
    result_.times.scoring_s += watch.lap_s();
    return candidate;
  }

  /** Refines a start and keeps what comes of it if it is the best so far. A start that explained
   * more before was drawn to lines that are not its own - the other face of a thin wall: once more
   * with narrower gates. */
  void consider(const Pose2& start)
  {
    ++result_.hypotheses;
    const Candidate candidate = scored(start);
    keepIfBest(candidate);
    const bool canNarrow = options_.reassociations > 1 && candidate.score > 0;
    if (!canNarrow || isConvincing(candidate)) return;
    if (freeSpaceScore(allCounts(start)) > candidate.score) keepIfBest(scored(start, 0.5));
  }

  void keepIfBest(const Candidate& candidate)
  {
    mostAssociations_ = std::max(mostAssociations_, candidate.associations);
    if (candidate.associations < options_.minAssociations) return;
    if (trace_)
      trace_->steps.push_back(
          {"gauss-newton", candidate.T_ref_cur, candidate.score, candidate.associations, 0});
    buffers_.considered.push_back(candidate);
    if (best_.score > 0 && merit(candidate) <= merit(best_)) return;
    best_ = candidate;
  }

  /** Of starts that explain the scans alike - a square room looks the same four ways - the one
   * nearer the guess goes first: at the limits of the search the score counts this much less. */
  double remoteness(const Pose2& T_ref_cur) const
  {
    constexpr double kAtLimits = 0.05;
    const Pose2 T_guess_start = guess_.T_ref_cur.inverse() * T_ref_cur;
    return kAtLimits *
           (std::abs(T_guess_start.phi_rad) / options_.searchAngle_rad +
            T_guess_start.translation().norm() / options_.searchRadius_m) /
           2;
  }

  void searchFurther()
  {
    Stopwatch watch;
    std::vector<Hypothesis>& hypotheses = buffers_.hypotheses;
    hypotheses.clear();
    const SearchLimits limits{options_.searchRadius_m, options_.searchAngle_rad,
                              options_.votedAngles};
    buffers_.search.propose(buffers_.reference, buffers_.current, guess_.T_ref_cur, limits,
                            hypotheses);
    if (result_.hypotheses == 0) hypotheses.push_back({guess_.T_ref_cur, 0, 0});
    for (Hypothesis& h : hypotheses) h.score = roughScore(h.T_ref_cur) - remoteness(h.T_ref_cur);
    std::sort(hypotheses.begin(), hypotheses.end(),
              [](const Hypothesis& a, const Hypothesis& b) { return a.score > b.score; });
    result_.times.search_s += watch.lap_s();

    const auto most =
        std::min(hypotheses.size(), static_cast<std::size_t>(options_.refinedHypotheses));
    for (std::size_t i = 0; i < most && !isConvincing(best_); ++i)
    {
      if (hypotheses[i].score < kHopeless * best_.score) break;
      consider(hypotheses[i].T_ref_cur);
    }
    if (!guess_.covariance && !isConvincing(best_) && pairsManyRays(best_)) slide();
  }

  /** Along a wall with little else to see, lines leave open where a pose is, and wrong pairs may
   * hold it anywhere. Single rays then know better: the places along the direction that is known
   * worst are scored, and those that explain more than the best pose so far, or about as much, are
   * refined. Where the guess was measured, it tells the place along the wall; and scans that have
   * little in common may fit anywhere by chance. */
  void slide()
  {
    findPlacesAlong();
    for (const Hypothesis& place : buffers_.hypotheses)
    {
      if (isConvincing(best_)) return;
      consider(place.T_ref_cur);
    }
  }

  void findPlacesAlong()
  {
    constexpr double kStep_m = 0.1;
    Stopwatch watch;
    const Eigen::Vector2d step_m = kStep_m * best_.observability.weakDirection;
    const int reach = static_cast<int>(options_.searchRadius_m / kStep_m);
    std::vector<Hypothesis>& places = buffers_.hypotheses;
    places.clear();
    for (int k = -reach; k <= reach; ++k)
    {
      const Pose2 T = moved(best_.T_ref_cur, k * step_m);
      const bool isKnown = std::abs(k) <= 1;
      places.push_back({T, isKnown ? 0.0 : 1.0, roughScore(T) - remoteness(T)});
    }
    keepPeaks(places);
    result_.times.search_s += watch.lap_s();
  }

  static Pose2 moved(const Pose2& T, const Eigen::Vector2d& by_m)
  {
    return {T.x_m + by_m.x(), T.y_m + by_m.y(), T.phi_rad};
  }

  /** Of scores in a row the highest maxima, highest first, among those with a vote. */
  static void keepPeaks(std::vector<Hypothesis>& row)
  {
    constexpr std::size_t kMost = 2;
    constexpr double kAsGood = 0.05;
    double best = 0;
    for (const Hypothesis& place : row) best = std::max(best, place.score);
    const auto notAbove = [&](std::size_t i, double score)
    { return i >= row.size() || row[i].score <= score; };
    std::size_t peaks = 0;
    for (std::size_t i = 0; i < row.size(); ++i)
    {
      const double own = row[i].score;
      if (!notAbove(i - 1, own) || !notAbove(i + 1, own) || own <= best - kAsGood) row[i].votes = 0;
      peaks += row[i].votes > 0;
    }
    std::sort(row.begin(), row.end(),
              [](const Hypothesis& a, const Hypothesis& b)
              { return a.votes != b.votes ? a.votes > b.votes : a.score > b.score; });
    row.resize(std::min(peaks, kMost));
  }

  // ---- conclusion -----------------------------------------------------------------------------

  MatchResult conclude()
  {
    if (mostAssociations_ < options_.minAssociations)
      return failed(MatchStatus::TooFewAssociations);
    result_.score = best_.score;
    result_.associations = best_.associations;
    const double enough =
        contradictsGuess(best_.T_ref_cur) ? options_.agreedScore : options_.acceptScore;
    if (best_.score < enough) return failed(MatchStatus::NoImprovement);

    Stopwatch watch;
    result_.status = best_.converged ? MatchStatus::Converged : MatchStatus::MaxIterations;
    result_.T_ref_cur = best_.T_ref_cur;
    result_.errorAfter = 1 - best_.score;
    settleUnobservable(best_.observability);
    const Eigen::Matrix3d prior = guess_.covariance
                                      ? guess_.covariance->inverse().eval()
                                      : MatchResult::unknownCovariance().inverse().eval();
    result_.covariance = (best_.information + prior).inverse();
    tellOfRivals();
    if (fewStraightLines() && isHeadingOpen()) leaveHeadingOpen(prior);
    result_.times.scoring_s += watch.lap_s();
    return result_;
  }

  // ---- rivals ---------------------------------------------------------------------------------

  /** Whether a direction is held by a few rays, of a door jamb or of somebody's legs. */
  bool isWeaklyHeld() const { return best_.observability.weakSigma_m > fewRaysSigma_m_; }

  /** Starts beside a pose that is weakly held and at other good places along the same walls: they
   * come back, or they are rivals. */
  void challenge()
  {
    constexpr double kAside_m = 0.2;
    const Pose2 held = best_.T_ref_cur;
    const Eigen::Vector2d aside_m = kAside_m * best_.observability.weakDirection;
    findPlacesAlong();
    consider(moved(held, aside_m));
    consider(moved(held, -aside_m));
    for (const Hypothesis& place : buffers_.hypotheses) consider(place.T_ref_cur);
  }

  /** Where another pose along the same walls explains as much, the position between both is open.
   */
  void tellOfRivals()
  {
    constexpr double kSameHeading_rad = degToRad(2), kElsewhere_m = 0.1;
    constexpr double kNearTie = 0.05, kNearTieUnheld = 0.2;
    const double tie = isHeldByLines(best_) ? kNearTie : kNearTieUnheld;
    for (const Candidate& other : buffers_.considered)
    {
      const Pose2 apart = best_.T_ref_cur.inverse() * other.T_ref_cur;
      const bool isElsewhere =
          apart.translation().norm() > kElsewhere_m && std::abs(apart.phi_rad) < kSameHeading_rad;
      if (!isElsewhere || other.score < best_.score - tie || contradictsGuess(other.T_ref_cur))
        continue;
      const Eigen::Vector2d between_m =
          other.T_ref_cur.translation() - best_.T_ref_cur.translation();
      result_.status = MatchStatus::Degenerate;
      result_.unobservableDirection = between_m.normalized();
      result_.covariance.topLeftCorner<2, 2>() += between_m * between_m.transpose();
    }
  }

  // ---- curved surroundings --------------------------------------------------------------------

  /** A curve is cut into short pieces of line, whose directions are no more than those of the
   * pieces: in a round room they pair up at any heading, each time with confidence. Where no pair
   * of lines is straight for long enough to know its direction well, the heading is put to the
   * test. */
  bool fewStraightLines() const
  {
    constexpr double kWellKnown_rad = degToRad(0.25);
    return best_.angleVariance_rad2 >= kWellKnown_rad * kWellKnown_rad;
  }

  bool explainsAsMuch(const Candidate& other) const
  {
    constexpr double kSameScore = 0.03;
    return other.score > best_.score - kSameScore;
  }

  /** Whether a start turned away, to either side, stays away and explains the scans as well. Where
   * a measured guess confirms the pose, one side is asked. */
  bool isHeadingOpen()
  {
    constexpr double kTurn_rad = degToRad(5);
    return staysAway(kTurn_rad) || (!agreesWithGuess(best_) && staysAway(-kTurn_rad));
  }

  bool staysAway(double turn_rad)
  {
    Pose2 turned = best_.T_ref_cur;
    turned.phi_rad = wrapAngle(turned.phi_rad + turn_rad);
    const Candidate other = scored(turned);
    const double apart_rad = wrapAngle(other.T_ref_cur.phi_rad - best_.T_ref_cur.phi_rad);
    return explainsAsMuch(other) && std::abs(apart_rad) > options_.weakHeadingSigma_rad;
  }

  /** The guess's heading, the position that goes with it, and its uncertainty. */
  void leaveHeadingOpen(const Eigen::Matrix3d& prior)
  {
    result_.status = MatchStatus::Degenerate;
    result_.headingUnobservable = true;
    Pose2 atGuess = best_.T_ref_cur;
    atGuess.phi_rad = guess_.T_ref_cur.phi_rad;
    const Candidate other = scored(atGuess);
    if (explainsAsMuch(other)) result_.T_ref_cur = other.T_ref_cur;
    result_.T_ref_cur.phi_rad = guess_.T_ref_cur.phi_rad;
    result_.covariance(2, 2) += 1 / prior(2, 2);
  }

  MatchResult failed(MatchStatus status)
  {
    result_.status = status;
    return result_;
  }

  /** What the scans do not fix is flagged, and where it is wide open put back to the guess. */
  void settleUnobservable(const Observability& o)
  {
    constexpr double kWideOpen_m = 0.05, kWideOpenWithPrior_m = 0.03;
    if (o.weakSigma_m > options_.weakDirectionSigma_m)
    {
      result_.status = MatchStatus::Degenerate;
      result_.unobservableDirection = o.weakDirection;
      if (o.weakSigma_m > (guess_.covariance ? kWideOpenWithPrior_m : kWideOpen_m))
      {
        const double moved_m =
            o.weakDirection.dot(result_.T_ref_cur.translation() - guess_.T_ref_cur.translation());
        result_.T_ref_cur.x_m -= moved_m * o.weakDirection.x();
        result_.T_ref_cur.y_m -= moved_m * o.weakDirection.y();
      }
    }
    if (o.headingSigma_rad > options_.weakHeadingSigma_rad)
    {
      result_.status = MatchStatus::Degenerate;
      result_.headingUnobservable = true;
      result_.T_ref_cur.phi_rad = guess_.T_ref_cur.phi_rad;
    }
  }

  const Guess& guess_;
  const JointOptions& options_;
  const ExternalSolvers* external_;
  JointBuffers& buffers_;
  MatchTrace* trace_;
  float tolerance_m_ = 0;
  double fewRaysSigma_m_ = 0;  //!< a direction known worse is held by a few rays alone
  PriorTerm guessPrior_;
  Candidate best_;
  int mostAssociations_ = 0;
  MatchResult result_;
};
}  // namespace

MatchResult matchByJointScheme(const SegmentedScan& reference, const SegmentedScan& current,
                               const Guess& guess, const JointOptions& options,
                               const ExternalSolvers* external, JointBuffers& buffers,
                               MatchTrace* trace)
{
  buffers.considered.clear();
  buffers.reference.build(reference);
  buffers.current.build(current);
  return JointMatch(guess, options, external, buffers, trace).run();
}
}  // namespace psmks
