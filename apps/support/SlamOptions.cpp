/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/support/Assignment.h>
#include <apps/support/SlamOptions.h>
#include <mrpt/config/CConfigFile.h>
#include <psmks/mrpt/ConfigFile.h>

#include <algorithm>
#include <filesystem>

namespace psmks
{
namespace
{
constexpr const char* kMatchingSection = "psmks";
constexpr const char* kSlamSection = "slam";

OptionTable slamTable(SlamOptions& options)
{
  OptionTable table;
  listFields(table, options.reference);
  listFields(table, options.odometry);
  return table;
}

bool hasSection(const OptionTable& table, const std::string& name)
{
  const auto& sections = table.sections();
  return std::any_of(sections.begin(), sections.end(),
                     [&](const OptionTable::Section& section) { return section.name == name; });
}

bool hasOurSections(const mrpt::config::CConfigFile& file)
{
  std::vector<std::string> sections;
  file.getAllSections(sections);
  return std::any_of(sections.begin(), sections.end(),
                     [](const std::string& section)
                     {
                       return section.rfind(std::string(kMatchingSection) + ".", 0) == 0 ||
                              section.rfind(std::string(kSlamSection) + ".", 0) == 0;
                     });
}
}  // namespace

void SlamOptions::load(const std::string& path)
{
  if (!std::filesystem::is_regular_file(path))
    throw OptionError("configuration file '" + path + "': no such file");
  const mrpt::config::CConfigFile file(path);
  if (!hasOurSections(file))
    throw OptionError("configuration file '" + path +
                      "': holds neither a section [psmks.<stage>] nor [slam.<stage>]");
  matching.loadFromConfigFile(file, kMatchingSection);
  OptionTable slam = slamTable(*this);
  loadOptions(slam, file, kSlamSection);
}

void SlamOptions::set(const std::string& assignment)
{
  const auto [section, key, value] = parseAssignment(assignment);
  OptionTable matchingOptions = optionTable(matching), slam = slamTable(*this);
  OptionTable& table = hasSection(slam, section) ? slam : matchingOptions;
  table.set(section, key, value);
}

std::string SlamOptions::toIni()
{
  return optionTable(matching).toIni(std::string(kMatchingSection) + ".") +
         slamTable(*this).toIni(std::string(kSlamSection) + ".");
}

std::string SlamOptions::toMarkdown()
{
  const auto chapter = [](const char* title, const std::string& section, const OptionTable& table)
  { return std::string("## ") + title + ": `[" + section + ".*]`\n\n" + table.toMarkdown(); };
  return chapter("Matching", kMatchingSection, optionTable(matching)) +
         chapter("Trajectories", kSlamSection, slamTable(*this));
}

std::vector<OptionField> SlamOptions::fields()
{
  std::vector<OptionField> all = optionTable(matching).fields();
  const std::vector<OptionField> slam = slamTable(*this).fields();
  all.insert(all.end(), slam.begin(), slam.end());
  return all;
}
}  // namespace psmks
