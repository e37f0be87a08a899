"""Modules `axicontact.loads.<load>`: the displacement under a prescribed pressure."""

from __future__ import annotations

import sympy as sp

from ...entry import Entry
from ...profiles.loads import Load
from . import text
from .examples import Example
from .text import Function, evaluate, private

IMPORTS = (
    ".._circle: hertzian, power, uniform",
    ".._domain: require",
    ".._elementwise: Array, Result, elementwise",
    ".._integrals: difference_root",
)
SUMMARY = {"w": "Displacement of the surface into the half-space."}
FORMULAS = {
    sp.S.Zero: ["return p_0 / E_star * uniform(r, a)"],
    -sp.S.Half: [
        "angle = np.arctan2(a, difference_root(np.maximum(r, a), a))",
        "return 2.0 * p_0 * a / E_star * np.where(r > a, angle, np.pi / 2.0)",
    ],
    sp.S.Half: ["return p_0 / E_star * hertzian(r, a)"],
}


def module_source(load: Load, entry: Entry) -> str:
    """The module of one load."""
    keywords = [text.name_of(symbol) for symbol in entry.parameters]
    body = [text.required(entry.parameters), f"return {evaluate('_displacement', ['r'], keywords, False)}"]
    document = text.document(entry, ["r"], keywords, "Frictionless half-space. Negative or NaN radii give NaN.")
    example = Example(load, {"w": entry}, "loads").lines("w")
    public = Function("displacement", ["r"], keywords, SUMMARY["w"], document, body, example=example)
    lines = FORMULAS.get(load.exponent, ["return p_0 / E_star * power(r, a, s)"])
    return text.module(load.title, load.subtitle, IMPORTS, [public], [private("_displacement", ["r"], keywords, lines)])
