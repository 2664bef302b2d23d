/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace psmks
{
/** A key, a value or a file of options that cannot be accepted; the text quotes key, value and
 *  constraint. */
class OptionError : public std::runtime_error
{
 public:
  using std::runtime_error::runtime_error;
};

/** How a number is written in files, flags and tables. */
enum class Unit
{
  None,
  Metre,
  Degree,  //!< radians in memory
  Second
};

/** One option as text: what a file, a command line and a documentation table need of it. */
struct OptionField
{
  std::string section;     //!< the stage: one ini section each
  std::string key;         //!< ends in the unit where there is one
  std::string constraint;  //!< "0 to 1 m", "linear | ekf", ...
  std::string help;
  std::function<std::string()> get;             //!< exact: set(get()) changes nothing
  std::function<void(const std::string&)> set;  //!< throws OptionError
};

/** Text and meaning of the values of an enum option, in the order of their numbers. */
using EnumNames = std::vector<std::string>;

/** The options of one or several stages as one list of fields, each bound to a struct's member.
 *
 * Each options struct states its fields once, in a function `listFields(OptionTable&, Options&)`;
 * loading, saving, validation and documentation all read this list, so they cannot drift. The table
 * refers to the struct: it must not outlive it. */
class OptionTable
{
 public:
  /** Fields added from now on belong to this section. */
  void beginSection(std::string name, std::string help);

  void add(const std::string& key, double& value, Unit unit, double min, double max,
           const std::string& help);
  void add(const std::string& key, int& value, int min, int max, const std::string& help);
  void add(const std::string& key, bool& value, const std::string& help);
  void add(const std::string& key, std::string& value, const std::string& help);

  template <class Enum>
  void add(const std::string& key, Enum& value, const EnumNames& names, const std::string& help)
  {
    addEnum(
        key, names, help, [&value] { return static_cast<std::size_t>(value); },
        [&value](std::size_t i) { value = static_cast<Enum>(i); });
  }

  const std::vector<OptionField>& fields() const { return fields_; }

  struct Section
  {
    std::string name, help;
  };
  const std::vector<Section>& sections() const { return sections_; }

  /** @throws OptionError for an unknown section or key (naming the nearest known one), or a value
   *  that is no value of that option. */
  void set(const std::string& section, const std::string& key, const std::string& value);

  /** @throws OptionError for an unknown section or key */
  std::string get(const std::string& section, const std::string& key) const;

  /** Every field as ini text with its help and constraint as comments. */
  std::string toIni(const std::string& sectionPrefix = "") const;

  /** Every field as a Markdown table: key, default, allowed, meaning. */
  std::string toMarkdown() const;

 private:
  void addEnum(const std::string& key, const EnumNames& names, const std::string& help,
               std::function<std::size_t()> get, std::function<void(std::size_t)> set);
  const OptionField& find(const std::string& section, const std::string& key) const;

  std::vector<Section> sections_;
  std::vector<OptionField> fields_;
};
}  // namespace psmks
