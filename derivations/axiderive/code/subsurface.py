"""Modules `axicontact.subsurface.<profile>`: stresses and displacements below a contact, from the slopes of its module.

What is written here is which radii the slope g' has on either side of a break, and the variable in which a rule takes
it (`runtime/subsurface/punches.py`).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import sympy as sp

from .. import notation as nt
from ..abel import masters
from ..abel.form import Order
from ..abel.reduce import parse
from ..entry import Entry, Quantity
from ..letters import name_of
from ..notation import C, a, coefficients, t
from ..physics import subsurface as below
from ..physics import tangential
from ..physics.complete import fixed_face
from ..physics.medium import HOMOGENEOUS
from ..physics.subsurface import PHYSICS
from ..physics.systems import System
from ..stable.forms import evaluation_form
from ..stable.signs import facts_of
from ..stable.slopes import singular_at_break, slope_form
from . import docstring
from .bodies.regimes import Regimes
from .function import Function, from_import
from .module import PLACE, Module
from .private import PrivateFunctions
from .text import python, written
from .writer import not_above, required

SYSTEM = System(PHYSICS, HOMOGENEOUS)
SHARED = (
    "Displacement",
    "Greatest",
    "SlidingStress",
    "Stress",
    "add",
    "hydrostatic",
    "principal",
    "tresca",
    "von_mises",
)
"""What the package gives besides its modules."""
FIELDS = {
    "r": "Distance from the axis [m]",
    "phi": "Angle from the direction of the traction on the half-space [rad]",
    "z": "Depth below the surface [m]; NaN above it",
}
RETURNS = {
    "Stress": "Named tuple of rr, tt, zz and rz [Pa], tension positive, z into the half-space.",
    "SlidingStress": "Named tuple of rr, tt, zz, rt, rz and tz [Pa], tension positive, z into the half-space.",
    "Displacement": "Named tuple of r and z [m], away from the axis and into the half-space.",
    "SurfaceStress": "Named tuple of rr and tt [Pa], tension positive.",
    "Greatest": "Named tuple of value [Pa], r and z [m], the point at which it is.",
    "Result": "Displacement away from the axis [m].",
}
NUMBERS = "S_m, D_m and W are those of flat punches of all radii t up to the contact, times g'(t), summed over t."


def _said(table: Mapping[str, sp.Expr]) -> tuple[str, ...]:
    return tuple(f"{left} = {written(right)}" for left, right in table.items())


STRESS, (SUNK, OUTWARD), FRICTION = map(_said, (below.STRESS, below.DISPLACEMENT, below.FRICTION))
INFINITE = "At the edge of a face, at a tip and at a kink the pressure, and with it zz, is infinite."
SHEARED = "At the edge of a face, at a tip and at a kink it is infinite, and with it rz and tz."
SEARCHED = "Infinite where the pressure is, on the surface. The point is known to about 1e-8 of the contact radius."
SLIDES = (
    f"The traction mu p does not change the pressure. {SHEARED} The whole stress is the `add` of this and of `stress`."
)
STICKS = f"The traction is mu times the difference of the pressures of radii a and c. {SHEARED} Within c it is finite."


@dataclass(frozen=True)
class Asked:
    """A public function: its arguments besides the geometry, and the call of the run time that gives it."""

    name: str
    fields: tuple[str, ...]
    material: tuple[sp.Symbol, ...]
    returns: str
    summary: str
    stated: tuple[str, ...]
    call: str
    """With {0} for the shape, the point and the contact, and {1} for the geometry."""
    note: str


STATIC, FRICTIONAL = (nt.E_star, nt.nu), (nt.E_star, nt.nu, nt.mu)
ASKED = (
    Asked("stress", ("r", "z"), STATIC, "Stress", "Stress below the contact.", STRESS,
          "stress_below({0}, E_star, nu, {1})", INFINITE),
    Asked("displacement", ("r", "z"), (nt.nu,), "Displacement", "Displacement below the contact.",
          (SUNK, OUTWARD), "displacement_below({0}, nu, {1})", ""),
    Asked("surface_stress", ("r",), STATIC, "SurfaceStress", "Stress of the surface.", STRESS[2:],
          "SurfaceStress(*stress_below({0}, E_star, nu, {1})[:2])", INFINITE),
    Asked("surface_displacement", ("r",), (nt.nu,), "Result", "Displacement of the surface away from the axis.",
          (OUTWARD,), "displacement_below({0}, nu, {1}).r", ""),
    Asked("sliding_stress", ("r", "phi", "z"), FRICTIONAL, "SlidingStress",
          "Stress that friction adds where the whole contact slides.", FRICTION,
          "sliding_below({0}, E_star, nu, mu, {1})", SLIDES),
    Asked("partial_slip_stress", ("r", "phi", "z"), FRICTIONAL, "SlidingStress",
          "Stress that friction adds where the contact sticks within the radius c.", FRICTION,
          "sliding_below({0}, E_star, nu, mu, c, {1})", STICKS),
    Asked("greatest_von_mises", (), STATIC, "Greatest", "The greatest stress of von Mises below the contact.", (),
          "greatest_below({0}, von_mises, E_star, nu, {1})", SEARCHED),
    Asked("greatest_shear", (), STATIC, "Greatest", "The greatest shear stress below the contact.", (),
          "greatest_below({0}, largest_shear, E_star, nu, {1})", SEARCHED),
)  # fmt: skip


def asked(*, grows: bool) -> tuple[Asked, ...]:
    """The public functions of a contact that grows, or of one with a fixed edge."""
    return tuple(one for one in ASKED if grows or "c, {1}" not in one.call)


def _quantities(*, grows: bool) -> dict[str, Quantity]:
    place, found = {symbol.name: symbol for symbol in (nt.r, below.ANGLE, nt.z)}, dict[str, Quantity]()
    for one in asked(grows=grows):
        held = [nt.c] if "c, {1}" in one.call else []
        fields = (*(place[name] for name in one.fields), nt.a if grows else nt.d, *held)
        words = f"{one.summary} {RETURNS[one.returns]}"
        found[one.name] = Quantity(one.name, one.name, one.summary, nt.S_0, fields, summary=words)
    return found | {name: Quantity(name, name, name, nt.S_0, ()) for name in SHARED if name.islower()}


GIVEN = {"grows": _quantities(grows=True), "fixed": _quantities(grows=False)}
"""The public functions by name, and behind them the measures of a stress, which have no fields."""


def module(entries: Mapping[str, Entry], plain: Mapping[str, Entry], known: Mapping[str, Sequence[str]]) -> Module:
    """The module of a profile, on that of the normal contact, whose entries are `plain` and whose functions take what
    `known` says.
    """
    return _Source(entries, plain, known).module()


def package(text: str) -> str:
    """The text of the package of these modules, with what it gives besides them."""
    shared = "\n".join(from_import(f"..{PLACE}.{PHYSICS.name}.stresses", SHARED))
    return text.replace("\n__all__", f"\n{shared}\n\n__all__", 1)


class _Source:
    """The module of one profile."""

    def __init__(
        self, entries: Mapping[str, Entry], plain: Mapping[str, Entry], known: Mapping[str, Sequence[str]]
    ) -> None:
        self.known, self.numbers, self.entries = known, entries, plain
        self.profile = next(iter(plain.values())).profile
        self.compact, self.summed = self.profile.compact, coefficients in self.profile.parameters
        self.geometry = [name_of(symbol) for symbol in self.profile.parameters]
        self.given = "a" if self.compact else "d"

    def module(self) -> Module:
        """The whole module."""
        shape = self.grown() if self.compact else self.fixed()
        public = [self.public(one) for one in asked(grows=self.compact)]
        title = f"{self.profile.title}: stresses below the surface"
        return Module(SYSTEM, self.profile.name, title, self.profile.subtitle, public, shape)

    def public(self, asked: Asked) -> Function:
        """A function of the interface."""
        held = ["c"] if "c, {1}" in asked.call else []
        free = ["d: ArrayLike | None = None"] if self.compact and not held else []
        shape = "partial(_shape, A=A)" if self.summed else "_shape"
        point = [*asked.fields, *(["0.0"] if asked.name.startswith("surface") else [])]
        measure = ["von_mises", "largest_shear"][asked.name == "greatest_shear"] if not asked.fields else ""
        first = ", ".join([shape, *([measure] if measure else point), self.given])
        passed = [f"{name}={name}" for name in self.geometry if not (self.summed and name == "A")]
        rest = ", ".join([*passed, *(["**held(d)"] if free else [])])
        call = asked.call.replace("{0}, von_mises", "{0}").replace("{0}, largest_shear", "{0}")
        symbols = [*self.profile.parameters, *asked.material]
        within = [line for own in tangential.PHYSICS.ordered if held for line in not_above(*own)]
        lines = [*self.checks(symbols), *within, f"return {call.format(first, rest)}".replace(", )", ")")]
        keywords = [name_of(symbol) for symbol in symbols]
        doc = self.document(asked, held, bool(free))
        return Function(asked.name, [*asked.fields, self.given, *held], [*keywords, *free], lines, doc, asked.returns)

    def checks(self, symbols: list[sp.Symbol]) -> list[str]:
        """The lines that check the parameters."""
        lines = ["A = require_coefficients(A)"] if self.summed else []
        plain = [symbol for symbol in symbols if symbol != coefficients]
        lines.append(required(plain, "normal._check" if self.profile.rules else "require"))
        return [*lines, *([f"require_reach(a, {self.profile.breaks[0]})"] if self.profile.truncated else [])]

    def document(self, asked: Asked, held: list[str], free: bool) -> str:
        """The docstring."""
        field = {"a": "Contact radius [m]", "d": "Indentation depth [m]", "c": "Radius of the stick zone [m]"} | FIELDS
        rows = [row for name in (*asked.fields, self.given, *held) for row in docstring.parameter(name, field[name])]
        meaning = docstring.words_of(self.profile)
        rows += docstring.parameters([], [*self.profile.parameters, *asked.material], meaning)
        if free:
            words = (
                "Depth [m] of a contact whose edge is under tension or pressed in, as with adhesion; g(a) without it"
            )
            rows += docstring.parameter("d", words, kind="array_like, optional")
        first, last = (self.numbers[suffix].key for suffix in ("S0", "W"))
        keys = f"Their formulas are {first} to S3, D0 to D3 and {last}."
        notes = f"Valid for {self.profile.validity}. {asked.note} {NUMBERS} {keys}".replace("  ", " ")
        stated = [f"    {line}" for line in asked.stated] or ["    the largest of all points with z >= 0"]
        returns = (asked.returns.replace("Result", docstring.NUMBERS), RETURNS[asked.returns])
        return docstring.document(asked.summary, stated, rows, returns, notes, self.profile.sources, [])

    def shaped(self, lines: list[str], pieces: list[str]) -> Function:
        """The function `_shape`."""
        own = [f"{symbol} = {python(expr)}" for symbol, expr in self.profile.abbreviations]
        joined = f"({', '.join(pieces)}{',' if len(pieces) == 1 else ''})"
        free = ["d: Array | None = None"] if self.compact else []
        lines = [*own, *lines, f"return radius, edge, {joined}"]
        doc = "Contact radius, what its edge is pressed in beyond g, and the slope g' piece by piece."
        returns = "tuple[Array, Array, tuple[Piece, ...]]"
        return Function("_shape", [self.given], [*self.geometry, *free], lines, doc, returns, summed=self.summed)

    def grown(self) -> list[Function]:
        """Of a contact that grows: nothing is pressed in beyond g unless a depth is given."""
        regimes = Regimes(self.entries, PrivateFunctions(self.profile))
        depth = f"normal._depth({', '.join(self.known['_depth'])})"
        lines = [f"depth = {depth}", "radius = np.where(np.isnan(depth), np.nan, a)"]
        lines.append("edge = 0.0 if d is None else d - depth")
        b = str(self.profile.breaks[0]) if self.profile.breaks else ""
        pieces = []
        if "_slope" in self.known:
            pieces.append("tip")
            lines.append(f"tip = {self.tip(regimes, f'np.minimum(a, {b})' if b else 'a')}")
        if "_slope_beyond" in self.known:
            pieces.append("beyond")
            jump = singular_at_break(regimes.slopes["beyond"][1])
            sharp = "" if jump == 0 else f", sharp={python(jump)} > 0.0"
            own = _tuple(self.known["_slope_beyond"][2:])
            lines.append(f"beyond = Piece(COSH, {b}, np.maximum(a, {b}), normal._slope_beyond, {own}, {b}, 2.0{sharp})")
        return [self.shaped(lines, pieces)]

    def tip(self, regimes: Regimes, high: str) -> str:
        """The slope from the axis on."""
        if self.summed:
            # sixteen nodes are exact for a power 31 of a slope and a kernel
            longest = "longest=np.inf if len(A) < 9 else 8.0 * a / len(A)"
            rates = "tuple(j * depth_over_height(j) * A_j for j, A_j in enumerate(A, 1))"
            return f"Piece(PLAIN, 0.0, {high}, polynomial, {rates}, {longest}, sharp=A[0] > 0.0)"
        form, (kind, length) = regimes.slopes["tip"][1], regimes.scale("tip")
        if not form.steps and form.value.is_polynomial(t):
            return _polynomial(high, form.value)
        own = self.known["_slope"][1:]
        start = f"0.0, {high}, normal._slope, {_tuple(own[1:] if own[:1] == ['root'] else own)}"
        if kind in ("tanh", "sinh"):
            return f"Piece({kind.upper()}, {start}, {length}, 2.0)"
        return _piece(start, high, form.value, dict(form.steps))

    def fixed(self) -> list[Function]:
        """Of a contact with a fixed edge: it is pressed in by what the depth is more than g."""
        face, coefficient = fixed_face(self.profile)
        least = self.known.get("_minimum_depth")
        if least is not None:
            radius = f"np.where(d >= normal._minimum_depth({', '.join(least)}) * (1.0 - 1e-15), a, np.nan)"
        else:
            radius = "np.where(d >= 0.0, a, np.nan)"
        if face[0].expr == 0:
            return [self.shaped([f"radius = {radius}", "edge = d"], [])]
        facts, functions = facts_of((a,)), PrivateFunctions(self.profile)
        depth = parse(face).depth(Order((a,))).expr()
        slope = slope_form(depth, facts).value.subs(C, coefficient)
        form = evaluation_form(sp.factor_terms(depth.subs(C, coefficient)), facts)
        lines, whole = functions.steps(form), python(form.value)
        if self.entries["F"].partial is not None:
            reach = python(self.entries["F"].cases[0].chain[0])
            lines.append(f"radius = np.where(d >= 0.0, np.minimum({reach}, a), np.nan)")
            lines.append(f"edge = np.maximum(d - {whole}, 0.0)")
        else:
            lines += [f"radius = {radius}", f"edge = d - ({whole})"]
        if slope.is_polynomial(t):
            return [self.shaped(lines, [_polynomial("radius", slope)])]
        names = sorted({str(symbol) for symbol in slope.free_symbols} - {"t"}, key=self.geometry.index)
        doc = "Rate g'(t) of the depth g(t) of the face."
        rate = Function("_slope", ["t"], names, [f"return {python(slope)}"], doc)
        start = f"0.0, radius, _slope, {_tuple(names)}"
        return [self.shaped(lines, [_piece(start, "radius", slope, {})]), rate]


def _polynomial(high: str, slope: sp.Expr) -> str:
    """The piece of a slope that is a polynomial of t."""
    rates = [python(c) if c else "0.0" for c in reversed(sp.Poly(slope, t).all_coeffs())]
    sharp = ", sharp=True" if slope.subs(t, 0) != 0 else ""
    return f"Piece(PLAIN, 0.0, {high}, polynomial, {_tuple(rates)}{sharp})"


def _piece(start: str, high: str, slope: sp.Expr, steps: Mapping[sp.Symbol, sp.Expr]) -> str:
    """The piece of a slope that is a power of t, or that has waves."""
    powers = [p.exp for p in slope.atoms(sp.Pow) if p.base == t and p.exp.free_symbols]
    if powers:
        n = python(powers[0])
        return f"Piece(EXP, {start}, {high}, 3.0 / ({n} + 3.0), {n}, {n} <= 1.0)"
    (argument,) = {call.args[-1].subs(steps) for call in slope.atoms(masters.Dawson, masters.StruveH)}
    # radians of waves in a panel: six leave 880 units of the last place next to an edge, four 65
    longest = python(sp.cancel(t / argument) * (4 if slope.has(masters.StruveH) else 1))
    return f"Piece(PLAIN, {start}, longest={longest})"


def _tuple(names: Sequence[str]) -> str:
    return f"({names[0]},)" if len(names) == 1 else f"({', '.join(names)})"
