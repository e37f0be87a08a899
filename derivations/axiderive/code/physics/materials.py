"""`axicontact.materials`: elastic constants of the contact."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from ... import notation as nt
from ...entry import Entry
from ...letters import name_of
from ...physics.systems import BY_NAME
from .. import docstring, example
from ..function import Function
from ..module import PACKAGE, Module
from ..writer import required

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
CHECKED = [
    Function(
        "_require_bodies", [f"{name}: ArrayLike" for name in ("E_1", "nu_1", "E_2", "nu_2")], [],
        ['require(young_1=_finite("E_1", E_1), nu_1=nu_1, young_2=_finite("E_2", E_2), nu_2=nu_2)'], returns="None",
    ),
    Function(
        "_finite", ["name: str", "modulus: ArrayLike"], [],
        ["array = numbers(name, modulus)", "return np.where(array == np.inf, 1.0, array)"],
        "A rigid body is allowed: its infinite modulus passes as one.",
    ),
]  # fmt: skip
VALUES = {
    nt.young_1: "1", nt.nu_1: "3/10", nt.young_2: "2", nt.nu_2: "1/2", nt.E_0: "3", nt.c_0: "2", nt.k: "1/4",
    nt.nu: "3/10",
}  # fmt: skip


def module(entries: Mapping[str, Entry]) -> Module:
    """The module of the four constants."""
    profile, system = entries["h_N"].profile, BY_NAME["materials"]
    public = [_public(entry) for entry in entries.values()]
    stated = [
        Function(f"_{entries[suffix].quantity.function}", [], _names(entries[suffix]), lines)
        for suffix, lines in FORMULAS.items()
    ]
    return Module(system, system.name, profile.title, profile.subtitle, public, [*stated, *CHECKED])


def _names(entry: Entry) -> list[str]:
    return [name_of(symbol) for symbol in entry.parameters]


def _public(entry: Entry) -> Function:
    quantity, names = entry.quantity, _names(entry)
    check = BODIES if nt.young_1 in entry.parameters else required(entry.parameters)
    doc = docstring.document(
        quantity.summary,
        _formula(entry),
        docstring.parameters([], entry.parameters),
        (docstring.NUMBERS, f"{docstring.measured(docstring.in_words(quantity.symbol), quantity.symbol)}."),
        f"{NOTES.get(entry.suffix, '')} Handbook: {entry.key}.".strip(),
        [f"chapter 11, equation {reference}" for reference in entry.references],
        _example(entry),
        "a parameter",
    )
    evaluated = f"elementwise({', '.join([f'_{quantity.function}', *(f'{name}={name}' for name in names)])})"
    body = [check, f"return {evaluated}"]
    return Function(quantity.function, names, [], body, doc, "Result")


def _formula(entry: Entry) -> list[str]:
    """The definition where the result is one division away from it, else the result."""
    if entry.suffix == "h_N":
        (own,) = entry.profile.abbreviations
        return docstring.wrapped(f"h_N = {sp.sstr(entry.cases[0].expr)} with {own[0]} = {sp.sstr(own[1])}")
    equation = entry.definition
    return docstring.usual(docstring.wrapped(f"{sp.sstr(equation.lhs)} = {sp.sstr(equation.rhs)}"))


def _example(entry: Entry) -> list[str]:
    known = {symbol: sp.Rational(value) for symbol, value in VALUES.items()}
    known |= {symbol: expr.subs(known) for symbol, expr in entry.profile.abbreviations}
    passed = ", ".join(example.literal(known[symbol]) for symbol in entry.parameters)
    value = example.number(entry.cases[0].expr, known)
    return example.doctest(PACKAGE, "materials", f"{entry.quantity.function}({passed})", value)
