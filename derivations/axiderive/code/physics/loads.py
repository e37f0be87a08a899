"""Modules `axicontact.loads.<load>`: the displacement under a prescribed pressure."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import sympy as sp

from ...entry import Entry
from ...letters import name_of
from ...notation import a, r, sigma
from ...physics.medium import HOMOGENEOUS
from ...profiles.loads import Load
from ...stable.forms import EvaluationForm, plane_form
from ...stable.opaque import Root, named
from ...stable.signs import facts_of
from ..bodies.compact import beside
from ..private import Private, PrivateFunctions
from ..text import python
from . import text
from .examples import Example
from .text import Function, evaluate, private

IMPORTS = (
    "physics.circle: power, uniform",
    "interface: Array, Result, elementwise, require",
    "functions: beside",
    "special: arctan_gap",
    "kernels: OUTSIDE_2",
)
RULES = {sp.S.Zero: "uniform(r, a)", sigma: "power(r, a, s)"}
"""Exponents whose displacement is no elementary function, and w E*/(p_0 a) in the runtime."""
ROOT = named("root")


def module_source(entry: Entry) -> str:
    """The module of one load."""
    load = entry.profile
    assert isinstance(load, Load)
    functions = PrivateFunctions(load)
    bodies(functions, {"w": entry})
    keywords = [name_of(symbol) for symbol in entry.parameters]
    body = [text.required(entry.parameters), f"return {evaluate('_displacement', ['r'], keywords, False)}"]
    document = text.document(entry, ["r"], keywords, "Frictionless half-space. Negative or NaN radii give NaN.")
    example = Example(load, {"w": entry}, "loads").lines("w")
    public = Function("displacement", ["r"], keywords, entry.quantity.summary, document, body, example=example)
    return text.module(load.title, load.subtitle, IMPORTS, [public], _private(functions))


def bodies(functions: PrivateFunctions, entries: Mapping[str, Entry]) -> None:
    """Add the displacement, inside and outside the loaded circle."""
    entry = entries["w"]
    assert isinstance(entry.profile, Load)
    rule = RULES.get(entry.profile.exponent)
    lines = [f"return p_0 / E_star * a * {rule}"] if rule else _by_regions(functions, entry)
    needs = tuple(name_of(symbol) for symbol in entry.parameters)
    functions.functions["displacement"] = Private("_displacement", ("r",), needs, tuple(lines))


def bodies_source(functions: PrivateFunctions, title: str) -> str:
    """A module of private functions alone: to be measured, not to be published."""
    return text.module(functions.profile.title, title, IMPORTS, [], _private(functions))


def _private(functions: PrivateFunctions) -> list[str]:
    return [private(own.name, own.fields, own.needs, own.lines) for own in functions.functions.values()]


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
