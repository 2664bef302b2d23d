/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <tests/laws/Schemes.h>

#include <limits>
#include <sstream>

namespace psmks
{
namespace
{
bool isLength(const std::string& key)
{
  return key.size() > 2 && key.substr(key.size() - 2) == "_m";
}

/** The options for a world that is k times as large. */
MatcherOptions scaled(MatcherOptions options, double k)
{
  OptionTable table = optionTable(options);
  for (const OptionField& field : table.fields())
  {
    if (!isLength(field.key)) continue;
    std::ostringstream value;
    value.precision(std::numeric_limits<double>::max_digits10);
    value << k * std::stod(field.get());
    field.set(value.str());
  }
  return options;
}

Scan scaled(Scan scan, double k)
{
  for (double& range_m : scan.range_m) range_m *= k;
  scan.maxRange_m *= k;
  scan.rangeSigma_m *= k;
  return scan;
}

Pose2 scaled(const Pose2& pose, double k) { return {k * pose.x_m, k * pose.y_m, pose.phi_rad}; }

class Scale : public SchemeLaw
{
};

INSTANTIATE_TEST_SUITE_P(Schemes, Scale, testing::ValuesIn(bothSchemes()), schemeName);
}  // namespace

// The world is only made larger. Some lengths are constants, such as the thickness of 4 cm that the
// free-space score gives to surfaces, so the method does not scale to much smaller worlds.
TEST_P(Scale, ALargerWorldScalesTheTranslation)
{
  for (const double k : {1.5, 2.0, 3.0})
  {
    const Matcher larger(scaled(GetParam().options, k));
    for (int i = 0; i < kPairs; ++i)
    {
      const ScanPair pair = randomPair(i % 2 ? kHalfCircle : kFullCircle);
      const Guess guess{{0.02, -0.01, 0.01}, {}};
      const MatchResult plain = match(pair.reference, pair.current, guess);
      const MatchResult result = larger.match(scaled(pair.reference, k), scaled(pair.current, k),
                                              {scaled(guess.T_ref_cur, k), {}}, workspace_);
      ASSERT_TRUE(result.usable()) << result.report();
      EXPECT_TRUE(isNearly(result.T_ref_cur, scaled(plain.T_ref_cur, k), k * GetParam().tol_m,
                           GetParam().tol_rad))
          << "k = " << k << ", " << plain.report();
    }
  }
}
}  // namespace psmks
