/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <mrpt/core/initializer.h>
#include <mrpt/rtti/CObject.h>
#include <psmks/mrpt/ScanMatcher.h>

/** Makes ScanMatcher known to MRPT's class factory when the library is loaded. */
MRPT_INITIALIZER(registerClasses_psmks) { mrpt::rtti::registerClass(CLASS_ID(psmks::ScanMatcher)); }
