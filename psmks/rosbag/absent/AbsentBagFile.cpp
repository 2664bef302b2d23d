/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/rosbag/BagFile.h>

namespace psmks
{
/** Stands in where psmks is built without the library of ROS. */
struct BagFile::Content
{
};

BagFile::BagFile(const std::string&)
    : error_(
          "psmks was built without ROS bags: install librosbag-storage-dev and libnav-msgs-dev, "
          "and build it again")
{
}

BagFile::~BagFile() = default;

void BagFile::forEachOdometry(const std::string&, const std::function<void(const BagOdometry&)>&) {}

void BagFile::forEachTransform(const std::function<void(const BagTransform&)>&) {}

void BagFile::openScans(const std::string&) {}

bool BagFile::nextScan(BagScan&) { return false; }
}  // namespace psmks
