/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace psmks
{
/** A key, a value or a file of options that cannot be accepted. The text quotes the key, the value
 * and the constraint that the value breaks. */
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
  Degree,  //!< kept in radians, written in degrees
  Second
};

/** One option as text, for files, command lines and tables of the documentation. */
struct OptionField
{
  std::string section;     //!< the stage of the method, which is a section of an ini file
  std::string key;         //!< ends with the unit if the option has one
  std::string constraint;  //!< the accepted values, such as "0 to 1 m" or "linear | ekf"
  std::string help;
  std::function<std::string()> get;  //!< the value as text that set() reads back without loss
  std::function<void(const std::string&)> set;  //!< throws OptionError if the value is not accepted
};

/** The texts of the values of an enum option, in the order of their numbers. */
using EnumNames = std::vector<std::string>;

/** The options of one or several stages as a list of fields, each bound to a member of a struct.
 *
 * Each options struct lists its fields once, in a function `listFields(OptionTable&, Options&)`.
 * Loading, saving, validation and documentation all read this list, so that they always agree. The
 * table refers to the struct and must not outlive it. */
class OptionTable
{
 public:
  /** Begins a section: the fields added after this call belong to it. */
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

  /** Sets an option from its text.
   *  @throws OptionError for an unknown section or key, naming the nearest known one, and for a
   *      value that the option does not accept */
  void set(const std::string& section, const std::string& key, const std::string& value);

  /** The value of an option as text.
   *  @throws OptionError for an unknown section or key */
  std::string get(const std::string& section, const std::string& key) const;

  /** Checks every value that code wrote into the struct against the constraint of its field, as
   * set() does. Allocates nothing where all values are accepted.
   *  @throws OptionError for the first value that is not accepted. NaN is not accepted, nor is a
   *      number that stands for no value of an enum */
  void validate() const;

  /** All fields as the text of an ini file, each with its help and its constraint as a comment. */
  std::string toIni(const std::string& sectionPrefix = "") const;

  /** All fields as Markdown tables with the columns key, default, allowed and meaning. */
  std::string toMarkdown() const;

 private:
  void addEnum(const std::string& key, const EnumNames& names, const std::string& help,
               std::function<std::size_t()> get, std::function<void(std::size_t)> set);
  const OptionField& find(const std::string& section, const std::string& key) const;

  std::vector<Section> sections_;
  std::vector<OptionField> fields_;
  std::vector<std::function<void()>> checks_;  //!< of the fields, in their order
};
}  // namespace psmks
