#!/usr/bin/env python3
"""Holds the includes below psmks/ and apps/ against the table of docs/architecture.md.

Each row of the table names a folder, the folders whose headers it may include, and the other libraries
that it may include. This program reports

- an include that no row allows,
- a folder that has sources and no row,
- a cycle among the rows,
- a folder of a library without MRPT that may include one with MRPT,
- a way, direct or through other folders, from psmks/paper to psmks/joint or back.

usage: arrows.py [ROOT]     the root of the sources, else that of this file; exits with 1 on a report
"""

import pathlib
import re
import sys

# The first folder of an include tells the library it belongs to.
LIBRARIES = {
    "mrpt": "MRPT",
    "opencv2": "OpenCV",
    "Eigen": "Eigen",
    "ceres": "Ceres",
    "zlib.h": "zlib",
    "pcl": "PCL",
    "CLI": "CLI11",
    "nlohmann": "nlohmann-json",
    "rosbag": "ROS",
    "sensor_msgs": "ROS",
    "nav_msgs": "ROS",
    "tf2_msgs": "ROS",
}
NEVER = [("psmks/paper", "psmks/joint"), ("psmks/joint", "psmks/paper")]


def read_table(document):
    """The rows of the table as {folder: (allowed folders, allowed libraries)}."""
    rows = {}
    for line in document.read_text().splitlines():
        row = re.match(r"\| `((?:psmks|apps)/[\w/-]+)` \|[^|]*\|([^|]*)\|([^|]*)\|$", line)
        if row:
            folders = {"psmks/" + name if "/" not in name else name
                       for name in re.findall(r"[\w/-]+", row[2])}
            libraries = set(re.findall(r"[\w-]+", row[3]))
            rows[row[1]] = (folders, libraries)
    return rows


def row_of(path, rows):
    """The row of a file: that of its folder, or of the nearest folder above it that has one."""
    for folder in pathlib.PurePosixPath(path).parents:
        if str(folder) in rows:
            return str(folder)
    return None


def includes(root):
    """(file, line number, included path) of every include below psmks/ and apps/."""
    for part in ("psmks", "apps"):
        for source in sorted((root / part).rglob("*")):
            if source.suffix not in (".h", ".cpp"):
                continue
            for number, line in enumerate(source.read_text().splitlines(), 1):
                include = re.match(r'\s*#\s*include\s*[<"]([^>"]+)[>"]', line)
                if include:
                    yield source.relative_to(root).as_posix(), number, include[1]


def check_include(path, included, rows):
    """What is wrong with an include, or None."""
    own = row_of(path, rows)
    if own is None:
        return "its folder has no row in the table"
    folders, libraries = rows[own]
    first = included.split("/")[0]
    if first in ("psmks", "apps"):
        other = row_of(included, rows)
        if other is None:
            return f"the folder of <{included}> has no row in the table"
        if other != own and other not in folders:
            return f"{own} may not include {other}: <{included}>"
    elif first in LIBRARIES and LIBRARIES[first] not in libraries:
        return f"{own} may not include {LIBRARIES[first]}: <{included}>"
    return None


def reachable(folder, rows):
    """Every folder that can be reached by the arrows of the table, without the folder itself unless
    there is a cycle."""
    found, open_folders = set(), [folder]
    while open_folders:
        for other in rows.get(open_folders.pop(), (set(), set()))[0]:
            if other not in found:
                found.add(other)
                open_folders.append(other)
    return found


def check_table(rows):
    """What is wrong with the table itself."""
    for folder, (folders, libraries) in rows.items():
        for other in sorted(folders - rows.keys()):
            yield f"the table lets {folder} include {other}, which has no row"
        below = reachable(folder, rows)
        if folder in below:
            yield f"the table has a cycle through {folder}"
        if folder.startswith("psmks/") and "MRPT" not in libraries:
            for other in sorted(o for o in folders if "MRPT" in rows.get(o, ((), ()))[1]):
                yield f"the table lets {folder}, which is free of MRPT, include {other}, which is not"
    for folder, other in NEVER:
        if other in reachable(folder, rows):
            yield f"the table leads from {folder} to {other}"


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[2])
    rows = read_table(root / "docs" / "architecture.md")
    reports = list(check_table(rows)) if rows else ["docs/architecture.md has no table of folders"]
    for path, number, included in includes(root):
        fault = check_include(path, included, rows)
        if fault:
            reports.append(f"{path}:{number}: {fault}")
    for report in reports:
        print(report, file=sys.stderr)
    return 1 if reports else 0


if __name__ == "__main__":
    sys.exit(main())
