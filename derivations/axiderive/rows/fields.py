"""The numbers below the surface in print: of the slopes g' = t**(n-1), and what every profile is made of.

The entries hold them in oblate coordinates, written out.  Here the powers of r/q have names, so that one row says a
number of all orders m, and N_n stands for any of the nine numbers of the slope t**(n-1), N_0 for one of a flat punch
that is pressed in by one.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache

import sympy as sp

from .. import notation as nt
from ..abel.field_moments import CENTRE, ONE, Complex, Moments
from ..abel.form import Form, Order
from ..abel.masters import Eta, Xi
from ..abel.reduce import parse
from ..notation import C, a, d, j, r, z
from ..physics import complete
from ..print.box import bracket
from ..print.formula import Printer
from ..profiles.profile import Profile
from .blocks import JOINT, JOINT_WIDTH
from .row import WIDEST, Region, broken

NAMES: dict[sp.Symbol, str] = {}
"""Of the symbols of this section, as they are printed."""


def _named(name: str, tex: str = "") -> sp.Symbol:
    symbol = sp.Symbol(f"~{name}", positive=True)  # behind the letters of the notation in a product
    NAMES[symbol] = tex or name
    return symbol


ORDER = j
NAMES[ORDER] = "m"
RADIUS, SIZE = _named("varrho", r"\varrho"), _named("delta", r"\delta")
XI, ETA = _named("xi", r"\xi"), _named("eta", r"\eta")
OMEGA, GROWTH = _named("omega", r"\omega"), _named("Lambda", r"\Lambda")
CENTRAL, EDGE = _named("q"), _named("chi", r"\chi")


COSINE, SINE, REAL, IMAGINARY, LOST = "csxyv"
"""The letters with an index: parts of (r/q)**m and of X_m, and what that loses with the depth."""


@cache
def turned(letter: str, m: sp.Expr) -> sp.Symbol:
    """c_m, s_m, x_m, y_m or v_m."""
    return _named(f"{letter}_{m}", f"{letter}_{{{str(m).replace(' ', '').replace('j', 'm')}}}")


def _half(total: sp.Expr) -> sp.Expr:
    """Of a sum, which is not taken apart."""
    return sp.Mul(sp.S.Half, total, evaluate=False)


_x, _y = turned(REAL, ORDER), turned(IMAGINARY, ORDER)
_deep, _wide = z + ORDER * XI, a + ORDER * ETA
SHORTHANDS: tuple[tuple[tuple[sp.Symbol, sp.Expr], ...], ...] = (
    ((RADIUS, CENTRE), (SIZE, sp.sqrt(((r - a) ** 2 + z**2) * ((r + a) ** 2 + z**2)))),
    ((XI, sp.sqrt(_half(SIZE + RADIUS**2 - a**2))), (ETA, sp.sqrt(_half(SIZE - RADIUS**2 + a**2)))),
    ((OMEGA, sp.atan(a / XI)), (CENTRAL, r / (z + RADIUS)), (EDGE, sp.sqrt((a - ETA) / (a + ETA)))),
    ((GROWTH, sp.log((a + ETA) * sp.sqrt(XI**2 + a**2) / (a * (z + RADIUS)))),),
    (
        (turned(COSINE, ORDER), EDGE**ORDER * sp.cos(ORDER * OMEGA)),
        (turned(SINE, ORDER), EDGE**ORDER * sp.sin(ORDER * OMEGA)),
    ),
    (
        (_x, (XI * turned(COSINE, ORDER) - ETA * turned(SINE, ORDER)) / SIZE),
        (_y, (ETA * turned(COSINE, ORDER) + XI * turned(SINE, ORDER)) / SIZE),
    ),
    (
        (
            turned(LOST, ORDER),
            (2 * a * z * (_deep * _x + _wide * _y) + (RADIUS**2 - a**2) * (_deep * _y - _wide * _x)) / SIZE**2,
        ),
    ),
)
"""The letters of the rows by lines, each from those before it: (r/q)**m = c_m - i s_m, X_m = x_m - i y_m."""


def _turned(m: sp.Expr) -> Complex:
    """(r/q)**m at the edge, by name."""
    return (
        Complex(Form.of(turned(COSINE, m)), Form.of(turned(SINE, m), sp.S.NegativeOne)) if m else Complex(ONE, Form())
    )


class _Named(Moments):
    """The moments in names, m a number or any above it that the recurrence needs."""

    def _lowest(self, m: sp.Expr) -> Complex:
        if not m:
            return Complex(Form.of(OMEGA), Form.of(GROWTH, sp.S.NegativeOne))
        return (_turned(m) + Complex(Form.of(CENTRAL**m, sp.S.NegativeOne), Form())).times_i(1 / sp.sympify(m))


_moment = _Named()


def _pressed(power: int, m: sp.Expr) -> Form:
    """S_m of the slope t**power, of a flat punch for power -1."""
    if power < 0:
        return Form.of(turned(IMAGINARY, m))
    found: Form = _moment(power, m).imaginary * sp.S.NegativeOne
    return found


def _deeper(power: int, m: sp.Expr) -> Form:
    """D_m of the slope t**power, of a flat punch for power -1."""
    if power < 0:
        return Form.of(turned(LOST, m), z)
    first = Form.of(CENTRAL**m / RADIUS) if not power else _moment(power - 1, m).real * sp.Integer(power)
    found: Form = (first + Form.of(turned(REAL, m), -(a**power))) * z
    return found


def _sunk(power: int) -> Form:
    """W of the slope t**power, of a flat punch for power -1."""
    if power < 0:
        return Form.of(OMEGA)
    rest = _moment(power + 1, 0).real * sp.S.NegativeOne
    found: Form = (Form.of(OMEGA, a ** (power + 1)) + rest) * sp.Rational(1, power + 1)
    return found


@dataclass(frozen=True)
class FieldRow:
    """A number of one order or of several, and from which order on it holds."""

    letter: str
    orders: tuple[int, ...]
    region: Region

    @property
    def suffixes(self) -> tuple[str, ...]:
        """The ends of the keys of the numbers that it gives."""
        return tuple(f"{self.letter}{m}" for m in self.orders) or (self.letter,)

    @property
    def left(self) -> str:
        """The number as it is printed."""
        return _left(self.letter, self.orders)


def _left(letter: str, orders: tuple[int, ...]) -> str:
    return f"{letter}_{{{'m' if len(orders) > 1 else orders[0]}}}" if orders else letter


ALL = (0, 1, 2, 3)


@cache
def numbers(n: int) -> tuple[FieldRow, ...]:
    """The nine numbers of the slope t**(n-1), those of a flat punch for n = 0."""
    found = []
    for letter, made, shift in (("S", _pressed, 0), ("D", _deeper, 1)):
        # the recurrence takes the order before, with every power: what it takes of the lowest is a row by itself
        start = 0 if n == 0 else n - shift if n < 3 else len(ALL)
        for orders in [*((m,) for m in ALL[:start]), *([ALL[start:]] if start < len(ALL) else [])]:
            found.append(_row(letter, orders, made(n - 1, ORDER if len(orders) > 1 else sp.Integer(orders[0]))))
    return (*found, _row(nt.W.name, (), _sunk(n - 1)))


def _row(letter: str, orders: tuple[int, ...], number: Form) -> FieldRow:
    plain = number.expr().subs({Xi(r, z, a): XI, Eta(r, z, a): ETA, CENTRE: RADIUS})
    lines = broken(f"{_left(letter, orders)}=", plain, Printer((), NAMES))
    where = rf"m\ge {orders[0]}" if len(orders) > 1 and orders[0] else ""
    return FieldRow(letter, orders, Region(where, tuple(lines)))


TITLES = (
    "Distances", "Oblate coordinates", "Angle and ratios", "Logarithm", "Powers of the ratio", "Punch, at its depth",
    "Punch, below it",
)  # fmt: skip
"""Of the lines of letters."""


def shorthands() -> list[tuple[str, str]]:
    """The letters with their definitions, by titled lines."""
    printer = Printer((), NAMES)
    return [
        (title, JOINT.join(f"{printer(symbol)}={printer(expr)}" for symbol, expr in line))
        for title, line in zip(TITLES, SHORTHANDS, strict=True)
    ]


def lines(n: int) -> list[tuple[FieldRow, ...]]:
    """The numbers of a slope, as many side by side as a line holds."""
    found: list[tuple[FieldRow, ...]] = []
    for one in numbers(n):
        beside = (*found[-1], one) if found else (one,)
        flat = all(len(own.region.lines) == 1 for own in beside)
        if found and flat and sum(own.region.width + JOINT_WIDTH for own in beside) <= WIDEST:
            found[-1] = beside
        else:
            found.append((one,))
    return found


def beside(line: tuple[FieldRow, ...]) -> str:
    """The formulas of a line, side by side."""
    return JOINT.join(one.region.tex for one in line)


@cache
def parts(profile: Profile) -> dict[int, sp.Expr]:
    """How much a profile has of every slope t**(n-1), and of a flat punch; empty if its slope is no polynomial."""
    face, coefficient = (profile.pieces, sp.S.Zero) if profile.compact else complete.fixed_face(profile)
    if len(face) > 1 or not face[0].expr.is_polynomial(r) or face[0].expr.has(sp.Sum):
        return {}
    depth = parse(face).depth(Order((a,))).expr() if face[0].expr != 0 else sp.S.Zero
    slopes = {power + 1: c for ((power,), c) in reversed(sp.Poly(sp.diff(depth, a), a).terms()) if c != 0}
    own = slopes if profile.compact else {0: d - depth, **slopes}
    return {n: c.subs(C, coefficient) for n, c in own.items()}


def touches_later(profile: Profile) -> bool:
    """Whether its edge comes into contact at some depth only."""
    return profile.complete and len(parts(profile)) > 1 and complete.fixed_face(profile)[1] == 0


def total(own: Mapping[int, sp.Expr]) -> str:
    """Any of nine numbers as a sum of those of a flat punch and of slopes, with the shares in front."""
    printer, found = Printer(), ""
    for n, share in own.items():
        text = bracket(printer(share)) if share.is_Add else printer(share)
        found += ("" if text.startswith("-") or not found else "+") + rf"{text} \, N_{{{n}}}"
    return f"N={found}"


EVERY = r"N=\int_{0}^{a} g'(t) \, N_{0}(t)\,\mathrm{d}t+\bigl[d-g(a)\bigr] \, N_{0}(a)"
"""Any number of any profile, by that of a flat punch with a radius."""
SLOPES = {0: "flat punch", 1: "$g'=1$", 2: "$g'=t$", 4: "$g'=t^{3}$", 6: "$g'=t^{5}$"}
"""The slopes that profiles of the catalogue are made of, by the power n of the profile."""
PRINTED = (0, 1, 2, 4)
"""Those of the book; the numbers of the sextic would take a page, and stand on the web."""
MADE_OF = (
    "$N$ is any of the nine; $N_{n}$ that of the slope $g'=t^{n-1}$, and $N_{0}$ that of a flat punch pressed in by one"
)
"""What the letters of a sum say."""
