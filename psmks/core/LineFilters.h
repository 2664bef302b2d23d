/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/core/LineSums.h>

namespace psmks
{
/** What a line filter expects of the next ray. */
struct RangePrediction
{
  double range_m = 0;      //!< <= 0 where the ray does not meet the line
  double variance_m2 = 0;  //!< of measured minus predicted range
};

/** Kalman filter over consecutive rays, exactly linear: the state u = n / r0 measured by 1/r
 *  (LineSums). No start guess, no linearisation.
 *
 * Differs from the paper: its filter is the extended one below, which is inconsistent when started
 * from a few rays (docs/algorithm.md). */
class LinearLineFilter
{
 public:
  explicit LinearLineFilter(double sigma_m) : variance_m2_(sigma_m * sigma_m) {}

  /** Starts from the sums of a few rays; false where they fix no line. */
  bool start(const LineSums& seed);
  RangePrediction predict(double cosine, double sine) const;
  void update(double cosine, double sine, double range_m);

 private:
  double variance_m2_;
  LineSums sums_;
  LineSums::Solution solution_{};
};

/** The paper's extended Kalman filter on (r0, phi0) with the measurement r = r0 / cos(b - phi0). */
class PolarLineFilter
{
 public:
  explicit PolarLineFilter(double sigma_m) : variance_m2_(sigma_m * sigma_m) {}

  bool start(const LineSums& seed);
  RangePrediction predict(double cosine, double sine) const;
  void update(double cosine, double sine, double range_m);

  /** The state with its covariance. */
  Line line() const;

 private:
  struct Linearisation
  {
    double range_m;
    Eigen::RowVector2d H;
  };
  Linearisation linearise(double cosine, double sine) const;

  double variance_m2_;
  double r0_m_ = 0, phi0_rad_ = 0;
  Eigen::Matrix2d P_ = Eigen::Matrix2d::Zero();
};
}  // namespace psmks
