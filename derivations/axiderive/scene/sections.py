"""The sections of a stored page that a scene needs: those of its kind of contact, and the evidence of these."""

from __future__ import annotations

import re

SECTIONS = {
    "normal": ("Normal contact",),
    "adhesive": ("Normal contact", "Adhesive contact"),
    "tangential": ("Normal contact", "Tangential contact"),
    "graded": ("Normal contact", "Power-law graded half-space"),
    "graded.adhesive": ("Power-law graded half-space", "Adhesive contact, graded half-space"),
    "graded.tangential": ("Power-law graded half-space", "Tangential contact, graded half-space"),
    "viscoelastic": ("Normal contact", "Viscoelastic half-space"),
    "plane": ("Plane contact",),
    "loads": ("Displacement",),
}
ALWAYS = ("Derivation", "Evidence")
GROUPS = {
    "adhesive": ("", "adh."), "tangential": ("", "tan."), "graded": ("", "fgm."), "viscoelastic": ("", "vis."),
    "graded.adhesive": ("fgm.", "fgm.adh."), "graded.tangential": ("fgm.", "fgm.tan."),
}  # fmt: skip
"""Prefixes of the keys in the evidence of a kind of contact."""
HEADING = re.compile(r"^\\sect(?:\[.*\])?\{([^{}]*)\}$", re.MULTILINE)
TABLE = re.compile(r"\\vspace\{1mm\}\{[^\n]*certificate, and the fewest.*?\\end\{tabular\*\}\\par\}\n", re.DOTALL)
OPENED = re.compile(r"^\\par\\needspace[^\n]*\\begin\{minipage\}[^\n]*\n\Z", re.MULTILINE)
PLAIN = re.compile(
    r"^\{\\fontsize\{[\d.]+\}\{[\d.]+\}\\selectfont%\n.*?\\end\{tabular\*\}\\par\}\n", re.MULTILINE | re.DOTALL
)
"""The table of the homogeneous normal contact, the first one."""
CELL = re.compile(r"\\own\{([\w.]+)\} & [^&\n]* & [^&\n]* & \\textcolor\{note\}\{[^{}]*\}")
REASONS = re.compile(r"^\\vspace\{\.8mm\}.*No certificate:.*\n", re.MULTILINE)
REASON = re.compile(r"((?:\\own\{[\w.]+\} )+)(\\textcolor\{note\}\{(?:[^{}]|\\own\{[\w.]+\})*\} ?)")
MARK = re.compile(r"\\own\{([\w.]+)\} ")


def sections_for(page: str, physics: str) -> str:
    """The page without the sections of other kinds of contact and without examples at other values."""
    physics = physics if physics in SECTIONS else physics.partition(".")[0]
    places = list(HEADING.finditer(page))
    kept, opened = [page[: places[0].start()]] if places else [page], ""
    for heading, following in zip(places, [*places[1:], None], strict=True):
        text = page[heading.start() : following.start() if following else len(page)]
        # the box around the derivation opens above a section that may be left out
        last = OPENED.search(text)
        text, after = (text[: last.start()], last[0]) if last else (text, "")
        if heading[1] in (*SECTIONS[physics], *ALWAYS):
            kept.append(opened)
            opened = ""
            kept.append(_evidence(text, GROUPS.get(physics, ("",))) if heading[1] == "Evidence" else text)
        opened += after
    return "".join(kept)


def _evidence(text: str, groups: tuple[str, ...]) -> str:
    """The table of the other kinds of contact, and the reasons below it, for this one."""

    def belongs(match: re.Match[str]) -> bool:
        prefix = match[1].rpartition(".")[0]
        return (f"{prefix}." if prefix else "") in groups

    def table(match: re.Match[str]) -> str:
        cells = [cell[0] for cell in CELL.finditer(match[0]) if belongs(cell)]
        columns = max(line.count("\\own") for line in match[0].splitlines())
        rows = [" & ".join(cells[i : i + columns]) + "\\\\\n" for i in range(0, len(cells), columns)]
        first, last = match[0].index("\\own"), match[0].index("\\end{tabular*}")
        return match[0][:first] + "".join(rows) + match[0][last:] if rows else ""

    def reason(match: re.Match[str]) -> str:
        marks = "".join(mark[0] for mark in MARK.finditer(match[1]) if belongs(mark))
        return marks + match[2] if marks else ""

    def reasons(match: re.Match[str]) -> str:
        line = REASON.sub(reason, match[0])
        return line if MARK.search(line) else ""

    if "" not in groups:
        text = PLAIN.sub("", text)
    return REASONS.sub(reasons, TABLE.sub(table, text))
