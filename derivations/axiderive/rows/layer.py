"""Contact with a layer in print: its equation, what holds on a thick layer, and series for a paraboloid by numbers.

The force at a depth is a series in chi, the square root of R d over the thickness.  Its coefficients follow from the
contact that is small against the thickness; published ones are compared with them and with the solution itself.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from functools import cache

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..oracle.half_space import HalfSpace
from ..oracle.layer import Layer, layer
from ..physics import DEPTH, FORCE, normal
from ..physics import layer as stated
from ..print.formula import Printer
from ..profiles import load
from .row import Region

Line = tuple[tuple[str, str, str], ...]
"""Label, small words and formula of one row or two."""
CHI, DEEP = sp.symbols("chi e", positive=True)
"""The square root of R d, and the contact radius, over the thickness."""
ENDLESS, ALONE, STIFF, FIRST, SECOND = sp.symbols("endless alone stiff first second", positive=True)
NAMES = {
    CHI: r"\chi", ENDLESS: r"\infty", ALONE: r"F_{\mathrm N}(a)", STIFF: r"(3-4 \nu)",
    FIRST: r"\alpha", SECOND: r"\beta",
}  # fmt: skip
"""What only print has: chi, infinity, the force of the half-space, 3 - 4 nu, and m_0 and m_2 over pi."""
ORDER = 4
"""Of the highest power of chi that a contact without the fifth power of e decides."""
LETTERS = frozenset(("thickness", "q", "K", "sinking", "m_0", "m_2"))
"""What the notation has to tell for these rows."""


def _printed(expr: sp.Expr) -> str:
    own = expr.replace(stated.KERNEL, lambda *_: nt.describe("K").symbol)
    return Printer(names=NAMES)(own.xreplace({sp.oo: ENDLESS, FORCE(nt.a): ALONE}))


def _share(base: str) -> str:
    """L with the powers of its hyperbolic functions collected."""
    waves = (sp.sinh(nt.u), sp.cosh(nt.u), nt.u)
    parts = (sp.Poly(part, *waves).as_dict() for part in sp.fraction(stated.sinking(nt.u, base)))
    above, below = (
        sp.Add(*(_of_ratio(c) * sp.Mul(*map(sp.Pow, waves, powers)) for powers, c in part.items())) for part in parts
    )
    return rf"\frac{{{_printed(above)}}}{{{_printed(below)}}}"


def _of_ratio(c: sp.Expr) -> sp.Expr:
    """3 - 4 nu by a letter, and a power of 1 - nu where it is one."""
    own = sp.Poly(c, nt.nu)
    power = own.LC() * (1 - nt.nu) ** own.degree()
    return power if sp.expand(power - c) == 0 else sp.cancel(c / (3 - 4 * nt.nu)) * STIFF


def statements() -> dict[str, sp.Expr]:
    """What the rows say, by the left sides as they are read."""
    carried, pressure, _ = stated.definitions(load("flat_punch")).values()
    force, depth = stated.expanded().values()
    return {
        "q(t)": stated.EQUATION,
        "K": stated.SUMMED,
        **{f"L of {base}": stated.sinking(nt.u, base) for base in stated.BASES},
        "F_N": carried,
        "p(r)": pressure,
        **{symbol.name: moment for symbol, moment in stated.MOMENTS.items()},
        "d of first order": depth.subs(stated.m_2, 0).doit(),
        "F_N of second order": force,
        "d of second order": depth,
        "F_N of a paraboloid": _alone() * sum(c * CHI**i for i, c in enumerate(coefficients())),
    }


def _alone() -> sp.Expr:
    """The force of a paraboloid at a depth of the half-space."""
    return _half_space("force_from_depth")


@cache
def _half_space(function: str) -> sp.Expr:
    """What a function says of a paraboloid on the half-space."""
    entries = normal.derive(load("paraboloid")).values()
    return next(entry.cases[0].expr for entry in entries if entry.quantity.function == function)


LEFT = {"F_N": r"F_{\mathrm N}", "m_0": "m_{0}", "m_2": "m_{2}"}


@cache
def texts() -> dict[str, str]:
    """The same as LaTeX."""
    right = {name: _printed(expr) for name, expr in statements().items() if " of " not in name or "order" in name}
    right |= {f"L of {base}": _share(base) for base in stated.BASES}
    found = {name: f"{LEFT.get(left := name.partition(' ')[0], left)}={tex}" for name, tex in right.items()}
    return found | {"F_N of a paraboloid": _series()}


def _series() -> str:
    """The force in powers of chi, with the letters behind it."""
    text = "1"
    for i, own in enumerate(coefficients()[1:], 1):
        c = sp.expand(own.subs({stated.m_0: sp.pi * FIRST, stated.m_2: sp.pi * SECOND}))
        text += "+" + (rf"\Bigl({_printed(c)}\Bigr)" if c.is_Add else _printed(c)) + rf" {_printed(CHI**i)}"
    letters = {CHI: sp.sqrt(nt.R * nt.d) / stated.thickness, FIRST: stated.m_0 / sp.pi, SECOND: stated.m_2 / sp.pi}
    behind = r",\quad ".join(f"{NAMES[name]}={_printed(expr)}" for name, expr in letters.items())
    return Region("", (rf"{LEFT['F_N']}={_printed(_alone())} \,\Bigl[{text}\Bigr],", rf"\qquad {behind}")).tex


def sections() -> list[tuple[str, str, list[Line]]]:
    """Title, note and lines of the page."""
    tex = texts()
    bonded, sliding = (tex[f"L of {base}"] for base in stated.BASES)
    return [
        ("The equation", "of the springs below the surface, which feel each other", [
            (("Spring", "of a radius", tex["q(t)"]), ("Force", "", tex["F_N"])),
            (("Kernel", "", tex["K"]),),
            (("Waves", "bonded base", bonded),),
            (("", "frictionless base", sliding),),
            (("Pressure", "", tex["p(r)"]),),
        ]),
        ("A thick layer", "any profile, by depth and force of the half-space", [
            (("Sums over waves", "", tex["m_0"]), ("", "", tex["m_2"])),
            (("First order", "depth; the force is that of the half-space", tex["d of first order"]),),
            (("Second order", "force", tex["F_N of second order"]),),
            (("", "depth", tex["d of second order"]),),
            (("Paraboloid", "force at a given depth", tex["F_N of a paraboloid"]),),
        ]),
    ]  # fmt: skip


@cache
def expansions() -> tuple[sp.Expr, ...]:
    """Force and depth of a paraboloid to the first order, and to the second."""
    force, depth = stated.expanded().values()
    for function, name in ((DEPTH, "depth"), (FORCE, "force")):
        own = sp.Lambda(nt.a, _half_space(name))
        force, depth = (expr.replace(function, own) for expr in (force, depth))
    depth = depth.subs(nt.F, force).doit()
    return *(own.subs(stated.m_2, 0) for own in (force, depth)), force, depth


@cache
def coefficients() -> tuple[sp.Expr, ...]:
    """Of the powers of chi in the force of a paraboloid at a depth, over that of the half-space."""
    force, depth = (own.subs(nt.a, DEEP * stated.thickness) for own in expansions()[2:])
    scale = nt.R / (DEEP * stated.thickness) ** 2
    square = sp.expand(depth * scale)
    more = sp.expand(force / _alone().subs(nt.d, 1 / scale))
    ratio = _cut(more * _power(square, -sp.Rational(3, 2)))
    # chi = e root(square): Lagrange's inversion
    slope = sp.diff(ratio, DEEP)
    found = (_cut(slope * _power(square, -sp.Rational(i, 2))).coeff(DEEP, i - 1) / i for i in range(1, ORDER + 1))
    return sp.S.One, *map(sp.factor, found)


def _power(series: sp.Expr, exponent: sp.Rational) -> sp.Expr:
    """Of a polynomial in e that begins with 1."""
    found, more = sp.S.One, sp.S.One
    for i in range(1, ORDER + 1):
        more = _cut(more * (series - 1))
        found += sp.binomial(exponent, i) * more
    return found


def _cut(expr: sp.Expr) -> sp.Expr:
    """A polynomial in e without the powers that are too high."""
    whole = sp.expand(expr)
    return sp.Add(*(whole.coeff(DEEP, i) * DEEP**i for i in range(ORDER + 1)))


@cache
def moments(nu: float, base: str = next(iter(stated.BASES))) -> Mapping[sp.Symbol, mp.mpf]:
    """m_0 and m_2 of a layer."""
    with mp.workdps(2 * DIGITS):
        sunk = sp.lambdify(nt.u, stated.sinking(nt.u, base).subs(nt.nu, sp.Rational(str(nu))), "mpmath")
        found = {}
        for symbol, moment in stated.MOMENTS.items():
            summand = sp.lambdify((nt.u, stated.L), moment.function, "mpmath")
            found[symbol] = mp.quad(lambda u, summand=summand: summand(u, sunk(u)), WAVES)
        return found


def sums() -> tuple[list[str], list[tuple[str, list[str]]]]:
    """Heads of the columns, and what the rows m_0 and m_2 of their table begin with and hold."""
    bonded, sliding = stated.BASES
    found = [*(moments(nu, bonded) for nu in POISSON), moments(POISSON[0], sliding)]
    rows = [(LEFT[symbol.name], [f"{float(own[symbol]):.5f}" for own in found]) for symbol in stated.MOMENTS]
    return [rf"$\nu={nu:g}$" for nu in POISSON] + [sliding], rows


def factor(chi: float, nu: float) -> float:
    """Force of a paraboloid on a bonded layer over that on a half-space, at the same depth, by the series."""
    own = moments(nu)
    return float(sum(c.subs(own) * chi**i for i, c in enumerate(coefficients())))


def solved(ratio: sp.Rational) -> tuple[Layer, Mapping[sp.Symbol, sp.Expr]]:
    """A paraboloid whose contact has this radius over the thickness, by the surface of the layer; and its numbers."""
    values = {symbol: sp.S.One for symbol in (nt.R, nt.E_star, stated.thickness)} | {nt.nu: sp.S.Half, nt.a: ratio}
    with mp.workdps(2 * DIGITS):
        return layer(HalfSpace(load("paraboloid"), values, DIGITS, graded=False), next(iter(stated.BASES))), values


DIGITS = 8
"""Of the solution: the table has five."""
WAVES = (0, 2, 6, 12, 24)
"""Stretches of a sum over wave numbers."""
POISSON = (0.0, 0.1, 0.2, 0.3, 0.4, 0.45, 0.5)
"""Poisson's ratios for which the sums of a bonded layer are printed; without friction it has no part in them."""
RATIOS = (*(sp.Rational(i, 10) for i in (1, 2, 3, 5)), sp.S.One)
"""Contact radius over thickness in the table."""
PUBLISHED = {
    "Dimitriadis et al. 2002": (1.133, 1.283, 0.769, 0.0975),
    "García & García 2018": (1.133, 1.497, 1.469, 0.755),
}
"""Coefficients in print, of chi and its powers, for a bonded layer and nu = 1/2."""


