"""Foeppl's direction: the displacement under a prescribed pressure p_0 (1 - r^2/a^2)^s, (11.104), (11.105).

(11.104) gives w1D = p_0 a B(1/2, s + 1) (1 - x^2/a^2)^(s + 1/2) / E*; (11.105)
is then one moment, inside over (0, r) and outside over (0, a).
"""

from __future__ import annotations

import sympy as sp

from ..abel.masters import Hypergeometric, gamma_normalised
from ..abel.moments import outside_moment
from ..entry import Case, Entry, Quantity
from ..notation import E_star, a, p_0, r, sigma, w
from ..profiles.loads import Load
from ..profiles.pools import PRESSURES
from . import Physics, Wording
from .medium import HOMOGENEOUS

HALF = sp.S.Half
QUANTITIES = {
    "w": Quantity("w", "displacement", "Surface displacement", w, (r,), written="w(r)", row="Displacement",
                  summary="Displacement of the surface into the half-space.")
}  # fmt: skip


def derive(load: Load) -> dict[str, Entry]:
    """The displacement inside and outside the loaded circle."""
    s = load.exponent
    scale = p_0 * a * sp.sqrt(sp.pi) * _gamma(s + 1) / _gamma(s + sp.Rational(3, 2)) / E_star
    w1D, x = sp.Function("w1D"), sp.Symbol("xi", positive=True)
    cases = (Case((r, a), scale * _inside(s)), Case((a, r), scale * _outside(s)))
    entry = Entry(
        key=f"loads.{load.name}.w",
        profile=load,
        quantity=QUANTITIES["w"],
        status="closed",
        cases=cases,
        definition=2 / sp.pi * sp.Integral(w1D(x) / sp.sqrt(r**2 - x**2), (x, 0, sp.Min(r, a))),
        parameters=(*load.parameters, E_star),
        references=("(11.104)", "(11.105)"),
    )
    return {"w": entry}


def _gamma(argument: sp.Expr) -> sp.Expr:
    """Gamma in terms of 1 + s > 0: a shift that starts from s would have a pole and a zero at s = -1/2."""
    positive = sp.Symbol("positive", positive=True)
    return gamma_normalised(argument.subs(sigma, positive - 1)).subs(positive, 1 + sigma)


def _inside(s: sp.Expr) -> sp.Expr:
    """2/pi int_0^r (1 - x^2/a^2)^(s + 1/2) / sqrt(r^2 - x^2) dx, a polynomial for half-integer s."""
    power, z = s + HALF, r**2 / a**2
    if power.is_Integer and power >= 0:
        return sum(sp.rf(-power, i) * sp.rf(HALF, i) / sp.factorial(i) ** 2 * z**i for i in range(int(power) + 1))
    if s == 0:
        return 2 / sp.pi * sp.elliptic_e(z)
    return Hypergeometric(-power, HALF, sp.S.One, z)


def _outside(s: sp.Expr) -> sp.Expr:
    """2/pi int_0^a (1 - x^2/a^2)^(s + 1/2) / sqrt(r^2 - x^2) dx."""
    power, z = s + HALF, a**2 / r**2
    if power == 0:
        return 2 / sp.pi * sp.asin(a / r)
    if power == 1:
        # x^2 under the root by parts: int x^2/sqrt(r^2 - x^2) = (r^2 asin(a/r) - a sqrt(r^2 - a^2))/2
        square = (r**2 * outside_moment(1).expr() - a * sp.sqrt(r**2 - a**2)) / 2
        return sp.factor_terms(2 / sp.pi * (outside_moment(1).expr() - square / a**2))
    if s == 0:
        return 2 * r / (sp.pi * a) * (sp.elliptic_e(z) - (1 - z) * sp.elliptic_k(z))
    beta = sp.sqrt(sp.pi) * _gamma(power + 1) / _gamma(power + sp.Rational(3, 2))
    return beta * a / (sp.pi * r) * Hypergeometric(HALF, HALF, power + sp.Rational(3, 2), z)


PHYSICS = Physics(
    "loads",
    {
        HOMOGENEOUS: Wording(
            place=9,
            title="Prescribed pressure",
            heading="Displacement",
            package="Displacement under a prescribed pressure",
            searched="prescribed pressure loaded circle",
        )
    },
    lambda profile, *_: derive(profile),
    pool=PRESSURES,
    contact="under a prescribed pressure",
    shown={p_0: "1", sigma: "3/10"},
    runtime=("physics.circle",),
    quantities={"loads": QUANTITIES},
    wanted=("displacement",),
)
