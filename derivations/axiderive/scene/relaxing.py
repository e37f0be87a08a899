"""Check values on a viscoelastic half-space: the convolution over the elastic contact by quadrature."""

from __future__ import annotations

from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..letters import name_of
from . import interface
from .contact import DIGITS, Contact
from .edged import Edged

LATER = (0.4, 1.9)
"""Times over that of the material."""


def relaxing(contact: Contact, edged: Edged, function: interface.Function) -> list[tuple[tuple[float, ...], Any]]:
    """Calls of a function with their results."""
    law = interface.LAWS[function.law]
    known = {symbol: sp.Float(contact.all[name_of(symbol)], 40) for symbol in law.parameters}
    modulus = sp.lambdify(nt.time, law.relaxation.xreplace(known), "mpmath")
    creep = sp.lambdify(nt.time, law.creep.xreplace(known), "mpmath")
    values = contact.all
    own = values["eta"] / values["E"] if "eta" in values else values.get("tau", values.get("t_0", 1.0))
    rows: list[tuple[tuple[float, ...], Any]] = []
    impulse = mp.mpf(str(law.impulse.xreplace(known)))
    with mp.workdps(DIGITS + 10):
        if not contact.compact:
            for d, later in zip(edged.depths * 2, LATER, strict=False):
                t = float(f"{later * own:.4g}")
                rows.append(_held(edged, function, d, t, modulus, impulse))
            return rows
        for a, later in zip(contact.radii(), LATER, strict=False):
            t, force, depth = float(f"{later * own:.4g}"), contact.normal("F", a), contact.normal("d", a)
            at = mp.mpf(t)
            if function.name == "step_load_radius":
                rows.append(((t, float(force / creep(at))), mp.mpf(a)))
            elif function.name == "step_force":
                rows.append(((t, float(depth)), modulus(at) * force))
            else:
                rows.append(((t, float(depth / at)), _ramp(contact, a, at, modulus, impulse)))
    return rows


def _held(
    edged: Edged, function: interface.Function, depth: float, t: float, modulus: Any, impulse: Any
) -> tuple[tuple[float, ...], Any]:
    """A complete contact: its edge, and so its radius, is fixed, and the force of a flat face grows as the depth."""
    force, at = edged.at("F", depth), mp.mpf(t)
    if function.name == "step_force":
        return (t, depth), modulus(at) * force
    whole = mp.quad(lambda y: modulus(at * y), [0, mp.mpf(1) / 2, 1])
    return (t, float(depth / at)), force * (whole + impulse / at)


def _ramp(contact: Contact, a: float, t: Any, modulus: Any, impulse: Any) -> Any:
    """int E(t - s) dF_el/ds ds with F_el ~ s**m; the exponent is that between this radius and half of it."""
    force, depth = contact.normal("F", a), contact.normal("d", a)
    m = mp.log(force / contact.normal("F", a / 2)) / mp.log(depth / contact.normal("d", a / 2))
    whole = mp.quad(lambda y: m * (1 - y) ** (m - 1) * modulus(t * y), [0, mp.mpf(1) / 2, 1])
    return force * (whole + impulse * m / t)
