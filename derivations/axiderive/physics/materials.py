"""Constants of the contact: two bodies in one modulus and one radius, half-spaces in one modulus, numbers of adhesion.

A wave of pressure decays below the surface of a transversely isotropic half-space as exp(-s z), with the two roots of

    C_33 C_44 s^4 - (C_11 C_33 - C_13^2 - 2 C_13 C_44) s^2 + C_11 C_44 = 0,

and its modulus is 2 (C_11 C_33 - C_13^2)/(sqrt(C_11 C_33) (s_1 + s_2)); all normal contact, also with adhesion or
under a viscoelastic law, follows with it as with E*.

c_N(x) = H |x|^k, (11.65), is read off the surface displacement of a point force,
(11.33).  h_N is the result of that problem; here it is stated, and proof.materials
solves the problem again.
"""

from __future__ import annotations

import sympy as sp

from ..entry import Case, Entry, Quantity
from ..notation import (
    C_11,
    C_13,
    C_33,
    C_44,
    E_0,
    E_star,
    F,
    G_star,
    H,
    R,
    beta,
    c_0,
    dgamma,
    h_N,
    k,
    lambda_M,
    mu_T,
    nu,
    nu_1,
    nu_2,
    r,
    radius_1,
    radius_2,
    sigma_0,
    w,
    young_1,
    young_2,
    z_0,
)
from ..profiles.pools import BODIES as POOL
from ..profiles.pools import ELASTIC
from . import Physics, Wording
from .medium import HOMOGENEOUS

QUANTITIES = {
    q.suffix: q
    for q in (
        Quantity("E_star", "effective_modulus", "Effective modulus", E_star, (),
                 summary="Effective modulus E_star of two bodies; the modulus of a rigid one is infinite."),
        Quantity("E_ti", "transversely_isotropic_modulus", "Effective modulus of transverse isotropy", E_star, (),
                 row="Effective modulus: transverse isotropy",
                 summary="Effective modulus E_star of a half-space that is isotropic along its surface, under a rigid "
                 "indenter."),
        Quantity("G_star", "effective_shear_modulus", "Effective shear modulus", G_star, (),
                 summary="Effective shear modulus G_star of two bodies; the modulus of a rigid one is infinite."),
        Quantity("H", "graded_modulus", "Foundation modulus of the graded half-space", H, (),
                 summary="Foundation modulus H of a half-space of modulus E_0 (z/c_0)**k under a rigid indenter."),
        Quantity("h_N", "h_N", "Factor of the graded half-space", h_N, (),
                 summary="Factor h_N of a graded half-space, 1 for k = 0."),
        Quantity("R", "effective_radius", "Effective radius", R, (),
                 summary="Effective radius R of two bodies; negative for a cup, infinite for a plane."),
        Quantity("mu_T", "tabor", "Tabor's number", mu_T, (),
                 summary="Tabor's number: what adhesion pulls out over the distance in which it acts."),
        Quantity("lambda_M", "maugis_lambda", "Parameter of Maugis", lambda_M, (),
                 summary="Parameter lambda of Maugis' transition, for the attraction of a constant stress sigma_0."),
    )
}  # fmt: skip
BODIES = (young_1, nu_1, young_2, nu_2)
TRANSVERSE = (C_11, C_33, C_13, C_44)


def derive() -> dict[str, Entry]:
    """The constants, keyed by suffix."""
    normal = (1 - nu_1**2) / young_1 + (1 - nu_2**2) / young_2
    # (2 - nu)/(4 G) with G = E/(2 (1 + nu))
    tangential = (2 - nu_1) * (1 + nu_1) / (2 * young_1) + (2 - nu_2) * (1 + nu_2) / (2 * young_2)
    graded = E_0 / ((1 - nu**2) * c_0**k)
    factor = _factor()
    point_force = sp.Eq(w, (1 - nu**2) * sp.cos(sp.pi * k / 2) * c_0**k * F / (h_N * sp.pi * E_0 * r ** (1 + k)))
    below = sp.Eq(w, F / (sp.pi * E_star * r))
    curvature = 1 / radius_1 + 1 / radius_2
    tabor = R * dgamma**2 / (E_star**2 * z_0**3)
    # Maugis' K is 4 E*/3
    maugis = 8 * sigma_0**3 * R / (sp.pi * dgamma * (4 * E_star / 3) ** 2)
    return {
        "E_star": _entry("E_star", 1 / normal, sp.Eq(1 / E_star, normal), BODIES, ()),
        "E_ti": _entry("E_ti", _transverse(), below, TRANSVERSE, ()),
        "G_star": _entry("G_star", 1 / tangential, sp.Eq(1 / G_star, tangential), BODIES, ("(11.68)",)),
        "H": _entry("H", factor * graded, sp.Eq(H, h_N * graded), (E_0, c_0, k, nu), ("(11.39)", "(11.65)")),
        "h_N": _entry("h_N", factor, point_force, (k, nu), ("(11.33)",)),
        "R": _entry("R", 1 / curvature, sp.Eq(1 / R, curvature), (radius_1, radius_2), ()),
        "mu_T": _entry("mu_T", sp.cbrt(tabor), sp.Eq(mu_T**3, tabor), (R, E_star, dgamma, z_0), ()),
        "lambda_M": _entry("lambda_M", sp.cbrt(maugis), sp.Eq(lambda_M**3, maugis), (R, E_star, dgamma, sigma_0), ()),
    }


def _transverse() -> sp.Expr:
    """The modulus by the sum of both roots, whose squares and product are coefficients of their equation."""
    mean = sp.Symbol("mean", positive=True)
    opposite = mean**2 / C_11
    squares = (mean**2 - C_13**2 - 2 * C_13 * C_44) / (opposite * C_44)
    both = squares + 2 * C_11 / mean
    # both factors are positive, as C_13^2 < C_11 C_33
    high, low = mean + C_13, mean - C_13
    share = sp.factor(low / (mean**2 * both))
    return sp.Mul(2, high, sp.sqrt(low * share)).subs(mean, sp.sqrt(C_11 * C_33))


def _factor() -> sp.Expr:
    """h_N, 1 for k = 0, where beta = 1."""
    numerator = (1 + k) ** 2 * sp.cos(sp.pi * k / 2) * sp.gamma(1 + k / 2) ** 2
    gammas = sp.gamma((3 + k + beta) / 2) * sp.gamma((3 + k - beta) / 2)
    return numerator / (beta * sp.sin(sp.pi * beta / 2) * gammas)


def _entry(
    suffix: str, expr: sp.Expr, definition: sp.Expr, parameters: tuple[sp.Symbol, ...], references: tuple[str, ...]
) -> Entry:
    return Entry(
        key=f"{ELASTIC.name}.{suffix}",
        profile=ELASTIC,
        quantity=QUANTITIES[suffix],
        status="closed",
        cases=(Case((), expr),),
        definition=definition,
        parameters=parameters,
        references=references,
    )


PHYSICS = Physics(
    "materials",
    {
        HOMOGENEOUS: Wording(
            place=10,
            title="Elastic constants",
            searched="effective modulus Young Poisson transversely isotropic radius Tabor Maugis",
        )
    },
    lambda *_: derive(),
    pool=POOL,
    quantities={"materials": QUANTITIES},
)
