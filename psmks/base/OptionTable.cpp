/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/base/OptionTable.h>
#include <psmks/base/ShortText.h>
#include <psmks/geometry/Angle.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <locale>
#include <numeric>
#include <sstream>

namespace psmks
{
namespace
{
std::string trimmed(const std::string& text)
{
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

[[noreturn]] void refuse(const std::string& key, const std::string& text,
                         const std::string& constraint)
{
  throw OptionError("option '" + key + "': '" + shortText(text) +
                    "' is not accepted, allowed: " + constraint);
}

/** The shortest decimal text of x that `sameAgain` accepts; whole numbers are written in full. */
template <class Check>
std::string shortestText(long double x, Check sameAgain)
{
  std::string text;
  for (int digits = 6; digits <= std::numeric_limits<long double>::max_digits10; ++digits)
  {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out.precision(digits);
    out << x;
    text = out.str();
    if (sameAgain(text)) break;
  }
  return text;
}

/** Parses a number. Angles are written in degrees; converting them in long double makes the round
 * trip between memory and file exact. */
double parseNumber(const std::string& text, Unit unit, const std::string& key,
                   const std::string& constraint)
{
  const std::string t = trimmed(text);
  std::istringstream in(t);
  in.imbue(std::locale::classic());
  long double value = 0;
  in >> value;
  if (in.fail() || in.peek() != std::istringstream::traits_type::eof())
    refuse(key, text, constraint);
  return unit == Unit::Degree ? degToRad(value) : static_cast<double>(value);
}

std::string formatNumber(double value, Unit unit)
{
  if (!std::isfinite(value)) return std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
  const long double shown = unit == Unit::Degree ? value * kDegreesPerRadian : value;
  return shortestText(
      shown, [&](const std::string& text) { return parseNumber(text, unit, "", "") == value; });
}

const char* unitText(Unit unit)
{
  switch (unit)
  {
    case Unit::Metre:
      return " m";
    case Unit::Degree:
      return " deg";
    case Unit::Second:
      return " s";
    case Unit::None:
      break;
  }
  return "";
}

std::string joined(const EnumNames& names)
{
  std::string all;
  for (const auto& name : names) all += (all.empty() ? "" : " | ") + name;
  return all;
}

/** The Levenshtein distance of two words, for proposing the known key that is nearest to an unknown
 * one. */
std::size_t editDistance(const std::string& a, const std::string& b)
{
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i)
  {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j)
    {
      const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
    }
  }
  return row.back();
}
}  // namespace

void OptionTable::beginSection(std::string name, std::string help)
{
  sections_.push_back({std::move(name), std::move(help)});
}

void OptionTable::add(const std::string& key, double& value, Unit unit, double min, double max,
                      const std::string& help)
{
  const std::string constraint =
      formatNumber(min, unit) + " to " + formatNumber(max, unit) + unitText(unit);
  fields_.push_back({sections_.back().name, key, constraint, help,
                     [&value, unit] { return formatNumber(value, unit); },
                     [&value, unit, min, max, key, constraint](const std::string& text)
                     {
                       const double x = parseNumber(text, unit, key, constraint);
                       if (!(x >= min && x <= max)) refuse(key, text, constraint);
                       value = x;
                     }});
  checks_.emplace_back(
      [&value, unit, min, max, key, constraint]
      {
        if (!(value >= min && value <= max)) refuse(key, formatNumber(value, unit), constraint);
      });
}

void OptionTable::add(const std::string& key, int& value, int min, int max, const std::string& help)
{
  const std::string constraint = std::to_string(min) + " to " + std::to_string(max);
  fields_.push_back({sections_.back().name, key, constraint, help,
                     [&value] { return std::to_string(value); },
                     [&value, min, max, key, constraint](const std::string& text)
                     {
                       const std::string t = trimmed(text);
                       int x = 0;
                       const auto [end, error] = std::from_chars(t.data(), t.data() + t.size(), x);
                       if (error != std::errc() || end != t.data() + t.size() || x < min || x > max)
                         refuse(key, text, constraint);
                       value = x;
                     }});
  checks_.emplace_back(
      [&value, min, max, key, constraint]
      {
        if (value < min || value > max) refuse(key, std::to_string(value), constraint);
      });
}

