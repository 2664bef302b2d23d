/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <utility>

namespace psmks
{
/** What a matcher has made of one scan before it matches it: of `psmks` the segmented scan, of a
 * method that prepares nothing the scan itself. Only a matcher of the same name and options can
 * read it; for everybody else it is opaque. Immutable, so several matches may share it. */
class PreparedScan
{
 public:
  explicit PreparedScan(bool showsMoreNoise = false) : showsMoreNoise_(showsMoreNoise) {}
  virtual ~PreparedScan() = default;
  PreparedScan(const PreparedScan&) = delete;
  PreparedScan& operator=(const PreparedScan&) = delete;

  /** Whether the ranges of this scan scatter clearly more than was stated: what ScannerNoise counts
   * to tell a noisy scanner from clutter. False where the method does not look at the noise. */
  bool showsMoreNoise() const { return showsMoreNoise_; }

 private:
  bool showsMoreNoise_;
};

/** A prepared scan that consists of one value. */
template <class Data>
class PreparedAs : public PreparedScan
{
 public:
  explicit PreparedAs(Data data, bool showsMoreNoise = false)
      : PreparedScan(showsMoreNoise), data_(std::move(data))
  {
  }

  const Data& data() const { return data_; }

 private:
  Data data_;
};

/** The value that a prepared scan consists of.
 *  @throws std::bad_cast where a matcher of another kind has prepared the scan */
template <class Data>
const Data& dataOf(const PreparedScan& scan)
{
  return dynamic_cast<const PreparedAs<Data>&>(scan).data();
}
}  // namespace psmks
