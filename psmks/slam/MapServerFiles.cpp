/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/slam/MapServerFiles.h>

#include <iomanip>
#include <ostream>

namespace psmks
{
namespace
{
/** The pixel of a cell, see writeMapServerPicture(). */
char pixelOf(OccupancyGrid::Cell cell)
{
  /** Grey of free, occupied and unknown cells. Unit: levels of 255. Definition: what map_server
   * writes, but for unknown ones, which lie between both. */
  constexpr unsigned char kFree = 254, kOccupied = 0, kUnknown = 128;
  if (cell == OccupancyGrid::Cell::Unknown) return static_cast<char>(kUnknown);
  return static_cast<char>(cell == OccupancyGrid::Cell::Free ? kFree : kOccupied);
}
}  // namespace

void writeMapServerPicture(std::ostream& out, const OccupancyGrid& grid)
{
  const UniformGrid& frame = grid.frame();
  out << "P5\n" << frame.columns() << ' ' << frame.rows() << "\n255\n";
  std::string line(static_cast<std::size_t>(frame.columns()), '\0');
  for (int row = frame.rows() - 1; row >= 0; --row)
  {
    for (int column = 0; column < frame.columns(); ++column)
      line[static_cast<std::size_t>(column)] = pixelOf(grid.at(column, row));
    out << line;
  }
}

void writeMapServerYaml(std::ostream& out, const OccupancyGrid& grid,
                        const std::string& pictureFile)
{
  /** Digits of lengths in m. Unit: digits. Definition: below a micrometre in a world of kilometres.
   */
  constexpr int kDigits = 10;
  const UniformGrid& frame = grid.frame();
  out << std::setprecision(kDigits) << "image: " << pictureFile
      << "\nmode: trinary\nresolution: " << frame.cell_m() << "\norigin: [" << frame.low_m().x()
      << ", " << frame.low_m().y()
      << ", 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
}
}  // namespace psmks
