"""Modules `axicontact.loads.<load>`: the displacement under a prescribed pressure."""

from __future__ import annotations

import sympy as sp

from ...contact import loads
from ...profiles.loads import Load
from . import text
from .text import Function, private

IMPORTS = (
    ".._bounds: require_physics",
    ".._circle: power, uniform",
    ".._domain: require",
    ".._elementwise: Array, Result, elementwise",
    ".._integrals: difference_root",
)
OUTSIDE = "np.arctan2(a, difference_root(np.maximum(r, a), a))"
FORMULAS = {
    sp.S.Zero: ["return p_0 / E_star * uniform(r, a)"],
    -sp.S.Half: [f"return p_0 * 2.0 * a / E_star * np.where(r > a, {OUTSIDE}, np.pi / 2.0)"],
    sp.S.Half: ["return p_0 / E_star * hertzian(r, a)"],
}


def module_source(load: Load) -> str:
    """The module of one load."""
    entry = loads.derive(load)["w"]
    keywords = [text.name_of(symbol) for symbol in entry.parameters]
    plain = [name for name in keywords if name in ("a", "E_star")]
    physics = [name for name in keywords if name not in plain]
    body = [
        f"require({', '.join(f'{name}={name}' for name in plain)})",
        f"require_physics({', '.join(f'{name}={name}' for name in physics)})",
        f"return elementwise(_displacement, r, {', '.join(f'{name}={name}' for name in keywords)})",
    ]
    document = text.document(entry, ["r"], keywords, f"Valid for {load.validity}. Negative or NaN radii give NaN.")
    public = Function(
        "displacement", ["r"], keywords, "Displacement of the surface into the half space.", document, body
    )
    lines = FORMULAS.get(load.exponent, ["return p_0 / E_star * power(r, a, s)"])
    imports = [line + ", hertzian" if "_circle" in line else line for line in IMPORTS]
    return text.module(load.title, load.subtitle, imports, [public], [private("_displacement", ["r"], keywords, lines)])
