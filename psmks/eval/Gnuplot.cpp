/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/eval/Gnuplot.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cctype>
#include <cstdio>
#include <cstring>
#include <memory>
#include <sstream>

namespace psmks
{
namespace
{
using File = std::unique_ptr<FILE, int (*)(FILE*)>;

/** A file without a name, which is removed when it is closed. */
File temporaryFile() { return {std::tmpfile(), std::fclose}; }

std::string textOf(FILE* file)
{
  std::rewind(file);
  std::string text;
  std::array<char, 4096> buffer{};
  while (const std::size_t size = std::fread(buffer.data(), 1, buffer.size(), file))
    text.append(buffer.data(), size);
  return text;
}

/** The first error message of gnuplot. Such a message follows the number of a line: "line 3:
 * unknown command". */
std::string firstErrorMessage(const std::string& messages)
{
  std::istringstream in(messages);
  for (std::string line; std::getline(in, line);)
  {
    const std::size_t number = line.find("line "), colon = line.find(':', number);
    if (number == std::string::npos || colon == std::string::npos) continue;
    const std::size_t text = line.find_first_not_of(' ', colon + 1);
    if (text != std::string::npos) return line.substr(text);
  }
  return "no reason given";
}

/** Starts gnuplot.
 *  @return 0 or an error number */
int start(FILE* script, FILE* output, FILE* messages, pid_t& process)
{
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, fileno(script), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&files, fileno(output), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&files, fileno(messages), STDERR_FILENO);
  std::string program = "gnuplot", settings = "--default-settings";
  std::array<char*, 3> arguments{program.data(), settings.data(), nullptr};
  const int error =
      posix_spawnp(&process, program.c_str(), &files, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  return error;
}
}  // namespace

std::string gnuplotString(const std::string& text)
{
  std::string quoted = "'";
  for (const char c : text)
  {
    quoted += std::iscntrl(static_cast<unsigned char>(c)) ? ' ' : c;
    if (c == '\'') quoted += c;
  }
  return quoted + '\'';
}

GnuplotRun runGnuplot(const std::string& script)
{
  const File input = temporaryFile(), output = temporaryFile(), messages = temporaryFile();
  if (!input || !output || !messages) return {"no temporary file can be made", ""};
  std::fwrite(script.data(), 1, script.size(), input.get());
  std::rewind(input.get());

  pid_t process = 0;
  if (const int error = start(input.get(), output.get(), messages.get(), process))
    return {std::string("gnuplot cannot be run: ") + std::strerror(error), ""};
  int status = 0;
  waitpid(process, &status, 0);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return {"", textOf(output.get())};
  return {"gnuplot failed: " + firstErrorMessage(textOf(messages.get())), ""};
}
}  // namespace psmks
