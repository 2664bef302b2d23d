/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-convert/SensorSink.h>
#include <apps/support/LogScan.h>
#include <apps/support/ReplacedFile.h>
#include <apps/support/TextFile.h>
#include <psmks/eval/Figure.h>
#include <psmks/eval/Table.h>
#include <psmks/motion/OdometryNoise.h>

#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <sstream>

namespace psmks
{
namespace
{
constexpr double kMillimetre = 1e3;

std::vector<Table::Cell> row(const std::string& evidence, const SensorReport::Rays& rays)
{
  return {evidence, static_cast<double>(rays.scans), kMillimetre * rays.noise.sigma_m,
          kMillimetre * rays.noise.sigmaPerMetre_m, rays.raysPerReading};
}

std::string textOf(const SensorReport::HalfScans& halves)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << kMillimetre * halves.oddMinusEven_m << " mm, sigma "
       << kMillimetre * halves.sigma_m << " mm";
  return text.str();
}

std::string textOf(const SensorReport::OddRayDelay& delay)
{
  constexpr double kMillisecond = 1e3;
  std::ostringstream text;
  text << std::fixed << std::setprecision(2)
       << "odd rays after even ones: " << kMillisecond * delay.byDriving_s
       << " ms by driving, sigma " << kMillisecond * delay.byDrivingSigma_s << " ms; "
       << kMillisecond * delay.byTurning_s << " ms by turning, sigma "
       << kMillisecond * delay.byTurningSigma_s << " ms\n";
  return text.str();
}

/** The three levels, in words and numbers. */
std::string textOf(const SensorReport& report)
{
  Table table{"Noise of the rays",
              {{"evidence", "evidence"},
               {"scans", "scans", 0},
               {"sigma mm", "sigma_mm", 1},
               {"+ mm for each metre", "sigma_per_metre_mm", 2},
               {"rays per independent reading", "rays_per_reading", 1}},
              {}};
  if (report.walls.scans > 0) table.rows.push_back(row("straight walls", report.walls));
  if (report.standing.scans > 0) table.rows.push_back(row("standing", report.standing));
  std::ostringstream text;
  text << std::fixed << toText(table) << std::setprecision(2)
       << "odd minus even rays: " << textOf(report.rawHalfScans) << ", deskewed "
       << textOf(report.halfScans) << '\n';
  if (report.oddRayDelay.scans > 0) text << textOf(report.oddRayDelay);
  if (report.wholeScan)
    text << "whole scans, besides: " << kMillimetre * report.wholeScan->sigma_m << " mm, "
         << radToDeg(report.wholeScan->sigma_rad) << " deg, of poses that scatter by "
         << kMillimetre * report.poseScatter_m << " mm, " << radToDeg(report.poseScatter_rad)
         << " deg from scan to scan\n";
  else
    text << "whole scans: unknown, for the scanner never stood\n";
  return text.str();
}

/** The scatter of the bins, and the noise that fits them. */
void plot(const std::string& name, const SensorReport::Rays& rays, Chart& chart)
{
  if (rays.bins.empty()) return;
  ChartSeries measured{name + ", measured", {}, ChartSeries::Style::Points};
  ChartSeries fitted{name + ", model", {}, ChartSeries::Style::Line};
  for (const RangeScatter::Bin& bin : rays.bins)
  {
    measured.points.emplace_back(bin.range_m, kMillimetre * bin.sigma_m);
    fitted.points.emplace_back(bin.range_m, kMillimetre * rays.noise.sigmaAt_m(bin.range_m));
  }
  chart.series.push_back(std::move(measured));
  chart.series.push_back(std::move(fitted));
}

std::string pictureBeside(const std::string& sensorFile)
{
  return std::filesystem::path(sensorFile).replace_extension(".png").string();
}

void draw(const SensorReport& report, const std::string& path)
{
  Chart chart;
  chart.title = "Noise of a range";
  chart.xLabel = "range, m";
  chart.yLabel = "standard deviation, mm";
  chart.yRange.min = 0;
  plot("straight walls", report.walls, chart);
  plot("standing", report.standing, chart);
  std::string reason;
  const auto write = [&](const std::string& beside) { return save(chart, beside, &reason); };
  if (!chart.series.empty() && !replaceFile(path, write))
    throw ProgramError(kOutputFailed, "cannot write '" + path + "': " + reason);
}
}  // namespace

void SensorSink::write(const LaserFrame& frame)
{
  LogScan logged = toLogScan(frame, converter_, ScanMatcherOptions());
  const Scan raw = logged.scan;
  const Pose2 motion = logged.odometry.value_or(Pose2());
  deskewer_.deskew(logged.scan, logged.T_robot_sensor,
                   {motion, odometryCovariance(motion, OdometryOptions())});
  survey_.compareTurns(raw, deskewer_.measured());
  survey_.add(logged.scan);
  ++scans_;
}

std::string SensorSink::finish()
{
  const SensorReport report = survey_.report();
  std::cout << textOf(report);
  const std::string scans = std::to_string(scans_) + " scans";
  if (path_.empty()) return scans;
  writeTextFile(path_, [&report](std::ostream& file) { file << report.sensorFile(); });
  draw(report, pictureBeside(path_));
  return scans;
}
}  // namespace psmks
