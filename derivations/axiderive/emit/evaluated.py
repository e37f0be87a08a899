"""Evaluation forms in print: how the catalogue computes an entry where that differs from the closed form."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import sympy as sp

from ..entry import Entry
from ..profiles.profile import Profile
from ..stable import opaque
from ..stable.forms import EvaluationForm, evaluation_form
from ..stable.signs import facts_of
from .naming import LEFT
from .printer import Printer
from .ranges import chain_of, condition, regions
from .rows import MOST_LINES, Region, broken
from .shorthand import LINE
from .width import width

SHOWN = {"d": "g(a)", "F": LEFT["F"], "p": LEFT["p"], "w": LEFT["w"]}
"""The quantities whose evaluation forms are printed, with their left sides."""


def evaluation_rows(
    profile: Profile, entries: Mapping[str, Entry], evidence: Mapping[str, Any]
) -> list[dict[str, Any]]:
    """A row for each formula that is evaluated as another closed formula of at most two lines.

    `evidence` is that of the normal contact, whose measurements say which functions are closed formulas; kernels,
    rules and iterations are only named in the table of the evidence.
    """
    measured = evidence.get("evaluation", {})
    rows = []
    for suffix in SHOWN:
        if measured.get(suffix, {}).get("form") != "closed":
            continue
        entry = entries[suffix]
        for pairs, expr in regions(entry):
            chain = chain_of(entry, expr)
            lines = evaluated(SHOWN[suffix], expr, form_of(profile, expr, chain), chain)
            if 0 < len(lines) <= MOST_LINES and max(map(width, lines)) <= LINE:
                rows.append(_row(entry, Region(condition(entry, pairs, chain, Printer(chain)), tuple(lines))))
    return rows


def form_of(profile: Profile, expr: sp.Expr, chain: tuple[sp.Expr, ...]) -> EvaluationForm:
    """The evaluation form of a case, from what is known of its lengths."""
    return evaluation_form(expr, facts_of(chain, *((rule.left, rule.right) for rule in profile.rules)))


def _row(entry: Entry, region: Region) -> dict[str, Any]:
    return {
        "half": False,
        "comment": f"evaluation {entry.key}",
        "label": "Evaluated as",
        "small": region.condition and f"${region.condition}$",
        "tex": region.tex,
        "remark": "",
    }


def evaluated(left: str, expr: sp.Expr, form: EvaluationForm, chain: tuple[sp.Expr, ...]) -> list[str]:
    r"""The form as lines of one formula, roots as \sqrt{(x-y) (x+y)}; none if it loses digits or is the closed form."""
    value, names = form.value, {}
    for name, definition in reversed(form.steps):
        if isinstance(definition, opaque.Root):
            names[name] = _root(*definition.args)
        else:
            value = value.subs(name, _plain(definition))
    roots = {name: sp.sqrt(x**2 - y**2) for name, (x, y) in _lengths(form).items()}
    if form.cancels or value.has(*_KERNELS) or sp.expand(value.subs(roots) - expr) == 0:
        return []
    return broken(f"{left}=", value, Printer(chain, names))


_KERNELS = (
    opaque.Log1p, opaque.Expm1, opaque.ArctanGap, opaque.TanhGap, opaque.GammaRatio, opaque.ArcStrips,
    opaque.PowerPressure, opaque.PowerDisplacement, opaque.PowerPunches, opaque.PowerStrips,
)  # fmt: skip
"""Functions of the generated code without a name in print."""


def _plain(definition: sp.Expr) -> sp.Expr:
    return definition.replace(opaque.Arctan2, lambda y, x: sp.atan(y / x))


def _lengths(form: EvaluationForm) -> dict[sp.Symbol, tuple[sp.Expr, sp.Expr]]:
    return {name: definition.args for name, definition in form.steps if isinstance(definition, opaque.Root)}


def _root(x: sp.Expr, y: sp.Expr) -> str:
    one, other = Printer()(x), Printer()(y)
    return rf"\sqrt{{({one}-{other}) ({one}+{other})}}"
