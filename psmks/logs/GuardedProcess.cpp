/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <fcntl.h>
#include <psmks/logs/GuardedProcess.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <initializer_list>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define PSMKS_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define PSMKS_SANITIZED 1
#endif
#endif

namespace psmks
{
namespace
{
#ifdef PSMKS_SANITIZED  // sanitizers reserve terabytes of addresses
void limitMemory(std::size_t) {}
#else
/** The address space that this process has. */
std::size_t addressSpace_bytes()
{
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

void limitMemory(std::size_t memory_bytes)
{
  const std::size_t most = addressSpace_bytes() + memory_bytes;
  const rlimit limit{most, most};
  setrlimit(RLIMIT_AS, &limit);
}
#endif
}  // namespace

void guardProcess(std::size_t memory_bytes)
{
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int ignored : {SIGINT, SIGHUP, SIGTERM}) signal(ignored, SIG_IGN);
  for (const int fatal : {SIGPIPE, SIGPROF, SIGSEGV, SIGABRT, SIGBUS, SIGFPE})
    signal(fatal, SIG_DFL);
  const int nowhere = open("/dev/null", O_RDWR);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, stream);
  const rlimit none{0, 0};
  setrlimit(RLIMIT_CORE, &none);
  limitMemory(memory_bytes);
}

void limitWorkingTime()
{
  /** Time for one piece of work. Unit: s. Definition: a hundred times that of a large image. */
  constexpr int kLongest_s = 5;
  const itimerval limit{{0, 0}, {kLongest_s, 0}};
  setitimer(ITIMER_PROF, &limit, nullptr);
}

bool endsWell(std::size_t memory_bytes, const std::function<void()>& work)
{
  const pid_t process = fork();
  if (process < 0) return false;
  if (process == 0)
  {
    guardProcess(memory_bytes);
    limitWorkingTime();
    try
    {
      work();
    }
    catch (...)
    {
      _exit(EXIT_FAILURE);
    }
    _exit(EXIT_SUCCESS);
  }
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) continue;
  return WIFEXITED(status) && WEXITSTATUS(status) == EXIT_SUCCESS;
}
}  // namespace psmks
