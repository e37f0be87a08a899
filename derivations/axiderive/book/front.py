"""The front of the book as plain data: tree and table of all profiles, definitions, special functions, rules.

The rules hold for every profile: on the homogeneous half-space left, on the graded one right.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from ..entry import COMPACT, COMPLETE, FOUR, Entry
from ..physics import complete, normal, subsurface, viscoelastic
from ..physics.medium import GRADED, HOMOGENEOUS, Medium
from ..physics.systems import BY_NAME, SYSTEMS
from ..print.box import width
from ..print.formula import Printer
from ..print.shorthand import with_kappa
from ..profiles.pools import ROUND, STRIPS
from ..rows import fields, laws
from ..rows.row import Kind, rule
from . import texts


def master_row(entries: Mapping[str, Entry]) -> dict[str, str]:
    """Depth and force for the table of all profiles; what is too wide for it is referred to."""
    found = {}
    for name, suffixes, room in (("d", ("d",), 158.0), ("F", ("F", "P"), 200.0)):
        own = next((suffix for suffix in suffixes if suffix in entries), None)
        found[name] = _cell(entries[own], room) if own else ""
    return found


def _cell(entry: Entry, room: float) -> str:
    case = entry.cases[-1]
    short = with_kappa(case.expr)
    text = Printer(case.chain, short.names)(short.expr)
    return rf"$\displaystyle {text}$" if width(text) <= room else rf"\eqr{{{entry.key}}}"


def master_rows() -> list[dict[str, str]]:
    """The special functions of the catalogue with their definitions."""
    names = ("name", "definition", "remark")
    return [dict(zip(names, row, strict=True)) for row in texts.rows(texts.text("functions"))]


ABREAST = 4
"""Answers on a line."""


def chart(summaries: Sequence[Mapping[str, Any]]) -> list[dict[str, Any]]:
    """The questions with the answers of which the edition has an entry, in lines, and with the kind of the bodies."""
    known = {m["name"]: m for m in summaries}
    found = []
    for head, answers in texts.sections("chart").items():
        question, hint, kind = head.split(" | ")
        shown = [
            {"name": name, "number": known[name]["number"], "title": known[name]["title"], "words": words,
             "shape": known[name]["shape"]}
            for name, words in texts.rows(answers) if name in known
        ]  # fmt: skip
        if shown:
            lines = [shown[i : i + ABREAST] for i in range(0, len(shown), ABREAST)]
            found.append({"question": question, "hint": hint, "kind": kind, "lines": lines})
    return found


def suffixes() -> list[tuple[str, list[tuple[str, str]]]]:
    """What the end of a key means, by kind of contact, in the words of the rows; without the four laws spelled out."""
    found = []
    for own in SYSTEMS:
        physics, ends = own.physics, dict[str, str]()
        if own.medium.graded or own.pool not in (ROUND, STRIPS):
            continue
        group = f"{own.group}." if own.group else ""
        title = own.heading + (f"; graded: .{GRADED.group}.{own.group}" if group and GRADED in physics.wording else "")
        for q in (q for table in physics.quantities.values() for q in table.values()):
            suffix = q.suffix.partition("_")[0] + "_..." if "_" in q.suffix else q.suffix
            words, small = q.heading
            ends.setdefault(f"{group}{suffix}", f"{words}, {small}" if small else words)
        found.append((title, list(ends.items())))
    return found


DEFINED = (*FOUR, "k")
"""Quantities whose definitions stand in front of the book; the depth of a complete contact is free."""


def definition_rows() -> list[tuple[str, str, str]]:
    """Label, general formula and equation numbers of every quantity, compact contact first."""
    printer = Printer()
    rows = []
    for title, quantities, formulas, equations in (
        ("", COMPACT, normal.definitions(), normal.REFERENCES),
        ("complete contact: ", COMPLETE, complete.definitions(HOMOGENEOUS), complete.REFERENCES),
    ):
        for suffix in DEFINED:
            if suffix in formulas:
                left = quantities[suffix].left
                right = "=" + printer(HOMOGENEOUS.stiffness() if suffix == "k" else formulas[suffix])
                rows.append(
                    (
                        title + quantities[suffix].label.lower().replace(" outside", ""),
                        left + right,
                        ", ".join(equations[suffix][0]),
                    )
                )
    return [(label[0].upper() + label[1:], text, numbers) for label, text, numbers in rows]


Section = tuple[str, str, Sequence[Sequence[tuple[str, str, str]]]]
"""Title, note and lines of one row or two, each with label, small words and formula."""


def stress_rows() -> list[Section]:
    """What the numbers below the surface say, each row with the component that it gives."""
    printer = Printer(names={subsurface.ANGLE: r"\varphi"})
    tables = (
        ("Normal load", "tension positive", _component, subsurface.STRESS),
        ("Displacement under the normal load", "", lambda axis: f"u_{{{axis}}}", subsurface.DISPLACEMENT),
        ("What friction adds", r"traction $\mu p$, $\varphi$ from its direction", _component, subsurface.FRICTION),
    )
    return [
        (title, note, [((left, "", f"{_left(left, named)}={printer(right)}"),) for left, right in table.items()])
        for title, note, named, table in tables
    ]


def number_rows() -> tuple[Section, list[Section]]:
    """What profiles are made of; the letters and the numbers of flat punch and slopes."""
    sums = [
        (profile.title, "edge in contact" if fields.touches_later(profile) else "", fields.total(own))
        for profile in map(ROUND.load, ROUND.names)
        if (own := fields.parts(profile)) and set(own) <= set(fields.PRINTED)
    ]
    slopes = [
        ((r"\mbox{}" if i else f"$n={n}$", "" if i else fields.SLOPES[n], fields.beside(line)),)
        for n in fields.PRINTED
        for i, line in enumerate(fields.lines(n))
    ]
    letters = [((title, "", tex),) for title, tex in fields.shorthands()]
    return (
        ("Numbers of a profile", fields.MADE_OF, [*_beside(sums), (("Any profile", "", fields.EVERY),)]),
        [
            ("Letters", "", letters),
            ("Numbers", "a formula with $m$ is for the orders without one of their own", slopes),
        ],
    )


def _beside(rows: list[tuple[str, str, str]]) -> list[Sequence[tuple[str, str, str]]]:
    """Those of one part two on a line, the others by themselves."""
    narrow = [one for one in rows if one[2].count("N_") == 1]
    return [*zip(narrow[::2], narrow[1::2], strict=True), *((one,) for one in rows if one not in narrow)]


def _left(components: str, named: Callable[[str], str]) -> str:
    """rr + tt as a sum of stresses."""
    return "".join(named(part) if part.isalpha() else part for part in components.split())


def _component(axes: str) -> str:
    letter = r"\sigma" if axes[0] == axes[1] else r"\tau"
    return f"{letter}_{{{axes}}}"


@dataclass(frozen=True)
class RuleRow:
    """A rule in print, and how it is read back: as the row of this kind of any entry with its suffix."""

    system: str
    suffix: str
    label: str
    small: str
    tex: str
    remark: str = ""
    kind: Kind | None = "rule"
    """None for a defining integral."""

    @property
    def key(self) -> str:
        """The end of the keys that the rule gives, and of its own label: fgm.adh.Dl."""
        return f"{BY_NAME[self.system].group}.{self.suffix}".lstrip(".")


Line = tuple[RuleRow, ...]
Rules = tuple[str, str, Sequence[Line]]
"""Title, note and lines of one kind of contact; a line holds one rule or two."""


def homogeneous() -> list[Rules]:
    """The rules of the homogeneous half-space."""
    return [
        ("Normal contact", "", [*_inverses("normal"), (_stiffness(HOMOGENEOUS), _mean("normal"))]),
        *_superposed(HOMOGENEOUS),
        (
            "Viscoelastic half-space",
            r"while the contact grows; laws on page \pageref{part:laws}",
            [(_viscoelastic(kind),) for kind in laws.RULES],
        ),
    ]


def graded() -> list[Rules]:
    """The rules on the page behind, of the graded half-space."""
    integrals = [(_integral("d"),), (_integral("F"),), *_lines("graded.normal", (("p",), ("w",)))]
    return [
        ("Normal contact", "", [*integrals, (_stiffness(GRADED), _mean("graded.normal"))]),
        *_superposed(GRADED),
    ]


def rule_rows() -> list[RuleRow]:
    """All rules of both half-spaces."""
    return [one for page in (homogeneous(), graded()) for _, _, lines in page for line in lines for one in line]


def _superposed(medium: Medium) -> list[Rules]:
    """What stands above the normal contact, as each physics says it."""
    return [
        (BY_NAME[own.physics.name].heading, own.physics.noted, _lines(own.name, own.said.spread))
        for own in SYSTEMS
        if own.medium is medium and own.said.spread
    ]


def _lines(system: str, suffixes: Sequence[Sequence[str]]) -> list[Line]:
    return [tuple(_rule(system, suffix) for suffix in line) for line in suffixes]


def _rule(system: str, suffix: str) -> RuleRow:
    found = rule(BY_NAME[system], suffix)
    assert found is not None
    quantities, *_ = BY_NAME[system].physics.quantities.values()
    label, small = quantities[suffix].heading
    small = f"${found.where}$" if found.where else small
    return RuleRow(system, suffix, label, small, found.tex, found.remark)


def _labelled(system: str, suffix: str, tex: str, remark: str, kind: Kind | None) -> RuleRow:
    return RuleRow(system, suffix, *COMPACT[suffix].heading, tex, remark, kind)


def _inverses(system: str) -> list[Line]:
    return [
        tuple(_labelled(system, q.suffix, q.solves, "solved for $a$", "root") for q in COMPACT.values() if q.solves),
        (
            _labelled(system, "Fd", r"F_{\mathrm N}=F_{\mathrm N}(a)", "where $g(a)=d$", "composition"),
            _labelled(system, "dF", "d=g(a)", r"where $F_{\mathrm N}(a)=F_{\mathrm N}$", "composition"),
        ),
    ]


def _stiffness(medium: Medium) -> RuleRow:
    system = "normal" if medium is HOMOGENEOUS else "graded.normal"
    return _labelled(system, "k", f"{COMPACT['k'].left}={Printer()(medium.stiffness())}", "", "formula")


def _mean(system: str) -> RuleRow:
    return _labelled(system, "pm", r"\bar p=\frac{F_{\mathrm N}(a)}{\pi a^{2}}", "", "rule")


def _integral(suffix: str) -> RuleRow:
    """Depth or force on the graded half-space from the profile."""
    return _labelled(
        "graded.normal", suffix, f"{COMPACT[suffix].left}={Printer()(normal.definitions(GRADED)[suffix])}", "", None
    )


def _viscoelastic(kind: str) -> RuleRow:
    label, small = viscoelastic.QUANTITIES[f"{kind}_{viscoelastic.LAWS[0].suffix}"].heading
    remark = {"load": "solved for $a$", "ramp": r"where $F_{\mathrm N}\sim d^m$"}.get(kind, "")
    return RuleRow("viscoelastic", kind, label, small, laws.RULES[kind], remark)
