/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/support/StopSignal.h>

#include <csignal>
#include <ctime>
#include <initializer_list>

namespace psmks
{
namespace
{
/** The first signal that asked to stop. A signal handler has no other way to tell. */
volatile std::sig_atomic_t firstStopSignal = 0;

/** When it came, in seconds of a clock that never goes back. */
volatile std::sig_atomic_t firstStopSignal_s = 0;

std::sig_atomic_t now_s()
{
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<std::sig_atomic_t>(now.tv_sec);
}

/** Calls only what may be called while anything else is interrupted. */
void noteStopSignal(int signal)
{
  /** A signal that comes again within this time is the same wish, sent to the program and to its
   * group, as timeout(1) does. Unit: s. Definition: less than a user needs to want more. */
  constexpr int kSameWish_s = 1;
  if (firstStopSignal == 0)
  {
    firstStopSignal_s = now_s();
    firstStopSignal = signal;
  }
  else if (now_s() - firstStopSignal_s > kSameWish_s)
  {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
}
}  // namespace

void catchStopSignals()
{
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
  {
    struct sigaction action = {}, before = {};
    action.sa_handler = noteStopSignal;
    action.sa_flags = SA_RESTART;
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
