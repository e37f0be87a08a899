"""Bodies of plane contacts with fixed edges, level or tilted.

Bodies of the functions of a plane complete contact: the strip over the whole width, and its concave face.

Bodies of the functions of the eccentric punch, before and after one edge has lifted off.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import sympy as sp

from ...entry import Case, Entry
from ...notation import P, a, e, x, x_zero
from ...physics.plane import PRESSURE
from ...stable.forms import EvaluationForm
from ...stable.opaque import named
from ...stable.variants import Variant
from ..bodies.complete import threshold
from ..function import Function
from ..private import PrivateFunctions
from ..text import python
from .compact import add_profile, form_of, lines_of, told_apart


@dataclass
class Complete:
    """The private functions behind the entries of one profile in complete contact."""

    entries: Mapping[str, Entry]
    functions: PrivateFunctions

    def __post_init__(self) -> None:
        self.concave = "Pmin" in self.entries

    def add_all(self) -> None:
        """Adds the private functions of profile, pressure, slope and depth, and of the least load if concave."""
        add_profile(self.functions)
        if self.concave:
            self._zero_distance()
            self._minimum_load()
        self._pressure()
        self._slope()
        self._depth()

    def _add(self, suffix: str, lines: list[str], value: str) -> Function:
        """NaN where the contact is not complete."""
        if self.concave and suffix in ("p", "s", "d"):
            least = self.functions["minimum_load"]
            # at the least load itself, which a caller computes, the contact is complete
            lines.append(f"complete = {least.call()} * (1.0 - 1e-15) <= P")
            lines.append(f"result = {value}")
            value = "np.where(complete, result, np.nan)"
        return self.functions.of_entry(self.entries[suffix], [*lines, f"return {value}"])

    def _parts(self, suffix: str) -> list[str]:
        """Lines that end with `value = ...`: what the load does, and what the face does.

        The second part of the slope is opposed to the first by a bounded factor at
        most, since P >= P_min; depth and pressure do change their signs.
        """
        lines: list[str] = []
        entry = self.entries[suffix]
        exprs, forms = parts(entry, self.concave, self.functions.variant(entry))
        for name, form in zip(exprs, forms, strict=True):
            if name == "face" and form.value.could_extract_minus_sign():
                form = type(form)(form.steps, -form.value, form.cancels)  # noqa: PLW2901
                lines_of(self.functions, "face", form, lines)
                lines.append("value = strip - face")
            else:
                lines_of(self.functions, name, form, lines)
                lines += ["value = strip + face"] if name == "face" else []
        return lines

    def _zero_distance(self) -> None:
        entry = self.entries["xz"]
        place = "a * ring_of_zero_pressure(n)" if entry.status == "root" else python(entry.cases[0].expr)
        self._add("xz", [], "0.0 * a" if place == "0" else place)

    def _minimum_load(self) -> None:
        place, form = threshold(self.functions, self.entries["Pmin"], x_zero)
        self._add("Pmin", [*self.functions.steps(form), *place], python(form.value))

    def _pressure(self) -> None:
        excess = excess_over_threshold(self.entries) if self.concave else None
        if excess is None:
            lines = self._parts("p")
        else:
            least = self.functions["minimum_load"]
            lines = ["root = np.sqrt((a - x) * (a + x))", f"face = {python(excess)}"]
            carried = named("carried")
            lines.append(f"carried = P - {least.call()} + face")
            lines.append(f"value = {python(PRESSURE * carried / named('root'))}")
        self._add("p", lines, "np.where((x <= a) & (P > 0.0), value, 0.0)")

    def _slope(self) -> None:
        lines = self._parts("s")
        inside = self.functions["profile_slope"]
        slope = f"-{inside.call()}" if self.concave else "0.0"
        # infinite at the edge itself
        lines.append("outside = np.where(P > 0.0, value, 0.0)")
        self._add("s", lines, f"np.where(x >= a, outside, {slope})")

    def _depth(self) -> None:
        self._add("d", self._parts("d"), "np.where(a <= L, value, np.nan)")


def parts(entry: Entry, concave: bool, variant: Variant) -> tuple[tuple[str, ...], tuple[EvaluationForm, ...]]:
    """What the load does and what the face does, by name; one value without a hollow face."""
    case = entry.cases[0]
    whole = sp.expand(case.expr)
    load = whole.coeff(P) * P
    exprs = {"strip": load, "face": whole - load} if concave else {"value": case.expr}
    return tuple(exprs), told_apart(tuple(form_of(Case(case.chain, expr), variant) for expr in exprs.values()))


def excess_over_threshold(entries: Mapping[str, Entry]) -> sp.Expr | None:
    """M(x) >= 0 in p = (P - P_min + M)/(pi root), where the face is algebraic."""
    weighted = sp.expand(sp.expand(entries["p"].cases[0].expr * sp.sqrt(a**2 - x**2) / PRESSURE))
    face = sp.factor(sp.expand(weighted - P + entries["Pmin"].cases[0].expr))
    return face if face.is_polynomial(x) else None


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
    functions.of_entry(entry, lines, "Pressure for x >= 0 under a load on either side.")


def _by_regimes(entry: Entry, functions: PrivateFunctions) -> None:
    touching, apart = (case.expr for case in entry.cases)
    lifted = sp.factor(_lifted(apart))
    lines = [f"{symbol} = {LEAN[symbol.name]}" for symbol in (SHORT, SIDE) if lifted.has(symbol)]
    lines.append(f"return np.where({_limit(entry)}, {python(touching)}, {python(lifted)})")
    functions.of_entry(entry, lines)
