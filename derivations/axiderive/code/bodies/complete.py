"""Bodies of the functions of a complete contact: a rigid punch sunk by the excess d - g(a), and its face."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import sympy as sp

from ...entry import Entry
from ...notation import a, d, r, r_zero
from ...physics.medium import HOMOGENEOUS
from ...stable.forms import EvaluationForm
from ...stable.signs import cancels, facts_of
from ..function import Function
from ..private import PrivateFunctions
from ..text import python
from .compact import beside

ZETA = sp.Symbol("zeta", positive=True)
"""1 - (r_0/a)**2 with r_0 the radius where the pressure vanishes first."""
COMPLETE_FROM = "complete = {least} * (1.0 - 1e-15) <= {field}"


@dataclass
class Complete:
    """The private functions behind the entries of one profile in complete contact."""

    entries: Mapping[str, Entry]
    functions: PrivateFunctions

    def __post_init__(self) -> None:
        self.profile = self.entries["F"].profile
        self.partial = self.entries["F"].partial is not None
        self.concave = "dmin" in self.entries

    def add_all(self) -> None:
        """Adds the private functions of all its entries; those of a concave face give NaN below their thresholds."""
        if self.concave:
            self._thresholds()
        if self.partial:
            self._capped()
            return
        self._closed("F")
        self._closed("dF")
        self._closed("k")
        self._pressure()
        self._displacement()

    @property
    def reach(self) -> sp.Expr:
        """The radius of the contact of the unbounded face, up to which that is one of a fixed edge."""
        return self.entries["F"].cases[0].chain[0]

    @property
    def least_depth(self) -> sp.Expr:
        """The depth from which a concave face touches everywhere."""
        return self.entries["dmin"].cases[0].expr

    def add(self, suffix: str, value: str, lines: list[str]) -> Function:
        """Adds and returns the private function of a quantity: its lines, and the value it returns."""
        return self.functions.of_entry(self.entries[suffix], [*lines, f"return {value}"])

    def _closed(self, suffix: str) -> Function:
        entry = self.entries[suffix]
        form = self.functions.form(entry, entry.cases[-1].expr, facts_of(()))
        lines, value = self.functions.steps(form), python(form.value)
        if entry.quantity.arguments:
            value = self.from_threshold(lines, value, entry.quantity.arguments[-1])
        return self.add(suffix, value, lines)

    def from_threshold(self, lines: list[str], value: str, given: sp.Symbol) -> str:
        """The value, as NaN where the depth or force that is given leaves the contact incomplete."""
        if not self.concave:
            return value
        known = (entry.quantity for entry in self.entries.values() if entry.quantity.threshold)
        least = next(quantity for quantity in known if quantity.symbol == given)
        threshold = self.functions[least.function]
        lines.append(COMPLETE_FROM.format(field=given, least=threshold.call()))
        lines.append(f"result = {value}")
        return "np.where(complete, result, np.nan)"

    def _thresholds(self) -> None:
        ring = self.entries["rz"]
        place = "a * ring_of_zero_pressure(n)" if ring.status == "root" else python(ring.cases[0].expr)
        self.add("rz", "0.0" if place == "0" else place, [])
        for suffix in ("dmin", "Fmin"):
            lines, form = threshold(self.functions, self.entries[suffix], r_zero)
            lines += self.functions.steps(form)
            top, bottom = sp.fraction(form.value)
            if bottom.has(ZETA):
                lines.append(f"drop = {python(bottom)}")
                self.add(suffix, f"{python(top)} / drop", lines)
            else:
                self.add(suffix, python(form.value), lines)

    def _pressure(self) -> None:
        """The edge term and the face; for an algebraic face as (d - d_min) plus a square over the root."""
        expr = self.entries["p"].cases[0].expr
        form = self.functions.form(self.entries["p"], expr, facts_of((r, a)))
        lines = self.functions.steps(form)
        value = self.functions.value_lines(form.value, lines)
        excess = excess_over_threshold(self.entries) if self.concave else None
        if excess is not None:
            least = self.functions["minimum_depth"]
            scale = HOMOGENEOUS.pressure_scale
            lines = ["root = np.sqrt((a - r) * (a + r))"]
            lines.append(f"face = {python(excess)}")
            value = f"{python(scale)} * (d - {least.call()} + face) / root"
        value = f"np.where((r <= a) & (d > 0.0), {value}, 0.0)"
        self.add("p", self.from_threshold(lines, value, d), lines)

    def _displacement(self) -> None:
        expr = self.entries["w"].cases[0].expr
        form = self.functions.form(self.entries["w"], expr, facts_of((a, r)))
        lines, value = self.functions.steps(form), python(form.value)
        if form.cancels:
            sunk, n = sunk_power(self.entries)
            lines = ["angle = np.arctan2(a, np.sqrt((r - a) * (r + a)))"]
            scale = python(HOMOGENEOUS.displacement_scale)
            value = f"{scale} * (d * angle + {python(sunk)} * power_punches(r, a, {python(n)}))"
        profile = self.functions["profile"]
        lines += [f"outside = {value}", f"inside = d - {profile.call()}"]
        value = "np.where(r > a, outside, inside)"
        self.add("w", self.from_threshold(lines, value, d), lines)

    def _capped(self) -> None:
        """Two branches: contact radius `rho` below the edge, or the whole face with the excess of the depth."""
        entries, profile = self.entries, self.functions["profile"]
        rho, edge = entries["F"].cases[0].chain
        compact = {suffix: part for suffix in ("F", "p", "k") if (part := entries[suffix].partial) is not None}
        stiffness = entries["k"].cases[-1].expr
        whole = entries["F"].cases[-1].expr
        depth = sp.expand(d - (whole - compact["F"].cases[0].expr) / stiffness)
        self.square = tuple(str(factor) for factor in sp.Mul.make_args(sp.expand(rho**2)))
        start = [f"excess = {self._beyond('a')} / {self.square[0]}", f"rho = np.minimum({python(rho)}, a)"]
        inner = {key: compact[key].cases[0].expr.subs(a, sp.Symbol("rho", positive=True)) for key in ("F", "p", "k")}
        punch = "np.maximum(excess, 0.0)"
        pressed = sp.cancel(inner["F"] / depth.subs(a, sp.Symbol("rho", positive=True)))
        self.add("F", f"{python(pressed)} * {_sunk(depth)} + {python(stiffness)} * {punch}", start)
        self.functions.add(entries["k"].quantity.function, ("d",), [*start[1:], f"return {python(inner['k'])}"])
        self._capped_fields(start, punch, depth, inner["p"], profile)
        cases = entries["dF"].cases
        limit = cases[0].chain[1]
        texts = [python(self.functions.form(entries["dF"], case.expr, facts_of(())).value) for case in cases]
        lines = [f"edge = {python(limit)}", f"below = {texts[0]}", f"above = {texts[1]}"]
        self.add("dF", "np.where(edge > F, below, above)", lines)

    def _beyond(self, radius: str) -> str:
        """rho**2 - radius**2, where rho**2 is a product of two inputs."""
        return f"difference_of_products({', '.join(self.square)}, {radius}, {radius})"

    def _capped_fields(self, start: list[str], punch: str, depth: sp.Expr, inner: sp.Expr, profile: Function) -> None:
        rho, root = (sp.Symbol(name, positive=True) for name in ("rho", "root"))
        face = inner.subs(sp.sqrt(rho**2 - r**2), root)
        pressure = python(HOMOGENEOUS.pressure_scale)
        lines = [
            start[0],
            f"square = np.where(excess > 0.0, (a - r) * (a + r), {self._beyond('r')})",
            "root = np.sqrt(np.maximum(square, 0.0))",
            f"face = {python(face)}",
            f"edge = np.where(excess > 0.0, {pressure} * excess / np.sqrt((a - r) * (a + r)), 0.0)",
        ]
        self.add("p", "np.where(r <= a, face + edge, 0.0)", lines)
        scale = python(HOMOGENEOUS.displacement_scale)
        lines = [
            *start,
            f"face = {_sunk(depth)} * {beside('rho', sp.degree(depth, a))}",
            "angle = np.arctan2(a, np.sqrt((r - a) * (r + a)))",
            f"edge = np.where(excess > 0.0, {punch} * angle, 0.0)",
        ]
        value = f"np.where(r > rho, {scale} * (face + edge), d - {profile.call()})"
        self.add("w", value, lines)


def threshold(functions: PrivateFunctions, entry: Entry, place: sp.Symbol) -> tuple[list[str], EvaluationForm]:
    """The form of a least load or depth, and the line that says where the pressure vanishes first, if it asks."""
    expr = entry.cases[0].expr
    if expr.has(place):
        # in what is left of a**2 outside that place: next to the edge the difference of the squares is lost
        expr = sp.factor(sp.expand(expr.subs(place, a * sp.sqrt(1 - ZETA))))
    first = [f"{ZETA} = outside_zero_pressure(n)"] if expr.has(ZETA) else []
    return first, functions.form(entry, expr, facts_of(()))


def _sunk(depth: sp.Expr) -> str:
    """The depth up to that of the edge: a power of the radius below it would take up its roundings as often."""
    return f"np.minimum(d, {python(depth)})"


def _is_square(face: sp.Expr) -> bool:
    """Whether r occurs only in a squared factor."""
    return all(not factor.has(r) or (factor.is_Pow and factor.exp == 2) for factor in sp.Mul.make_args(sp.numer(face)))


def excess_over_threshold(entries: Mapping[str, Entry]) -> sp.Expr | None:
    """M(r) >= 0 in p = E*/pi (d - d_min + M)/root, None where it has subtractions of its own."""
    root = sp.sqrt(a**2 - r**2)
    bracket = sp.expand(sp.expand(entries["p"].cases[0].expr * root / HOMOGENEOUS.pressure_scale))
    face = sp.factor(sp.expand(bracket - d + entries["dmin"].cases[0].expr))
    plain = face.is_polynomial(r) and not cancels(sp.numer(face), facts_of((r, a)))
    return face if plain or _is_square(face) else None


def sunk_power(entries: Mapping[str, Entry]) -> tuple[sp.Expr, sp.Expr]:
    """C and n in w = 2/pi (d angle + C/a**n times the integral of t**n/sqrt(r**2 - t**2))."""
    n = entries["F"].profile.pieces[0].expr.as_independent(r, as_Add=False)[1].as_base_exp()[1]
    excess = sp.expand(entries["F"].cases[0].expr / HOMOGENEOUS.stiffness()) - d
    return sp.factor(excess * (n + 1)), n
