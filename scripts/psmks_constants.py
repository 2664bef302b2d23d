"""Reads the named constants of the sources, with what their comments say of them.

The comment of a constant has a fixed form:

    /** Meaning. Unit: unit. Evidence: why it is this number. */
    constexpr double kName_m = 0.3;

The unit is left out where the name ends in one. `Definition:` in place of `Evidence:` marks a number
that does not steer the method, with the reason: a conversion, a capacity, a numerical tolerance. One
comment may stand for all constants of one statement. `measured` as evidence stands for the figures in
docs/constants-measured.csv, which scripts/measure-constants writes; `open` means that they are yet to be
measured.
"""

import re
from dataclasses import dataclass
from pathlib import Path

# The folders of the method, in the order in which a match goes through them.
FOLDERS = ["geometry", "segmentation", "features", "match", "joint", "paper", "core", "psm", "motion",
           "slam"]

# What a constant is measured at, and the rows of the code as it is for each kind of measurement: the
# paper's scheme on pairs of scans; trajectories of logs; pairs of scans and steps of a log; all of these.
FACTORS = {"half": 0.5, "double": 2.0}
AS_IS = {"paper": "(as it is: paper)", "trajectory": "(as it is: trajectory)",
         "pairs": "(as it is: pairs)", "match": "(as it is: match)"}
KIND_OF_FOLDER = {"paper": "paper", "slam": "trajectory", "motion": "trajectory", "joint": "pairs",
                  "features": "pairs"}
WHOLE_TYPES = {"int", "std::size_t", "std::ptrdiff_t", "long long"}

UNITS = {"m": "m", "rad": "rad", "deg": "deg", "s": "s", "m2": "m^2", "1_m": "1/m", "px": "px"}

_STATEMENT = re.compile(
    r"(?P<comment>/\*\*(?:(?!\*/).)*\*/[ \t]*\n)?"
    r"(?P<head>[ \t]*(?:static[ \t]+|inline[ \t]+)*constexpr[ \t]+(?P<type>[\w:<>, ]+?)[ \t]+)"
    r"(?P<body>k[A-Z]\w*[^;()]*(?:\([^;]*)?);", re.DOTALL)
_PART = re.compile(r"(k[A-Z]\w*)((?:\[\])?)\s*(?:=\s*(.+)|(\{.+))\s*$", re.DOTALL)


@dataclass
class Constant:
    """One named constant, and where its value stands in the text of its file."""

    file: str  # relative to psmks/
    name: str
    type: str
    value: str
    meaning: str = ""
    unit: str = ""
    kind: str = ""  # Evidence or Definition
    reason: str = ""
    span: tuple = (0, 0)  # of the value in the file

    @property
    def folder(self):
        return self.file.split("/")[0]

    @property
    def key(self):
        return f"{self.file}:{self.name}"

    @property
    def is_measured(self):
        """Whether the evidence names the measurement."""
        return self.kind == "Evidence" and re.search(r"\bmeasured\b", self.reason) is not None

    @property
    def is_open(self):
        """Whether the constant waits for its measurement."""
        return self.kind == "Evidence" and self.reason.startswith("open")

    @property
    def measured_kind(self):
        """Which figures tell what the constant is worth."""
        return KIND_OF_FOLDER.get(self.folder, "match")

    def scaled(self, factor):
        """The scaled value as text; nothing where a whole number stays the same."""
        number = re.fullmatch(r"(degToRad\()?([-+\d.eE]+)[fF]?\)?", self.value)
        if not number:
            return f"{factor:g} * ({self.value})"
        value = float(number.group(2)) * factor
        if self.type in WHOLE_TYPES:
            value = int(value + 0.5)
            if value == int(float(number.group(2))):
                return ""
        return f"degToRad({value:g})" if number.group(1) else f"{value:g}"

    def problems(self):
        """What the comment of this constant lacks, in words."""
        lacks = []
        if not self.meaning:
            lacks.append("a meaning")
        if not self.unit:
            lacks.append("a unit ('Unit: ...' or a name that ends in one)")
        if not self.kind or not self.reason:
            lacks.append("'Evidence: ...' or 'Definition: ...'")
        return [f"psmks/{self.key} lacks {what}" for what in lacks]


def _plain(comment):
    """The text of a comment without its marks and line ends."""
    text = re.sub(r"^\s*/\*\*|\*/\s*$", "", comment.strip())
    text = re.sub(r"\n\s*\*?[ \t]?", " ", text)
    return re.sub(r"\s+", " ", text).strip()


def _read_comment(text):
    """Meaning, unit, kind and reason from the plain text of a comment."""
    kind = reason = unit = ""
    found = re.search(r"\b(Evidence|Definition): ", text)
    if found:
        kind, reason = found.group(1), text[found.end():].strip()
        text = text[:found.start()].strip()
    found = re.search(r"\bUnit: ([^.]+)\.", text)
    if found:
        unit = found.group(1).strip()
        text = (text[:found.start()] + text[found.end():]).strip()
    return text, unit, kind, reason


def _unit_of_name(name):
    for suffix in sorted(UNITS, key=len, reverse=True):
        if name.endswith("_" + suffix):
            return UNITS[suffix]
    return ""


def _parts(body):
    """The declarators of a statement, with where each begins."""
    depth = begin = 0
    for i, character in enumerate(body + ","):
        depth += (character in "({[") - (character in ")}]")
        if character == "," and depth == 0:
            yield begin, body[begin:i]
            begin = i + 1


def constants_of_text(file, text):
    """All named constants in the text of a file."""
    found = []
    for statement in _STATEMENT.finditer(text):
        meaning, unit, kind, reason = _read_comment(_plain(statement.group("comment") or ""))
        for begin, declarator in _parts(statement.group("body")):
            part = _PART.match(declarator.strip())
            if not part:
                continue
            value = (part.group(3) or part.group(4)).strip()
            at = statement.start("body") + begin + declarator.index(value)
            name = part.group(1)
            found.append(Constant(file, name, statement.group("type").strip(),
                                  re.sub(r"\s+", " ", value), meaning, unit or _unit_of_name(name),
                                  kind, reason, (at, at + len(value))))
    return found


def constants_of(root, folders=None):
    """All named constants of the folders beneath psmks/, sorted by folder and file.

    Constants of one name in one file are told apart by a number: the second is `kName (2)`."""
    constants = []
    for folder in folders or FOLDERS:
        for path in sorted((Path(root) / "psmks" / folder).glob("*.[hc]*")):
            file = f"{folder}/{path.name}"
            times = {}
            for constant in constants_of_text(file, path.read_text()):
                times[constant.name] = times.get(constant.name, 0) + 1
                if times[constant.name] > 1:
                    constant.name += f" ({times[constant.name]})"
                constants.append(constant)
    return constants
