"""What scripts/psmks_constants.py reads from comments, and what it misses in them."""

import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts"))
import psmks_constants as psmks  # noqa: E402


def read(text):
    return psmks.constants_of_text("features/Thing.cpp", text)


class Constants(unittest.TestCase):

    def test_ACompleteCommentGivesAllColumns(self):
        (constant,) = read("/** Depth of a\n * thing. Evidence: half loses it. */\n"
                           "constexpr double kDepth_m = 0.3;\n")
        self.assertEqual(constant.meaning, "Depth of a thing.")
        self.assertEqual((constant.unit, constant.value), ("m", "0.3"))
        self.assertEqual((constant.kind, constant.reason), ("Evidence", "half loses it."))
        self.assertEqual(constant.problems(), [])

    def test_AUnitIsSaidWhereTheNameHasNone(self):
        (constant,) = read("/** Fewest rays. Unit: rays. Definition: two fix a line. */\n"
                           "constexpr int kFewest = 3;\n")
        self.assertEqual((constant.unit, constant.kind), ("rays", "Definition"))
        self.assertEqual(constant.problems(), [])

    def test_OneCommentStandsForAStatement(self):
        constants = read("/** Apart. Evidence: measured. */\n"
                         "  static constexpr double kApart_m = 0.1, kApart_rad = degToRad(5);\n")
        self.assertEqual([c.name for c in constants], ["kApart_m", "kApart_rad"])
        self.assertEqual([c.unit for c in constants], ["m", "rad"])
        self.assertEqual(constants[1].value, "degToRad(5)")
        self.assertTrue(all(c.is_measured for c in constants))

    def test_WhatACommentLacksIsNamed(self):
        bare, unitless, groundless = read(
            "constexpr double kBare_m = 1;\n"
            "/** Share. Evidence: a choice. */\nconstexpr double kUnitless = 1;\n"
            "/** Reach. */\nconstexpr double kGroundless_m = 1;\n")
        self.assertEqual(len(bare.problems()), 2)
        self.assertRegex(bare.problems()[0], "psmks/features/Thing.cpp:kBare_m lacks a meaning")
        self.assertRegex(unitless.problems()[0], "lacks a unit")
        self.assertRegex(groundless.problems()[0], "lacks 'Evidence")

    def test_ACommentBehindTheStatementIsNone(self):
        (constant,) = read("constexpr double kShare = 0.5;  //!< of the rays\n")
        self.assertEqual(len(constant.problems()), 3)

    def test_ScaledValuesKeepTheirForm(self):
        angle, count, one = read("constexpr double kTurn_rad = degToRad(5);\n"
                                 "constexpr int kRays = 3;\nconstexpr int kOne = 1;\n")
        self.assertEqual(angle.scaled(0.5), "degToRad(2.5)")
        self.assertEqual((count.scaled(0.5), count.scaled(2)), ("2", "6"))
        self.assertEqual(one.scaled(0.5), "")


if __name__ == "__main__":
    unittest.main()
