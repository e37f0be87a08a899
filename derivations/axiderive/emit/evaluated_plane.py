"""How the catalogue computes a plane contact, in print: closed forms without cancellation, or strips by Gauss rules."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from .. import notation as nt
from ..contact.plane import PRESSURE, SURFACE
from ..entry import Entry
from ..profiles.profile import Profile
from ..stable import opaque
from ..stable.chosen import chosen
from ..stable.forms import EvaluationForm
from ..stable.signs import facts_of
from ..stable.slopes import rate_key, slope_form
from .evaluated import Rows, evaluated, evaluation_row, printed
from .height import bracket
from .naming import PLANE
from .plane.complete import excess_over_threshold, parts
from .plane.forms import form_of
from .printer import Printer
from .ranges import chain_of, condition, regions
from .rows import MOST_LINES, Region
from .shorthand import LINE
from .width import width

SHOWN = ("P", "p", "s", "d")


def plane_rows(profile: Profile, entries: Mapping[str, Entry]) -> Rows:
    """A row for each formula that is evaluated as another one, or as an integral over strips of the load P'(t) dt."""
    if nt.e in profile.parameters:
        return []
    if "Pmin" in entries:
        return _concave(entries)
    rows: Rows = []
    ruled = []
    for suffix in SHOWN:
        if suffix not in entries:
            continue
        own = _closed(entries[suffix])
        if own is None:
            ruled.append(suffix)
        else:
            rows += own
    return rows + (_by_rules(profile, entries, ruled) if ruled else [])


def _concave(entries: Mapping[str, Entry]) -> Rows:
    """The load and the hollow face apart; the pressure over the load at which the whole face first touches."""
    rows, face = [], excess_over_threshold(entries)
    for suffix in ("p", "s", "d"):
        entry = entries[suffix]
        ((pairs, expr),) = regions(entry)
        chain = chain_of(entry, expr)
        if suffix == "p" and face is not None:
            carried = f"P-{PLANE['Pmin']}+{Printer()(face)}"
            where = f"{PLANE['Pmin']}={Printer()(entries['Pmin'].cases[0].expr)}"
            lines = [rf"p(x)=\frac{{1}}{{\pi \sqrt{{(a-x) (a+x)}}}} \, {bracket(carried)},\qquad {where}"]
        else:
            _, forms = parts(entry, True, chosen(entry.key).below)
            steps = dict(step for form in forms for step in form.steps)
            value = sp.Add(*(form.value for form in forms))
            lines = printed(PLANE[suffix], EvaluationForm(tuple(steps.items()), value, False), chain)
        rows.append(evaluation_row(entry, Region(condition(entry, pairs, chain, Printer(chain)), tuple(lines))))
    return rows


def _closed(entry: Entry) -> Rows | None:
    """The rows of an entry, None where one of its cases is summed by a rule."""
    rows = []
    for pairs, expr in regions(entry):
        case = next(case for case in entry.cases if case.expr == expr)
        form = form_of(case, chosen(entry.key).below)
        if form.cancels:
            return None
        chain = chain_of(entry, expr)
        lines = evaluated(PLANE[entry.suffix], expr, form, chain)
        if 0 < len(lines) <= MOST_LINES + 1 and max(map(width, lines)) <= LINE:
            rows.append(evaluation_row(entry, Region(condition(entry, pairs, chain, Printer(chain)), tuple(lines))))
    return rows


def _by_rules(profile: Profile, entries: Mapping[str, Entry], suffixes: list[str]) -> Rows:
    """The integrals over the strips, and the growth P'(t) of the load under them in its evaluation form."""
    start = Printer()(profile.breaks[0]) if profile.truncated else "0"
    rows: Rows = [
        {
            "half": True,
            "comment": f"rule {entries[suffix].key}",
            "label": "Evaluated as",
            "small": _reach(chosen(entries[suffix].key).beyond, profile),
            "tex": integral(suffix, start),
            "remark": "",
        }
        for suffix in suffixes
    ]
    own = regions(entries["P"])
    for pairs, expr in own:
        chain = tuple(nt.t if length == nt.a else length for length in chain_of(entries["P"], expr))
        facts = facts_of(chain_of(entries["P"], expr))
        form = slope_form(expr / nt.E_star, facts, chosen(rate_key(entries["P"])))
        value = nt.E_star * form.value
        for name, definition in form.steps:  # sqrt(root^2 + b^2) is t
            if isinstance(definition, opaque.Root) and definition.args[0] == nt.t:
                value = value.subs(sp.sqrt(name**2 + definition.args[1] ** 2), nt.t)
        form = EvaluationForm(form.steps, value, form.cancels)
        moved = tuple((low.subs(nt.a, nt.t), high.subs(nt.a, nt.t)) for low, high in pairs)
        where = ",\\; ".join(f"{Printer()(low)}<{Printer()(high)}" for low, high in moved) if len(own) > 1 else ""
        rows.append(
            {
                "half": False,
                "comment": f"slope {entries['P'].key}",
                "label": "With the growth",
                "small": where and f"${where}$",
                "tex": Region("", tuple(printed("P'(t)", form, chain))).tex,
                "remark": "",
            }
        )
    return rows


def _reach(beyond: float, profile: Profile) -> str:
    """How the entry is evaluated, up to the multiple of the break from which on its closed form is."""
    return rf"Gauss rules, $a<{beyond:g}\,{Printer()(profile.breaks[0])}$" if beyond else "by Gauss rules"


def integral(suffix: str, start: str) -> str:
    """The strips of the load P'(t) dt between two half-widths of the growing contact."""
    scale = Printer()
    growth = "P'(t)"
    if suffix == "P":
        return rf"P=\int_{{{start}}}^{{a}} {growth}\,\mathrm{{d}}t"
    if suffix == "p":
        low = "x" if start == "0" else rf"\max(x,{start})"
        root = r"\sqrt{t^{2}-x^{2}}"
        return rf"p(x)={scale(PRESSURE)}\int_{{{low}}}^{{a}} \frac{{{growth}}}{{{root}}}\,\mathrm{{d}}t"
    if suffix == "s":
        root = r"\sqrt{x^{2}-t^{2}}"
        front = scale(SURFACE / nt.E_star)
        return rf"{PLANE['s']}=-{front}\int_{{{start}}}^{{a}} \frac{{{growth}}}{{{root}}}\,\mathrm{{d}}t"
    front = scale(SURFACE / nt.E_star)
    return rf"d={front}\int_{{{start}}}^{{a}} {growth} \, \operatorname{{arcosh}} \frac{{L}}{{t}}\,\mathrm{{d}}t"
