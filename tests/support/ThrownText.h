/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <string>

namespace psmks::test
{
/** The text of the Exception that `action` throws, or "nothing was thrown". */
template <class Exception, class Action>
std::string thrownText(Action action)
{
  try
  {
    action();
  }
  catch (const Exception& error)
  {
    return error.what();
  }
  return "nothing was thrown";
}
}  // namespace psmks::test
