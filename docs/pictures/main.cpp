/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <docs/pictures/Pictures.h>

#include <iostream>
#include <stdexcept>

namespace psmks
{
namespace
{
const char* const kLog =
    "/usr/share/mrpt/datasets/2006-01ENE-21-SENA_Telecom Faculty_one_loop_only.rawlog";
constexpr int kFirstOfProjection = 60, kSecondOfProjection = 64;
constexpr int kFirstInRoom = 100, kSecondInRoom = 101;

void write(const Figure& figure, const std::string& path)
{
  std::string reason;
  if (!save(figure, path, &reason)) throw std::runtime_error(reason);
  std::cout << path << '\n';
}

void draw(const std::string& folder)
{
  const ExamplePair pair = stockPair();
  write(segmentFigure(pair), folder + "/segments.png");
  write(projectionFigure(pairOfLog(kLog, kFirstOfProjection, kSecondOfProjection)),
        folder + "/projection.png");
  write(associationFigure(pair), folder + "/association.png");
  const std::string scores = folder + "/score.png";
  const std::string failure =
      drawScores(pairOfLog(kLog, kFirstInRoom, kSecondInRoom), bareCorridorPair(), scores);
  if (!failure.empty()) throw std::runtime_error(scores + ": " + failure);
  std::cout << scores << '\n';
  write(mapFigure(kLog), folder + "/keyframes.png");
}
}  // namespace
}  // namespace psmks

/** psmks-pictures FOLDER: draws the pictures of the guide into a folder that is there. */
int main(int argc, char** argv)
{
  if (argc != 2)
  {
    std::cerr << "psmks-pictures: needs the folder to draw into\n";
    return 1;
  }
  try
  {
    psmks::draw(argv[1]);
    return 0;
  }
  catch (const std::exception& error)
  {
    std::cerr << "psmks-pictures: " << error.what() << '\n';
    return 1;
  }
}
