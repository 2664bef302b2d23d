/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/support/StopSignal.h>

#include <csignal>
#include <initializer_list>

namespace psmks
{
namespace
{
/** The first signal that asked to stop. A signal handler has no other way to tell. */
volatile std::sig_atomic_t firstStopSignal = 0;

void noteStopSignal(int signal)
{
  if (firstStopSignal == 0) firstStopSignal = signal;
}
}  // namespace

void catchStopSignals()
{
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
  {
    struct sigaction action = {}, before = {};
    action.sa_handler = noteStopSignal;
    action.sa_flags = static_cast<int>(SA_RESTART | SA_RESETHAND);
    sigaction(signal, nullptr, &before);
    const bool staysIgnored = signal == SIGHUP && before.sa_handler == SIG_IGN;
    if (!staysIgnored) sigaction(signal, &action, nullptr);
  }
}

int stopSignal() { return firstStopSignal; }

const char* nameOfSignal(int signal)
{
  switch (signal)
  {
    case SIGINT:
      return "SIGINT";
    case SIGTERM:
      return "SIGTERM";
    case SIGHUP:
      return "SIGHUP";
    default:
      return "a signal";
  }
}
}  // namespace psmks
