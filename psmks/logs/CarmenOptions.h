/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <optional>

namespace psmks
{
/** The two times of a CARMEN message. */
enum class CarmenStamp
{
  Ipc,    //!< when it was made
  Logger  //!< when it was logged
};

/** What a user knows of a CARMEN log; goes before what the log says. */
struct CarmenOptions
{
  std::optional<double> increment_rad;    //!< between neighbouring rays
  std::optional<double> fieldOfView_rad;  //!< the first ray points to minus half of it
  std::optional<double> maxRange_m;       //!< readings at or beyond it are no returns
  std::optional<CarmenStamp> stamp;
};
}  // namespace psmks
