/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/base/NumberRow.h>
#include <psmks/sim/Route.h>

#include <istream>
#include <stdexcept>
#include <string>

namespace psmks
{
Route readRoute(std::istream& in)
{
  Route route;
  std::string line;
  for (int number = 1; std::getline(in, line); ++number)
  {
    const auto row = parseNumberRow(std::string_view(line).substr(0, line.find('#')));
    if (row && row->empty()) continue;
    if (!row || row->size() != 2)
      throw std::runtime_error("line " + std::to_string(number) + ": expected \"x y\" in metres");
    route.emplace_back((*row)[0], (*row)[1]);
  }
  if (route.size() < 2) throw std::runtime_error("a route needs at least two points");
  return route;
}
}  // namespace psmks
