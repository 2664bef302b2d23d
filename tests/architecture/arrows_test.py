#!/usr/bin/env python3
"""arrows.py finds what it is there to find: small trees with a planted fault each."""

import contextlib
import io
import pathlib
import tempfile
import unittest
from unittest import mock

import arrows

TABLE = """
| folder | holds | may include | and of other libraries |
|---|---|---|---|
| `psmks/geometry` | poses | | Eigen |
| `psmks/paper` | a scheme | geometry | |
| `psmks/joint` | a scheme | geometry | |
| `psmks/core` | the door | geometry, paper, joint | |
| `psmks/mrpt` | MRPT | core | MRPT |
| `apps/slam` | a program | core, mrpt | CLI11 |
"""


class Arrows(unittest.TestCase):
    def reports(self, table=TABLE, **files):
        """What arrows.py says of a tree with this table and these files, __ standing for /."""
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            sources = {"docs/architecture.md": table, "psmks/geometry/Pose.h": "#include <Eigen/Core>\n"}
            sources.update({name.replace("__", "/") + ".cpp": text for name, text in files.items()})
            for name, text in sources.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text)
            said = io.StringIO()
            with mock.patch("sys.argv", ["arrows.py", folder]), contextlib.redirect_stderr(said):
                code = arrows.main()
            self.assertEqual(code, 1 if said.getvalue() else 0)
            return said.getvalue()

    def test_accepts_what_the_table_allows(self):
        self.assertEqual(self.reports(
            psmks__core__A="#include <psmks/joint/B.h>\n#include <psmks/core/A.h>\n#include <vector>\n",
            apps__slam__sub__B="#include <CLI/CLI.hpp>\n#include <apps/slam/A.h>\n"), "")

    def test_reports_an_include_of_a_folder_that_is_not_allowed(self):
        self.assertIn("psmks/geometry/A.cpp:2: psmks/geometry may not include psmks/core",
                      self.reports(psmks__geometry__A="\n#include <psmks/core/Matcher.h>\n"))

    def test_reports_a_library_that_is_not_allowed(self):
        self.assertIn("psmks/core may not include MRPT",
                      self.reports(psmks__core__A="#include <mrpt/poses/CPose2D.h>\n"))

    def test_reports_a_folder_without_a_row(self):
        self.assertIn("no row", self.reports(psmks__novel__A="#include <vector>\n"))
        self.assertIn("no row", self.reports(psmks__core__A="#include <psmks/novel/A.h>\n"))

    def test_reports_a_cycle_of_the_table(self):
        cycle = TABLE.replace("| poses | |", "| poses | core |")
        self.assertIn("cycle through psmks/core", self.reports(cycle))

    def test_reports_that_the_schemes_could_reach_each_other(self):
        reaching = TABLE.replace("`psmks/paper` | a scheme | geometry", "`psmks/paper` | a scheme | joint")
        self.assertIn("from psmks/paper to psmks/joint", self.reports(reaching))

    def test_reports_a_way_to_mrpt_from_a_folder_that_is_free_of_it(self):
        leading = TABLE.replace("| core, mrpt | CLI11 |", "| core, mrpt | CLI11 |\n"
                                "| `psmks/sim` | worlds | mrpt | |")
        self.assertIn("psmks/sim, which is free of MRPT", self.reports(leading))

    def test_reports_a_document_without_a_table(self):
        self.assertIn("no table", self.reports("# Architecture\n"))


if __name__ == "__main__":
    unittest.main()
