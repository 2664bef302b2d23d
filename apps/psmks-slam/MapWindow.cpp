/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-slam/MapWindow.h>
#include <apps/support/ExitCode.h>
#include <mrpt/gui/CDisplayWindow3D.h>
#include <psmks/draw/MapScene.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <thread>

namespace psmks
{
void requireDisplay()
{
  // Without a display MRPT waits for its window thread, and then continues without a window.
  const char* display = std::getenv("DISPLAY");
  if (!display || !*display)
    throw ProgramError(kUsage, "--view needs a display, but the variable DISPLAY is not set");
}

void showMap(const ScanMap& map)
{
  constexpr unsigned kWidth_px = 1000, kHeight_px = 800;
  constexpr float kElevation_deg = 80, kAzimuth_deg = -90;
  /** Distance of the camera from which the whole map is seen, over the size of the map. */
  constexpr float kDistancePerSize = 1.5f;

  mrpt::gui::CDisplayWindow3D window("psmks-slam", kWidth_px, kHeight_px);
  const auto scene = makeMapScene(map);
  const auto box = scene->getBoundingBox();
  const auto size = box.max - box.min, centre = (box.min + box.max) * 0.5;
  window.setCameraPointingToPoint(static_cast<float>(centre.x), static_cast<float>(centre.y), 0);
  window.setCameraZoom(kDistancePerSize * static_cast<float>(std::max(size.x, size.y)));
  window.setCameraElevationDeg(kElevation_deg);
  window.setCameraAzimuthDeg(kAzimuth_deg);
  window.get3DSceneAndLock() = scene;
  window.unlockAccess3DScene();
  window.repaint();
  while (window.isOpen()) std::this_thread::sleep_for(std::chrono::milliseconds(50));
}
}  // namespace psmks
