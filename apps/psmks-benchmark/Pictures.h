/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/Figure.h>

#include <string>
#include <vector>

namespace psmks
{
/** A picture of the report. */
struct Picture
{
  std::string caption;
  std::string path;  //!< from the folder of the report
};

/** The pictures of a report, in a folder beside it or below. */
class Pictures
{
 public:
  /** Makes the folder for the pictures where it is missing.
   *  @param folder for the pictures, from the folder of the report; empty = the same
   *  @throws std::filesystem::filesystem_error */
  Pictures(const std::string& reportFolder, const std::string& folder);

  /** Saves a picture. Where that fails - gnuplot is not installed - stderr says why, once. */
  void add(const std::string& name, const std::string& caption, const Figure& figure);

  const std::vector<Picture>& saved() const { return saved_; }

 private:
  std::string reportFolder_, folder_;
  std::vector<Picture> saved_;
  bool failed_ = false;
};
}  // namespace psmks
