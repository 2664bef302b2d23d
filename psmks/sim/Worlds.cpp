/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/sim/Campus.h>
#include <psmks/sim/ClutteredRoom.h>
#include <psmks/sim/Corridors.h>
#include <psmks/sim/Kilometres.h>
#include <psmks/sim/Office.h>
#include <psmks/sim/Worlds.h>

#include <array>
#include <stdexcept>

namespace psmks
{
namespace
{
struct Maker
{
  const char* name;
  Site (*make)(unsigned seed);
};

constexpr std::array kMakers{Maker{"room", makeRoom},
                             Maker{"clutter", makeClutter},
                             Maker{"curved", makeCurved},
                             Maker{"corridors", makeCorridors},
                             Maker{"office", makeOffice},
                             Maker{"campus", makeCampus},
                             Maker{"kilometres", makeKilometres}};
}  // namespace

std::vector<std::string> siteNames()
{
  std::vector<std::string> names;
  for (const Maker& maker : kMakers) names.push_back(maker.name);
  return names;
}

Site makeSite(const std::string& name, unsigned seed)
{
  std::string known;
  for (const Maker& maker : kMakers)
  {
    if (name == maker.name) return maker.make(seed);
    known += std::string(known.empty() ? "" : ", ") + maker.name;
  }
  throw std::invalid_argument("unknown world '" + name + "'; known are " + known);
}
}  // namespace psmks
