/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <string>

namespace psmks
{
/** What measured times depend on. */
struct Machine
{
  std::string processor;
  std::string compiler;
  std::string flags;  //!< of psmks_core
  std::string buildType;
  std::string commit;  //!< at configure time

  static Machine present();

  std::string line() const;
};
}  // namespace psmks
