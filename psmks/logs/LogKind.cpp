/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/gzip/GzipInput.h>
#include <psmks/logs/LogKind.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string_view>

namespace psmks
{
namespace
{
using namespace std::string_view_literals;

constexpr const char* kToRos1 =
    "rosbags-convert of the Python package rosbags makes a ROS 1 bag of it";
constexpr const char* kToPlanar = "psmks reads planar scans, not points";

/** Bytes at the begin of files of a kind. */
struct Signature
{
  std::string_view bytes;
  const char* kind;
  const char* advice;
};

constexpr Signature kSignatures[] = {
    {"#ROSBAG V1"sv, "a ROS bag of the old version 1", "rosbag fix makes a newer one of it"},
    {"\x89MCAP0\r\n"sv, "a ROS 2 bag (MCAP)", kToRos1},
    {"SQLite format 3\0"sv, "a ROS 2 bag (SQLite, db3)", kToRos1},
    {"ASTM-E57"sv, "points of a 3D scanner (E57)", kToPlanar},
    {"LASF"sv, "points of a 3D scanner (LAS)", kToPlanar},
    {"ply\n"sv, "points or a mesh (PLY)", kToPlanar},
    {"ply\r\n"sv, "points or a mesh (PLY)", kToPlanar},
    {"# .PCD"sv, "a point cloud (PCD)", kToPlanar},
    {"\xD4\xC3\xB2\xA1"sv, "recorded network packets (pcap)", ""},
    {"\xA1\xB2\xC3\xD4"sv, "recorded network packets (pcap)", ""},
    {"\x0A\x0D\x0D\x0A"sv, "recorded network packets (pcapng)", ""},
    {"\x89HDF\r\n"sv, "an HDF5 file", ""},
    {"\x93NUMPY"sv, "an array of NumPy", ""},
    {"PK\x03\x04"sv, "a ZIP archive", "unpack it first"},
    {"7z\xBC\xAF\x27\x1C"sv, "a 7z archive", "unpack it first"},
    {"BZh"sv, "a file that bzip2 compressed", "unpack it first"},
    {"\xFD"
     "7zXZ"sv,
     "a file that xz compressed", "unpack it first"},
    {"\x28\xB5\x2F\xFD"sv, "a file that zstd compressed", "unpack it first"},
    {"\x89PNG"sv, "a picture (PNG)", ""},
    {"\xFF\xD8\xFF"sv, "a picture (JPEG)", ""},
    {"P5\n"sv, "a picture or an occupancy grid (PGM)", ""},
    {"%PDF"sv, "a PDF document", ""},
};

constexpr std::string_view kRosBag = "#ROSBAG V2.0"sv, kGzip = "\x1F\x8B"sv;

bool beginsWith(std::string_view text, std::string_view start)
{
  return text.substr(0, start.size()) == start;
}

/** The first bytes of a file, uncompressed. */
std::string startOf(const std::string& path)
{
  constexpr std::size_t kBytes = 512;  // enough for a tar archive, which is named at byte 257
  GzipInput file(path);
  std::string start(kBytes, '\0');
  start.resize(file.isOpen() ? file.Read(start.data(), start.size()) : 0);
  return start;
}

bool isGzipped(const std::string& path)
{
  std::string start(kGzip.size(), '\0');
  std::ifstream(path, std::ios::binary)
      .read(start.data(), static_cast<std::streamsize>(start.size()));
  return start == kGzip;
}

bool isTextual(const std::string& start)
{
  const auto isControl = [](char c)
  {
    const auto byte = static_cast<unsigned char>(c);
    return byte < ' ' && c != '\t' && c != '\r' && c != '\n';
  };
  return !start.empty() && std::none_of(start.begin(), start.end(), isControl);
}

/** The first line that is neither empty nor a comment. */
std::string firstLine(const std::string& text)
{
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
  {
    const auto start = line.find_first_not_of(" \t\r");
    if (start != std::string::npos && line[start] != '#' && line[start] != '%')
      return line.substr(start);
  }
  return "";
}

bool isRowOfNumbers(const std::string& line)
{
  return line.find_first_not_of("0123456789+-.eE \t\r") == std::string::npos;
}

/** What a text seems to be that is no CARMEN log. */
std::string seemsOfText(const std::string& text)
{
  const std::string line = firstLine(text);
  if (line.empty()) return "";
  if (line.front() == '{') return "a JSON document";
  if (line.front() == '<') return "an XML or HTML document";
  if (line.front() == '[') return "a configuration file";
  if (std::count(line.begin(), line.end(), ',') >= 2) return "a table (CSV)";
  if (isRowOfNumbers(line)) return "rows of numbers, such as a trajectory";
  return "";
}

LogKind kindOfFolder(const std::string& path)
{
  if (std::filesystem::exists(std::filesystem::path(path) / "metadata.yaml"))
    return {LogReading::None, "a ROS 2 bag (a folder with metadata.yaml)", kToRos1};
  return {LogReading::None, "a folder", "name a file in it"};
}
}  // namespace

LogKind recogniseLog(const std::string& path)
{
  if (std::filesystem::is_directory(path)) return kindOfFolder(path);
  const std::string start = startOf(path);
  if (beginsWith(start, kRosBag))
  {
    if (!isGzipped(path)) return {LogReading::RosBag, "", ""};
    return {LogReading::None, "a gzipped ROS 1 bag", "unpack it first"};
  }
  for (const Signature& signature : kSignatures)
    if (beginsWith(start, signature.bytes))
      return {LogReading::None, signature.kind, signature.advice};
  constexpr std::size_t kTarName = 257;
  if (start.size() > kTarName && beginsWith(std::string_view(start).substr(kTarName), "ustar"))
    return {LogReading::None, "a tar archive", "unpack it first"};
  if (isTextual(start)) return {LogReading::Carmen, seemsOfText(start), ""};
  return {};
}
}  // namespace psmks
