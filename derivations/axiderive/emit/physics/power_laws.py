"""Pull-off and stable branch of a power law: one universal curve for all of them."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from ...entry import Entry
from ...notation import n
from ...stable.forms import evaluation_form
from ...stable.signs import facts_of
from ..code import python
from .text import NormalModule, private

ENTRY = {"force": "ac", "depth": "am"}


def power_law_functions(module: NormalModule, entries: Mapping[str, Entry], power: sp.Expr) -> list[str]:
    """The private functions of pull-off and of the stable radii."""
    needs = [*module.geometry, "E_star", "dgamma"]
    radius = private("_pull_off_radius", [], [*needs, "control"], _radius(entries, power))
    own = [_pair(module, needs, "depth", "d", power, "0.5"), _pair(module, needs, "force", "F", power + 1, "1.5")]
    return [radius, *(function for pair in own for function in pair)]


def _radius(entries: Mapping[str, Entry], power: sp.Expr) -> list[str]:
    forms = {control: evaluation_form(entries[own].cases[0].expr, facts_of(())) for control, own in ENTRY.items()}
    shared = [step for step in forms["force"].steps if step in forms["depth"].steps]
    lines = [f"{name} = {python(expr)}" for name, expr in shared]
    for head, form in zip(('if control == "force":', "else:"), forms.values(), strict=True):
        own = [f"    {name} = {python(expr)}" for name, expr in form.steps if (name, expr) not in shared]
        lines += [head, *own, f"    radius = {python(form.value)}"]
    value = "np.where(dgamma > 0.0, radius, 0.0)"
    return [*lines, f"return np.where(n > 0.5, {value}, np.nan)" if power == n else f"return {value}"]


def _pair(module: NormalModule, needs: list[str], quantity: str, field: str, order: sp.Expr, q: str) -> list[str]:
    """The load at pull-off and the inverse of a load A a**order - B a**q."""
    passed = ", ".join(needs)
    lost = number(2 * order) if order.is_Integer else f"2 * {f'({python(order)})' if order.is_Add else order}"
    load = private(
        f"_pull_off_{quantity}",
        ["a"],
        [*needs, "control"],
        [f"return {module.call(f'_{quantity}', 'a')} * (1.0 - {lost} / XI[control])"],
        "With the retraction 2 a g'(a)/xi of pull-off, free of cancellation.",
    )
    plain = module.call(f"_radius_from_{quantity}", f"np.maximum({field}, 0.0)")
    inverse = private(
        f"_radius_from_{quantity}",
        [field],
        needs,
        [
            f'a_c = _pull_off_radius({passed}, control="{quantity}")',
            f'least = _pull_off_{quantity}(a_c, {passed}, control="{quantity}")',
            f"plain = {plain}",
            f"return power_law_radius({field}, a_c, least, {number(order)}, {q}, plain)",
        ],
    )
    return [load, inverse]


def number(expr: sp.Expr) -> str:
    """An exponent, as a float where it is an integer."""
    return repr(float(expr)) if expr.is_Integer else python(expr)
