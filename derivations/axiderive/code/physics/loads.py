"""Modules `axicontact.loads.<load>`: the displacement under a prescribed pressure."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import sympy as sp

from ...entry import Entry
from ...notation import a, r, sigma
from ...physics.medium import HOMOGENEOUS
from ...physics.systems import BY_NAME
from ...profiles.loads import Load
from ...stable.forms import EvaluationForm, plane_form
from ...stable.opaque import Root, named
from ...stable.signs import facts_of
from ..bodies.compact import beside
from ..module import Module
from ..private import PrivateFunctions
from ..text import python
from ..writer import Writer, required

RULES = {sp.S.Zero: "uniform(r, a)", sigma: "power(r, a, s)"}
"""Exponents whose displacement is no elementary function, and w E*/(p_0 a) in the runtime."""
ROOT = named("root")


def module(entries: Mapping[str, Entry]) -> Module:
    """The module of one load."""
    entry = entries["w"]
    writer = Writer(BY_NAME["loads"], entries, entries)
    functions = PrivateFunctions(entry.profile)
    bodies(functions, entries)
    writer.private += functions.functions.values()
    notes = "Frictionless half-space. Negative or NaN radii give NaN."
    writer.add(entry, notes, [required(entry.parameters)])
    return writer.module()


def bodies(functions: PrivateFunctions, entries: Mapping[str, Entry]) -> None:
    """Add the displacement, inside and outside the loaded circle."""
    entry = entries["w"]
    assert isinstance(entry.profile, Load)
    rule = RULES.get(entry.profile.exponent)
    lines = [f"return p_0 / E_star * a * {rule}"] if rule else _by_regions(functions, entry)
    functions.of_entry(entry, lines)


def _by_regions(functions: PrivateFunctions, entry: Entry) -> list[str]:
    inside, outside = (case.expr for case in entry.cases)
    form, lines = _outside(functions, entry, outside), list[str]()
    if form.cancels:
        # the circle sinks like a paraboloid, by what is linear in r**2
        sunk = HOMOGENEOUS.displacement_scale * inside.subs(r, 0)
        value = f"{python(sunk)} * {beside('a', 2)}"
    else:
        lines += functions.steps(form)
        value = functions.value_lines(form.value, lines)
    return [*lines, f"outside = {value}", f"inside = {python(inside)}", "return np.where(r > a, outside, inside)"]


def _outside(functions: PrivateFunctions, entry: Entry, expr: sp.Expr) -> EvaluationForm:
    """The form of what is found outside; in the root as a length of its own where it cancels in the radius."""
    variant = functions.variant(entry)
    form = plane_form(expr, facts_of((a, r)), replace(variant, closed=False))
    if not form.cancels:
        return form
    form = plane_form(expr.subs(r, sp.sqrt(a**2 + ROOT**2)), facts_of(()), variant)
    return replace(form, steps=((ROOT, Root(r, a)), *form.steps))
