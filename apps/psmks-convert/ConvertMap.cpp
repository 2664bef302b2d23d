/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-convert/ConvertMap.h>
#include <apps/support/TextFile.h>
#include <psmks/gzip/GzipInput.h>
#include <psmks/sim/MapFile.h>

#include <array>
#include <iomanip>
#include <iostream>
#include <sstream>

namespace psmks
{
namespace
{
/** Largest map that is read. Definition: a million walls. */
constexpr std::size_t kLargestMap_bytes = 1 << 26;

std::string inflated(const std::string& path)
{
  GzipInput file(path);
  if (!file.isOpen())
    throw ProgramError(kInputDamaged, "'" + path + "': no such file, or not to be read");
  std::string text;
  std::array<char, 1 << 16> block{};
  while (const std::size_t bytes = file.Read(block.data(), block.size()))
  {
    text.append(block.data(), bytes);
    if (text.size() > kLargestMap_bytes)
      throw ProgramError(kInputDamaged, "'" + path + "': a map of more than 64 MB");
  }
  if (!file.error().empty()) throw ProgramError(kInputDamaged, "'" + path + "': " + file.error());
  return text;
}

World readWorld(const std::string& path)
{
  std::istringstream text(inflated(path));
  try
  {
    return readMapFile(text).world;
  }
  catch (const MapFileError& error)
  {
    throw ProgramError(kInputDamaged, "'" + path + "': " + error.what());
  }
}

void writeSegments(std::ostream& out, const World& world)
{
  constexpr int kDigits = 9;
  out << "x1_m,y1_m,x2_m,y2_m\n" << std::setprecision(kDigits);
  for (const auto& wall : world.walls())
    out << wall.a.x() << ',' << wall.a.y() << ',' << wall.b.x() << ',' << wall.b.y() << '\n';
}
}  // namespace

void convertMap(const CommandLine& commandLine)
{
  const World world = readWorld(commandLine.input);
  if (world.walls().empty())
    throw ProgramError(kNothingToDo, "'" + commandLine.input + "' holds no walls");
  writeTextFile(commandLine.output, [&world](auto& out) { writeSegments(out, world); });
  std::cout << commandLine.output << ": " << world.walls().size() << " segments; the map's "
            << world.points().size() << " points are left out\n";
}
}  // namespace psmks
