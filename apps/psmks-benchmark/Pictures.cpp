/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/Pictures.h>
#include <apps/support/ReplacedFile.h>

#include <filesystem>
#include <iostream>

namespace psmks
{
Pictures::Pictures(const std::string& reportFolder, const std::string& folder)
    : reportFolder_(reportFolder), folder_(folder)
{
  std::filesystem::create_directories(std::filesystem::path(reportFolder) / folder);
}

void Pictures::add(const std::string& name, const std::string& caption, const Figure& figure)
{
  const std::filesystem::path path = std::filesystem::path(folder_) / (name + ".png");
  std::string reason;
  const auto draw = [&](const std::string& beside) { return save(figure, beside, &reason); };
  if (replaceFile((std::filesystem::path(reportFolder_) / path).string(), draw))
  {
    saved_.push_back({caption, path.string()});
    return;
  }
  if (!failed_) std::cerr << "psmks-benchmark: no pictures: " << reason << '\n';
  failed_ = true;
}
}  // namespace psmks
