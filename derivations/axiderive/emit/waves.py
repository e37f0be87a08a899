"""The inverse of a paraboloid with a concentric wave: its curve in the unit and with the factor of the waves."""

from __future__ import annotations

import sympy as sp

from ..abel import masters
from ..contact.medium import HOMOGENEOUS
from ..notation import a
from ..profiles.profile import Profile
from .code import python


def wave_lines(profile: Profile, depth: sp.Expr, field: str) -> tuple[list[str], set[str]]:
    """The body of a(d) or a(F), by the `field`, and the parameters it needs.

    The depth is g(a) = square (z**2 + waves z H_0(z)) with a = unit z.

    Raises
    ------
    ValueError
        If the depth is not of that form.
    """
    depth = sp.expand(depth)
    (wave,) = depth.atoms(masters.StruveH)
    unit, square = a / wave.args[1], depth.coeff(wave, 0) / a**2
    waves = depth.coeff(wave, 1) / (a * unit * square)
    if any(sp.cancel(expr).has(a) for expr in (unit, square, waves)):
        message = f"{profile.name}: g(a) = {depth} is no paraboloid with one wave; solve it by `inverse`"
        raise ValueError(message)
    scaled, needs = f"{field} / unit * ({python(sp.cancel(1 / square))} / unit)", set[str]()
    if field == "F":
        # dF = 2 E* a dg
        scaled += f" / ({python(HOMOGENEOUS.stiffness().subs(a, sp.Symbol('unit', positive=True)))})"
        needs.add("E_star")
    lines = [
        f"unit = {python(sp.cancel(unit))}",
        f"waves = {python(sp.factor_terms(sp.cancel(waves)))}",
        f"return unit * inverse_over_waves({scaled}, waves, {1 if field == 'd' else 2})",
    ]
    return lines, needs | {str(s) for s in (unit * square * waves).free_symbols | square.free_symbols} - {"a"}