@cache
def compared() -> tuple[tuple[list[str], list[str]], ...]:
    """Rows of the table: a/h_0, chi, the force over that of the half-space; errors of all approximations in per cent.

    They are those of force and depth to the first order and to the second, at the radius, and of the force by the
    series, at the depth.
    """
    return tuple(map(_compared, RATIOS))


def _compared(ratio: sp.Rational) -> tuple[list[str], list[str]]:
    found, values = solved(ratio)
    depth, force, chi = float(found.depth), float(found.force()), float(mp.sqrt(found.depth))
    alone = float(_alone().subs({**values, nt.d: depth}))
    expanded = [float(own.subs({**values, **moments(0.5)})) for own in expansions()]
    series = [1 + sum(c * chi**i for i, c in enumerate(own, 1)) for own in PUBLISHED.values()]
    wanted = (force, depth, force, depth, *[force / alone] * (len(series) + 1))
    pairs = zip((*expanded, *series, factor(chi, 0.5)), wanted, strict=True)
    shares = [_per_cent(100 * (own / want - 1)) for own, want in pairs]
    return [f"{float(ratio):g}", f"{chi:.3f}", f"{force / alone:.4f}"], shares


def _per_cent(share: float) -> str:
    """Two digits, and no more than four behind the point."""
    places = min(4, max(0, 1 - math.floor(math.log10(abs(share)))))
    return f"${share:+.{places}f}$"
