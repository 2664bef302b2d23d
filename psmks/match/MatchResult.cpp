/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/match/MatchResult.h>

#include <cmath>
#include <iomanip>
#include <sstream>

namespace psmks
{
namespace
{
void reportDirection(const char* what, const std::optional<Eigen::Vector2d>& direction,
                     std::ostream& out)
{
  if (!direction) return;
  const double along_rad = std::atan2(direction->y(), direction->x());
  out << "; " << what << " along " << std::setprecision(1) << radToDeg(along_rad) << " deg";
}

/** What the scans leave open, and whether they contradict the guess. */
void reportOpen(const MatchResult& match, std::ostream& out)
{
  reportDirection("not observable", match.unobservableDirection, out);
  reportDirection("weakly observable", match.weakDirection, out);
  if (match.headingUnobservable) out << "; heading not observable";
  if (match.ambiguity)
    out << "; " << match.ambiguity->alternatives
        << (match.ambiguity->alternatives == 1 ? " alternative" : " alternatives");
  if (match.guessGivenUp) out << "; guess given up";
  if (match.contradictsGuess())
    out << "; contradicts the guess, chi2 " << std::setprecision(1) << match.innovation->chi2
        << " of " << match.innovation->degreesOfFreedom;
}
}  // namespace

const char* toString(MatchStatus status)
{
  switch (status)
  {
    case MatchStatus::NotRun:
      return "NotRun";
    case MatchStatus::Converged:
      return "Converged";
    case MatchStatus::MaxIterations:
      return "MaxIterations";
    case MatchStatus::TooFewAssociations:
      return "TooFewAssociations";
    case MatchStatus::NoImprovement:
      return "NoImprovement";
    case MatchStatus::Degenerate:
      return "Degenerate";
    case MatchStatus::InvalidInput:
      return "InvalidInput";
  }
  return "?";
}

bool MatchResult::usable() const
{
  return status == MatchStatus::Converged || status == MatchStatus::MaxIterations ||
         status == MatchStatus::Degenerate;
}

Eigen::Matrix3d MatchResult::unknownCovariance()
{
  /** Standard deviation of a pose of which nothing is known. Evidence: a choice; wide beside what a
   * match knows, and finite, so that it can serve as a prior. */
  constexpr double kSigma_m = 1.0, kSigma_rad = degToRad(30);
  return Eigen::Vector3d(kSigma_m * kSigma_m, kSigma_m * kSigma_m, kSigma_rad * kSigma_rad)
      .asDiagonal();
}

bool MatchResult::contradictsGuess() const { return innovation && innovation->isContradiction(); }

std::optional<Eigen::Vector2d> MatchResult::ambiguousDirection() const
{
  if (!ambiguity) return std::nullopt;
  const Eigen::Vector2d apart_m =
      ambiguity->likeliest[0].T_ref_cur.translation() - T_ref_cur.translation();
  if (!(apart_m.norm() > 0)) return std::nullopt;
  return apart_m.normalized();
}

std::string MatchResult::report() const
{
  const auto sigma = [this](int i) { return std::sqrt(covariance(i, i)); };
  std::ostringstream out;
  out << std::fixed << toString(status) << ": x " << std::setprecision(4) << T_ref_cur.x_m
      << " m, y " << T_ref_cur.y_m << " m, phi " << std::setprecision(3)
      << radToDeg(T_ref_cur.phi_rad) << " deg; sigma " << std::setprecision(1) << 1e3 * sigma(0)
      << " mm, " << 1e3 * sigma(1) << " mm, " << std::setprecision(3) << radToDeg(sigma(2))
      << " deg; score " << std::setprecision(2) << score << ", " << associations
      << " associations, " << iterations << " iterations, " << std::setprecision(3)
      << 1e3 * times.total_s() << " ms";
  reportOpen(*this, out);
  return out.str();
}
}  // namespace psmks
