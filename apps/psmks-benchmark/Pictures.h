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
  std::string path;  //!< relative to the folder of the report
};

/** The pictures of a report, which are saved in a folder. */
class Pictures
{
 public:
  /** Creates the folder of the pictures if it does not exist.
   *  @param folder of the pictures, relative to that of the report; empty = the same folder
   *  @throws std::filesystem::filesystem_error if it cannot be created */
  Pictures(const std::string& reportFolder, const std::string& folder);

  /** Saves a picture. If this fails, as without gnuplot, stderr says why once. */
  void add(const std::string& name, const std::string& caption, const Figure& figure);

  const std::vector<Picture>& saved() const { return saved_; }

 private:
  std::string reportFolder_, folder_;
  std::vector<Picture> saved_;
  bool failed_ = false;
};
}  // namespace psmks
