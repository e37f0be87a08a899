"""Elastic constants of the contact: two bodies in one modulus, and the graded half-space in one modulus H.

c_N(x) = H |x|^k, (11.65), is read off the surface displacement of a point force,
(11.33).  h_N is the result of that problem; here it is stated, and proof.materials
solves the problem again.
"""

from __future__ import annotations

import sympy as sp

from ..entry import Case, Entry, Quantity
from ..notation import E_0, E_star, F, G_star, H, beta, c_0, h_N, k, nu, nu_1, nu_2, r, w, young_1, young_2
from ..profiles.materials import PROFILE
from ..profiles.pools import BODIES as POOL
from . import Physics, Wording
from .medium import HOMOGENEOUS

QUANTITIES = {
    q.suffix: q
    for q in (
        Quantity("E_star", "effective_modulus", "Effective modulus", E_star, (),
                 summary="Effective modulus E_star of two bodies; the modulus of a rigid one is infinite."),
        Quantity("G_star", "effective_shear_modulus", "Effective shear modulus", G_star, (),
                 summary="Effective shear modulus G_star of two bodies; the modulus of a rigid one is infinite."),
        Quantity("H", "graded_modulus", "Foundation modulus of the graded half-space", H, (),
                 summary="Foundation modulus H of a half-space of modulus E_0 (z/c_0)**k under a rigid indenter."),
        Quantity("h_N", "h_N", "Factor of the graded half-space", h_N, (),
                 summary="Factor h_N of a graded half-space, 1 for k = 0."),
    )
}  # fmt: skip
BODIES = (young_1, nu_1, young_2, nu_2)


def derive() -> dict[str, Entry]:
    """The four constants, keyed by suffix."""
    normal = (1 - nu_1**2) / young_1 + (1 - nu_2**2) / young_2
    # (2 - nu)/(4 G) with G = E/(2 (1 + nu))
    tangential = (2 - nu_1) * (1 + nu_1) / (2 * young_1) + (2 - nu_2) * (1 + nu_2) / (2 * young_2)
    graded = E_0 / ((1 - nu**2) * c_0**k)
    factor = _factor()
    point_force = sp.Eq(w, (1 - nu**2) * sp.cos(sp.pi * k / 2) * c_0**k * F / (h_N * sp.pi * E_0 * r ** (1 + k)))
    return {
        "E_star": _entry("E_star", 1 / normal, sp.Eq(1 / E_star, normal), BODIES, ()),
        "G_star": _entry("G_star", 1 / tangential, sp.Eq(1 / G_star, tangential), BODIES, ("(11.68)",)),
        "H": _entry("H", factor * graded, sp.Eq(H, h_N * graded), (E_0, c_0, k, nu), ("(11.39)", "(11.65)")),
        "h_N": _entry("h_N", factor, point_force, (k, nu), ("(11.33)",)),
    }


def _factor() -> sp.Expr:
    """h_N, 1 for k = 0, where beta = 1."""
    numerator = (1 + k) ** 2 * sp.cos(sp.pi * k / 2) * sp.gamma(1 + k / 2) ** 2
    gammas = sp.gamma((3 + k + beta) / 2) * sp.gamma((3 + k - beta) / 2)
    return numerator / (beta * sp.sin(sp.pi * beta / 2) * gammas)


def _entry(
    suffix: str, expr: sp.Expr, definition: sp.Expr, parameters: tuple[sp.Symbol, ...], references: tuple[str, ...]
) -> Entry:
    return Entry(
        key=f"{PROFILE.name}.{suffix}",
        profile=PROFILE,
        quantity=QUANTITIES[suffix],
        status="closed",
        cases=(Case((), expr),),
        definition=definition,
        parameters=parameters,
        references=references,
    )


PHYSICS = Physics(
    "materials",
    {HOMOGENEOUS: Wording(place=10, title="Elastic constants", searched="effective modulus Young Poisson")},
    lambda *_: derive(),
    pool=POOL,
    quantities={"materials": QUANTITIES},
)
