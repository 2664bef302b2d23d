/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/support/Outputs.h>
#include <apps/support/ReplacedFile.h>

#include <fstream>

namespace psmks
{
void Outputs::add(const std::string& path, const std::function<bool(const std::string&)>& write)
{
  note(path, replaceFile(path, write));
}

void Outputs::addText(const std::string& path, const std::function<void(std::ostream&)>& write)
{
  add(path,
      [&write](const std::string& beside)
      {
        std::ofstream file(beside, std::ios::binary);
        write(file);
        file.close();
        return !file.fail();
      });
}

void Outputs::note(const std::string& path, bool isWritten)
{
  if (!isWritten) failed_.push_back(path);
}

std::string Outputs::complaint() const
{
  std::string names;
  for (const std::string& path : failed_) names += (names.empty() ? "'" : ", '") + path + "'";
  return names.empty() ? "" : "cannot write " + names;
}

void Outputs::requireComplete() const
{
  if (!isComplete()) throw ProgramError(kOutputFailed, complaint());
}
}  // namespace psmks
