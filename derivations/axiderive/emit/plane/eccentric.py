"""Bodies of the functions of the eccentric punch, before and after one edge has lifted off."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from ...entry import Entry
from ...notation import P, a, e, x
from ..code import python
from ..private import PrivateFunctions

SIDE, SHORT, NEAR, REACH, FAR, BEYOND, ALONG, END = (
    sp.Symbol(name, positive=True) for name in ("side", "short", "near", "reach", "far", "beyond", "along", "end")
)
LEAN = {"short": "a - np.abs(e)", "side": "np.copysign(1.0, e)"}
"""Distance of the load from its edge, and the side it leans to."""


def add_all(entries: Mapping[str, Entry], functions: PrivateFunctions) -> None:
    """`pressure`, `tilt` and `contact_width`; both regimes by exact distances from the edges."""
    _pressure(entries["p"], functions)
    for suffix in ("phi", "cw"):
        _by_regimes(entries[suffix], functions)


def _limit(entry: Entry) -> str:
    """The condition under which both edges touch."""
    low, high = entry.cases[0].chain
    return f"{python(low)} < {python(high)}"


def _lifted(expr: sp.Expr) -> sp.Expr:
    """In the distances of the point and of the load from the edge that the load leans to."""
    return _in_distances(expr, SIDE * (a - NEAR), a - SHORT)


def _in_distances(expr: sp.Expr, place: sp.Expr, eccentricity: sp.Expr) -> sp.Expr:
    expr = expr.subs(x, place).subs(sp.Abs(e), eccentricity).subs(sp.sign(e), SIDE)
    return expr.replace(lambda part: part.is_Add, lambda part: sp.expand(sp.expand(part).subs(SIDE**2, 1)))


def _pressure(entry: Entry, functions: PrivateFunctions) -> None:
    """The punch at x >= 0: the numerator linear in x between its values in the middle and at the edge.

    Both values are positive as long as both edges touch, so that nothing cancels.
    After lift-off a point is `reach` away from the end of the contact.  Next to that end both of the places that it
    is the difference of are exact: counted from the lifted edge up to half way to the middle, from the middle beyond.
    """
    touching, apart = (case.expr for case in entry.cases)
    numerator = sp.expand(touching * sp.pi * a**2 * sp.sqrt(a**2 - x**2) / P)
    middle, edge = numerator.subs(x, 0), numerator.subs(x, a)
    if sp.expand(numerator - middle - x * (edge - middle) / a) != 0:
        message = f"{entry.key}: the numerator {numerator} is not linear in x"
        raise ValueError(message)
    share = sp.factor(edge / a) * x + sp.factor(middle / a) * (a - x)
    (extent,) = apart.atoms(sp.Max)
    reach = sp.Add(*extent.args)
    from_lifted = _in_distances(reach, SIDE * (FAR - a), (a + BEYOND) / 2)
    from_middle = _in_distances(reach, SIDE * ALONG, (3 * a + END) / 4)
    pressed = _lifted(apart.subs(extent, REACH))
    lines = [
        "root = np.sqrt((a - x) * (a + x))",
        f"touching = P * ({python(share)}) / (np.pi * a**2 * root)",
        f"short, side = {LEAN['short']}, {LEAN['side']}",
        "beyond, along = 2 * np.abs(e) - a, side * x",
        "near, far, end = a - along, a + along, 2 * beyond - a",
        f"reach = np.maximum(np.where(end < -a / 2, {python(from_lifted)}, {python(from_middle)}), 0.0)",
        f"apart = {python(pressed)}",
        f"pressed = np.where({_limit(entry)}, touching, apart)",
        "return np.where((x <= a) & (P > 0.0), pressed, 0.0)",
    ]
    functions.add("pressure", ("x", "P"), lines, {"a", "e"}, "Pressure for x >= 0 under a load on either side.")


def _by_regimes(entry: Entry, functions: PrivateFunctions) -> None:
    touching, apart = (case.expr for case in entry.cases)
    lifted = sp.factor(_lifted(apart))
    needs = {str(symbol) for case in entry.cases for symbol in case.expr.free_symbols}
    lines = [f"{symbol} = {LEAN[symbol.name]}" for symbol in (SHORT, SIDE) if lifted.has(symbol)]
    lines.append(f"return np.where({_limit(entry)}, {python(touching)}, {python(lifted)})")
    fields = tuple(str(argument) for argument in entry.quantity.arguments)
    functions.add(entry.quantity.function, fields, lines, needs | {"a", "e"})