void OptionTable::add(const std::string& key, bool& value, const std::string& help)
{
  const std::string constraint = "true | false";
  fields_.push_back({sections_.back().name, key, constraint, help,
                     [&value] { return std::string(value ? "true" : "false"); },
                     [&value, key, constraint](const std::string& text)
                     {
                       const std::string t = trimmed(text);
                       if (t != "true" && t != "false") refuse(key, text, constraint);
                       value = t == "true";
                     }});
  checks_.emplace_back([] {});  // both values are accepted
}

void OptionTable::add(const std::string& key, std::string& value, const std::string& help)
{
  fields_.push_back({sections_.back().name, key, "text", help, [&value] { return value; },
                     [&value](const std::string& text) { value = trimmed(text); }});
  checks_.emplace_back([] {});  // every text is accepted
}

void OptionTable::addEnum(const std::string& key, const EnumNames& names, const std::string& help,
                          std::function<std::size_t()> get, std::function<void(std::size_t)> set)
{
  const std::string constraint = joined(names);
  checks_.emplace_back(
      [get, count = names.size(), key, constraint]
      {
        if (get() >= count) refuse(key, std::to_string(get()), constraint);
      });
  fields_.push_back({sections_.back().name, key, constraint, help,
                     [get = std::move(get), names] { return names.at(get()); },
                     [set = std::move(set), names, key, constraint](const std::string& text)
                     {
                       const auto name = std::find(names.begin(), names.end(), trimmed(text));
                       if (name == names.end()) refuse(key, text, constraint);
                       set(static_cast<std::size_t>(name - names.begin()));
                     }});
}

const OptionField& OptionTable::find(const std::string& section, const std::string& key) const
{
  const auto known = std::any_of(sections_.begin(), sections_.end(),
                                 [&](const Section& s) { return s.name == section; });
  if (!known) throw OptionError("section '" + shortText(section) + "': no such section of options");

  const OptionField* nearest = nullptr;
  const std::string start = shortText(key);
  for (const auto& field : fields_)
  {
    if (field.section != section) continue;
    if (field.key == key) return field;
    if (!nearest || editDistance(field.key, start) < editDistance(nearest->key, start))
      nearest = &field;
  }
  throw OptionError("option '" + shortText(key) + "' in section '" + section + "': no such option" +
                    (nearest ? ", did you mean '" + nearest->key + "'?" : ""));
}

void OptionTable::set(const std::string& section, const std::string& key, const std::string& value)
{
  find(section, key).set(value);
}

std::string OptionTable::get(const std::string& section, const std::string& key) const
{
  return find(section, key).get();
}

void OptionTable::validate() const
{
  for (const auto& check : checks_) check();
}

std::string OptionTable::toIni(const std::string& sectionPrefix) const
{
  std::ostringstream out;
  for (const auto& section : sections_)
  {
    out << "# " << section.help << "\n[" << sectionPrefix << section.name << "]\n";
    for (const auto& field : fields_)
    {
      if (field.section != section.name) continue;
      out << "# " << field.help << " (" << field.constraint << ")\n"
          << field.key << " = " << field.get() << "\n";
    }
    out << "\n";
  }
  return out.str();
}

std::string OptionTable::toMarkdown() const
{
  std::ostringstream out;
  for (const auto& section : sections_)
  {
    out << "**[" << section.name << "]** " << section.help
        << "\n\n| key | default | allowed | meaning |\n|---|---|---|---|\n";
    for (const auto& field : fields_)
    {
      if (field.section != section.name) continue;
      std::string allowed = field.constraint;
      for (auto bar = allowed.find('|'); bar != std::string::npos; bar = allowed.find('|', bar + 2))
        allowed.insert(bar, "\\");
      out << "| `" << field.key << "` | " << field.get() << " | " << allowed << " | " << field.help
          << " |\n";
    }
    out << "\n";
  }
  return out.str();
}
}  // namespace psmks
