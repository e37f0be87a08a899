"""The sections of a stored page that a scene needs: those of its kind of contact, and the evidence of these."""

from __future__ import annotations

import re

SECTIONS = {
    "normal": ("Normal contact",),
    "adhesive": ("Normal contact", "Adhesive contact"),
    "tangential": ("Normal contact", "Tangential contact"),
    "graded": ("Normal contact", "Power-law graded half-space"),
    "viscoelastic": ("Normal contact", "Viscoelastic half-space"),
    "plane": ("Plane contact",),
}
ALWAYS = ("Derivation", "Evidence", "Sources")
GROUPS = {"adhesive": "adh.", "tangential": "tan.", "graded": "fgm.", "viscoelastic": "vis."}
HEADING = re.compile(r"^\\sect(?:\[.*\])?\{([^{}]*)\}$", re.MULTILINE)
TABLE = re.compile(r"\\vspace\{1mm\}\{\\fontsize\{7\.6\}.*?\\end\{tabular\*\}\\par\}\n", re.DOTALL)
CELL = re.compile(r"\\own\{([\w.]+)\} & [^&\n]* & [^&\n]* & \\textcolor\{note\}\{[^{}]*\{?[^{}]*\}?[^{}]*\}")
REASON = re.compile(r"^\\vspace\{\.8mm\}.*no certificate.*\n", re.MULTILINE)
MARK = re.compile(r"\\own\{([\w.]+)\}\\enspace")
COLUMNS = 4


def sections_for(page: str, physics: str) -> str:
    """The page without the sections of other kinds of contact and without examples at other values."""
    places = list(HEADING.finditer(page))
    kept = [page[: places[0].start()]] if places else [page]
    for heading, following in zip(places, [*places[1:], None], strict=True):
        text = page[heading.start() : following.start() if following else len(page)]
        if heading[1] in (*SECTIONS[physics], *ALWAYS):
            kept.append(_evidence(text, GROUPS.get(physics, "")) if heading[1] == "Evidence" else text)
    return "".join(kept)


def _evidence(text: str, group: str) -> str:
    """The table of the other kinds of contact, and the reasons below it, for this one."""

    def belongs(match: re.Match[str]) -> bool:
        prefix = match[1].rpartition(".")[0]
        return not prefix or f"{prefix}." == group

    def table(match: re.Match[str]) -> str:
        cells = [cell[0] for cell in CELL.finditer(match[0]) if belongs(cell)]
        rows = [" & ".join(cells[i : i + COLUMNS]) + "\\\\\n" for i in range(0, len(cells), COLUMNS)]
        first, last = match[0].index("\\own"), match[0].index("\\end{tabular*}")
        return match[0][:first] + "".join(rows) + match[0][last:] if rows else ""

    def reason(match: re.Match[str]) -> str:
        line = MARK.sub(lambda mark: mark[0] if belongs(mark) else "", match[0])
        return line if MARK.search(line) else ""

    return REASON.sub(reason, TABLE.sub(table, text))
