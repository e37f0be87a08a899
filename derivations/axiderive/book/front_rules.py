"""The spread of rules that hold for every profile: on the homogeneous half-space left, on the graded one right."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from ..entry import COMPACT
from ..physics import normal, viscoelastic
from ..physics.medium import GRADED, HOMOGENEOUS, Medium
from ..physics.systems import BY_NAME, SYSTEMS
from ..print.formula import Printer
from ..rows import laws
from ..rows.row import Kind, rule


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
Section = tuple[str, str, Sequence[Line]]
"""Title, note and lines of one kind of contact; a line holds one rule or two."""


def homogeneous() -> list[Section]:
    """The left page."""
    return [
        ("Normal contact", "", [*_inverses("normal"), (_stiffness(HOMOGENEOUS), _mean("normal"))]),
        *_superposed(HOMOGENEOUS),
        (
            "Viscoelastic half-space",
            r"while the contact grows; laws on page \pageref{part:laws}",
            [(_viscoelastic(kind),) for kind in laws.RULES],
        ),
    ]


def graded() -> list[Section]:
    """The right page."""
    integrals = [(_integral("d"),), (_integral("F"),), *_lines("graded.normal", (("p",), ("w",)))]
    return [
        ("Normal contact", "", [*integrals, (_stiffness(GRADED), _mean("graded.normal"))]),
        *_superposed(GRADED),
    ]


def rule_rows() -> list[RuleRow]:
    """All rules of the spread."""
    return [one for page in (homogeneous(), graded()) for _, _, lines in page for line in lines for one in line]


def _superposed(medium: Medium) -> list[Section]:
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
