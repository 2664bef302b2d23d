/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/experiments/Pictures.h>

#include <filesystem>
#include <iostream>

namespace psmks
{
namespace
{
const std::filesystem::path kFolder = std::filesystem::path("img") / "experiments";
}

Pictures::Pictures(const std::string& reportFolder) : reportFolder_(reportFolder)
{
  std::filesystem::create_directories(reportFolder / kFolder);
}

void Pictures::add(const std::string& name, const std::string& caption, const Figure& figure)
{
  const std::filesystem::path path = kFolder / (name + ".png");
  std::string reason;
  if (save(figure, (reportFolder_ / path).string(), &reason))
  {
    saved_.push_back({caption, path.string()});
    return;
  }
  if (!failed_) std::cerr << "psmks-benchmark: no pictures: " << reason << '\n';
  failed_ = true;
}
}  // namespace psmks
