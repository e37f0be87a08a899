"""`axicontact.materials`: elastic constants of the contact."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from ... import notation as nt
from ...entry import Entry
from ...letters import name_of
from .. import example
from . import text
from .text import PACKAGE, Function, private

IMPORTS = (
    "interface: Array, Result, elementwise, numbers, require",
    "functions: gamma",
)
NOTES = {
    "h_N": "Compared with a numerical solution of the equations of equilibrium of the graded half-space.",
}
BODIES = "_require_bodies(E_1, nu_1, E_2, nu_2)"
FORMULAS = {
    "E_star": [
        "compliance = np.divide((1.0 - nu_1) * (1.0 + nu_1), E_1) + np.divide((1.0 - nu_2) * (1.0 + nu_2), E_2)",
        "return np.divide(1.0, compliance)",
    ],
    "G_star": [
        "compliance = np.divide((2.0 - nu_1) * (1.0 + nu_1), E_1) + np.divide((2.0 - nu_2) * (1.0 + nu_2), E_2)",
        "return np.divide(2.0, compliance)",
    ],
    "H": ["return _h_N(k, nu) * E_0 / ((1.0 - nu) * (1.0 + nu) * c_0**k)"],
    "h_N": [
        "beta = np.sqrt((1.0 + k) * ((1.0 - nu) - k * nu) / (1.0 - nu))",
        "gammas = gamma((3.0 + k + beta) / 2.0) * gamma((3.0 + k - beta) / 2.0)",
        "# the cosine of pi k/2, without the rounding of pi/2 near k = 1 and k = -1",
        "cosine = np.sin(np.pi * (1.0 - np.abs(k)) / 2.0)",
        "punch = ((1.0 + k) * gamma(1.0 + k / 2.0)) ** 2 * cosine",
        "return punch / (beta * np.sin(np.pi * beta / 2.0) * gammas)",
    ],
}
BODIES_CHECKED = """def _require_bodies(E_1: ArrayLike, nu_1: ArrayLike, E_2: ArrayLike, nu_2: ArrayLike) -> None:
    require(young_1=_finite("E_1", E_1), nu_1=nu_1, young_2=_finite("E_2", E_2), nu_2=nu_2)
"""
RIGID = [
    "array = numbers(name, modulus)",
    "return np.where(array == np.inf, 1.0, array)",
]
VALUES = {
    nt.young_1: "1", nt.nu_1: "3/10", nt.young_2: "2", nt.nu_2: "1/2", nt.E_0: "3", nt.c_0: "2", nt.k: "1/4",
    nt.nu: "3/10",
}  # fmt: skip


def module_source(entries: Mapping[str, Entry]) -> str:
    """The module of the four constants."""
    public = [_public(entry) for entry in entries.values()]
    functions = [
        private(f"_{entries[suffix].quantity.function}", [], _names(entries[suffix]), lines)
        for suffix, lines in FORMULAS.items()
    ]
    profile = entries["h_N"].profile
    return text.module(profile.title, profile.subtitle, IMPORTS, public, [*functions, BODIES_CHECKED, _finite()], ".")


def _finite() -> str:
    doc = "A rigid body is allowed: its infinite modulus passes as one."
    return private("_finite", ["name", "modulus"], [], RIGID, doc).replace(
        "name: Array, modulus: Array", "name: str, modulus: ArrayLike"
    )


def _names(entry: Entry) -> list[str]:
    return [name_of(symbol) for symbol in entry.parameters]


def _public(entry: Entry) -> Function:
    names, function = _names(entry), entry.quantity.function
    check = BODIES if nt.young_1 in entry.parameters else text.required(entry.parameters)
    body = [check, f"return elementwise(_{function}, {', '.join(f'{name}={name}' for name in names)})"]
    symbols = {name_of(symbol): symbol for symbol in entry.parameters}
    result = nt.describe(entry.quantity.symbol)
    lines = [*_formula(entry), "", "Parameters", "----------", *text.parameters(names, symbols, False)]
    lines += ["", "Returns", "-------", "float or ndarray"]
    lines += text.wrapped(f"{text.capital(result.meaning)} [{result.unit}].", 4)
    lines += ["", "Raises", "------", "ValueError", "    If a parameter is outside its domain."]
    lines += ["", "Notes", "-----", *text.wrapped(f"{NOTES.get(entry.suffix, '')} Handbook: {entry.key}.".strip())]
    if entry.references:
        sources = "; ".join(f"chapter 11, equation {reference}" for reference in entry.references)
        lines += ["", "References", "----------", f"{sources}."]
    return Function(function, names, [], entry.quantity.summary, lines, body, example=_example(entry))


def _formula(entry: Entry) -> list[str]:
    """The definition where the result is one division away from it, else the result."""
    if entry.suffix == "h_N":
        (own,) = entry.profile.abbreviations
        return text.wrapped(f"h_N = {sp.sstr(entry.cases[0].expr)} with {own[0]} = {sp.sstr(own[1])}")
    equation = entry.definition
    return text.renamed(text.wrapped(f"{sp.sstr(equation.lhs)} = {sp.sstr(equation.rhs)}"))


def _example(entry: Entry) -> list[str]:
    known = {symbol: sp.Rational(value) for symbol, value in VALUES.items()}
    known |= {symbol: expr.subs(known) for symbol, expr in entry.profile.abbreviations}
    passed = ", ".join(example.literal(known[symbol]) for symbol in entry.parameters)
    call = f"materials.{entry.quantity.function}({passed})"
    value = example.result(example.number(entry.cases[0].expr, known))
    return [f">>> from {PACKAGE} import materials", f">>> value = {call}", ">>> round(value, 6)", value]
