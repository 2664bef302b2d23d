/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <string>

namespace psmks
{
/** Everything besides the input that measured times depend on. */
struct Machine
{
  std::string processor;
  std::string compiler;
  std::string flags;  //!< compiler flags of psmks_core
  std::string buildType;
  std::string commit;  //!< commit at the time of the configuration

  static Machine present();

  std::string line() const;
};
}  // namespace psmks
