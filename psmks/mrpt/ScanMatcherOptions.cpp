/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <mrpt/config/CConfigFile.h>
#include <mrpt/system/filesystem.h>
#include <psmks/mrpt/ConfigFile.h>
#include <psmks/mrpt/ScanMatcherOptions.h>

#include <ostream>

namespace psmks
{
using mrpt::config::CConfigFileBase;

OptionTable optionTable(ScanMatcherOptions& options)
{
  OptionTable table = optionTable(options.matcher);
  listFields(table, static_cast<RegistrationOptions&>(options));
  table.add("guess_sigma_m", options.guessSigma_m, Unit::Metre, 1e-4, 10,
            "standard deviation claimed of what is taken from a guess that states none");
  table.add("guess_sigma_deg", options.guessSigma_rad, Unit::Degree, degToRad(0.001), kPi,
            "the same of the heading");
  listFields(table, options.view);
  table.beginSection("mounting", "How a scanner sits and turns on its robot.");
  table.add("max_tilt_deg", options.maxTilt_rad, Unit::Degree, 0, degToRad(45),
            "scans tilted further out of the horizontal plane are not matched");
  table.add(
      "beam_turn_s", options.beam.turn_s, Unit::Second, -10, 10,
      "time in which the beam goes once round, negative where that is against the order of the "
      "rays: what the robot moves meanwhile is taken out of a log's scans; 0: as the log states, "
      "else unknown");
  table.add(
      "turn_increment_deg", options.beam.turnIncrement_rad, Unit::Degree, 0, degToRad(360),
      "angle between the rays of one turn of the beam: scans with rays closer to each other are "
      "taken in several turns, which interleave; 0: in one turn; used where beam_turn_s is set");
  return table;
}

void ScanMatcherOptions::loadFromConfigFile(const CConfigFileBase& source,
                                            const std::string& section)
{
  ScanMatcherOptions loaded = *this;
  OptionTable table = optionTable(loaded);
  loadOptions(table, source, section);
  *this = loaded;
}

void ScanMatcherOptions::loadFromConfigFileName(const std::string& file, const std::string& section)
{
  if (!mrpt::system::fileExists(file)) throw OptionError("file '" + file + "' does not exist");
  const mrpt::config::CConfigFile source(file);
  if (!hasStages(source, section))
    throw OptionError("file '" + file + "' has no section [" + section + ".<stage>]");
  loadFromConfigFile(source, section);
}

void ScanMatcherOptions::saveToConfigFile(CConfigFileBase& target, const std::string& section) const
{
  ScanMatcherOptions copy = *this;
  saveOptions(optionTable(copy), target, section);
}

void ScanMatcherOptions::dumpToTextStream(std::ostream& out) const
{
  ScanMatcherOptions copy = *this;
  out << optionTable(copy).toIni("psmks.");
}
}  // namespace psmks
