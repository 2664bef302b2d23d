/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/base/ShortText.h>
#include <psmks/mrpt/ConfigFile.h>

#include <algorithm>
#include <cctype>
#include <vector>

namespace psmks
{
using mrpt::config::CConfigFileBase;

namespace
{
/** Compares as MRPT compares the names of sections: upper and lower case are the same. */
bool startsWith(const std::string& text, const std::string& prefix)
{
  const auto same = [](unsigned char a, unsigned char b)
  { return std::tolower(a) == std::tolower(b); };
  return text.size() >= prefix.size() &&
         std::equal(prefix.begin(), prefix.end(), text.begin(), same);
}

/** Values are read as text, because MRPT's read_double() turns what is no number into 0. */
void loadStage(OptionTable& table, const CConfigFileBase& file, const std::string& fileSection,
               const std::string& stage)
{
  std::vector<std::string> keys;
  file.getAllKeys(fileSection, keys);
  for (const auto& key : keys)
  {
    try
    {
      table.set(stage, key, file.read_string(fileSection, key, ""));
    }
    catch (const OptionError& error)
    {
      throw OptionError("[" + shortText(fileSection) + "] " + error.what());
    }
  }
}

void refuseKeysWithoutStage(const CConfigFileBase& file, const std::string& section)
{
  std::vector<std::string> keys;
  file.getAllKeys(section, keys);
  if (!keys.empty())
    throw OptionError("[" + section + "] option '" + shortText(keys.front()) +
                      "': options stand in the section "
                      "of their stage, [" +
                      section + ".<stage>]");
}
}  // namespace

void loadOptions(OptionTable& table, const CConfigFileBase& file, const std::string& section)
{
  refuseKeysWithoutStage(file, section);

  const std::string prefix = section + ".";
  std::vector<std::string> fileSections;
  file.getAllSections(fileSections);
  for (const auto& fileSection : fileSections)
  {
    if (startsWith(fileSection, prefix))
      loadStage(table, file, fileSection, fileSection.substr(prefix.size()));
  }
}

bool hasStages(const CConfigFileBase& file, const std::string& section)
{
  std::vector<std::string> sections;
  file.getAllSections(sections);
  return std::any_of(sections.begin(), sections.end(),
                     [&](const std::string& name) { return startsWith(name, section + "."); });
}

void saveOptions(const OptionTable& table, CConfigFileBase& file, const std::string& section)
{
  // MRPT can pad keys with blanks, but in memory a padded key is another key. None is padded here.
  for (const auto& field : table.fields())
    file.write(section + "." + field.section, field.key, field.get());
}
}  // namespace psmks
