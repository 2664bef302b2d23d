/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/experiments/Report.h>
#include <apps/psmks-benchmark/experiments/ResultTables.h>

#include <ostream>

namespace psmks
{
namespace
{
const char* const kIntroduction = R"(# Experiments

Written by `psmks-benchmark experiments`; tables and pictures are generated, and every number is one of
the drives below. They repeat the experiments of sections 3 and 4 of the paper on other worlds with
the same numbers of walls and points, because the authors' maps are not public.

A simulated Pioneer 3-AT (wheel noise +-5 %, drawn anew every 20 ms for each wheel) carries a scanner of
181 rays over 180 degrees with 1 cm of noise at 10 Hz. In the first four worlds the Area Center method
drives it for ten minutes; in the last two a person would, along a route. Every method gets the same
scans and the same odometry. The paper does not state the range of its laser; 30 m is the main setting,
and 8 m the more difficult one.

- **paper**: the paper's scheme, matched whenever the robot has moved 0.8 m or turned 20 degrees, against
  the scan matched before.
- **joint sequential**: the joint scheme on the same pairs. **joint keyframe**: every scan, against a scan
  that stays the reference for as long as enough of it is seen. **joint map**: every scan, against the
  nearest of all keyframes, which are matched against each other.
- **MRPT ICP**: `mrpt::slam::CICP`, default parameters, on the same pairs as the paper's scheme.
- **floor**: the drift that is left when each of the method's pairs of scans is matched by maximum
  likelihood, knowing which ray met which object but not where the objects are, with the noise that the
  scans and the wheels really had ([derivations.md](derivations.md#drift-floor)). To first order no
  matcher can do better on average, only by chance.
- dr and |dtheta| are the errors of the robot's pose at the accepted matches, seen from its true start.
  Numbers are means over the drives, in brackets the smallest and the largest; max is the worst of all.

)";

const char* const kReliability =
    R"(A silent error is a match that was accepted, without a direction flagged as not observable, and wrong by more than 10 cm or 2 degrees. A drive is won where the mean errors of
position and of heading are both the smaller ones. Ends on walls: segment ends of the map within 3 cm of
a true wall.

)";

const char* const kReading = R"(## Reading the tables

- Maps, the range of the laser and the constants of the driver differ from the paper's, so that ratios to
  the odometry compare better with the paper than centimetres do.
- **Heading of the paper's scheme.** The orientation search ends on a grid of 0.1 degrees, which alone
  leaves an error of 0.03 degrees in each match. Over 450 matches in a row this adds up to half a degree, and
  along corridors the heading decides the position. With `--set paper.fine_step_deg=0.02` a third of the heading
  error is left in the room and three quarters in the corridors, at twice the time. The tables use the step of
  the paper.
- **The paper's scheme among round things** (curved): on many scans fewer than 30 rays lie on segments
  that both scans share, and by the paper such a match is refused. The odometry then places the robot, and the
  floor of those drives consists mostly of its error.
- **What the text of the paper leaves open** changes the drift several times over: how errors over different
  numbers of rays compare, whether the translation step has to lower the error on its own, which error is too big.
  [derivations.md](derivations.md#the-papers-scheme) says what was chosen and why.
- **Sequential, keyframe, map.** With sequential references an error is added every 0.8 m. A keyframe that stays
  for two metres adds fewer but larger errors, and drifts about as much. A map whose keyframes are matched
  against each other removes drift wherever the robot comes back.
- **Ratios to the floor** scatter from drive to drive, because both errors are random walks that share only a part
  of their noise. A single drive may be below 1 by chance; a mean below 1 would mean that the floor is wrong.
- **Short range** (8 m): in room and curved a part of the scans sees one wall or a few round things. These
  matches are `Degenerate`, and the odometry decides along the open direction.

)";

void writeTable(std::ostream& out, const Table& table)
{
  out << "## " << table.title << "\n\n" << toMarkdown(table) << '\n';
}

void writePictures(std::ostream& out, const std::vector<Picture>& pictures)
{
  out << "## Pictures\n\n";
  for (const auto& picture : pictures)
    out << picture.caption << "\n\n![" << picture.caption << "](" << picture.path << ")\n\n";
}
}  // namespace

void writeReport(std::ostream& out, const std::vector<DriveResult>& results,
                 const std::vector<Picture>& pictures, const std::string& machine)
{
  const std::vector<ResultGroup> groups = grouped(results);
  out << kIntroduction;
  writeTable(out, driftTable(groups));
  writeTable(out, reliabilityTable(groups));
  out << kReliability;
  writeTable(out, workTable(groups));
  out << "Measured on: " << machine << "\n\n";
  writeTable(out, driveTable(groups));
  out << kReading;
  writePictures(out, pictures);
  out << "## Every drive\n\n<details><summary>One row a drive and method</summary>\n\n"
      << toMarkdown(runTable(results)) << "\n</details>\n";
}
}  // namespace psmks
