/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <optional>

namespace psmks
{
/** The two times of a CARMEN message. */
enum class CarmenStamp
{
  Ipc,    //!< when the message was made
  Logger  //!< when the message was logged
};

/** What a user knows about the scanner of a CARMEN log. It has priority over what the log states.
 */
struct CarmenOptions
{
  std::optional<double> increment_rad;    //!< between neighbouring rays
  std::optional<double> fieldOfView_rad;  //!< the first ray points to minus half of it
  std::optional<double> maxRange_m;       //!< readings at or beyond it are no returns
  std::optional<CarmenStamp> stamp;
};
}  // namespace psmks
