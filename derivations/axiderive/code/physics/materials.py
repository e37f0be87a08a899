"""`axicontact.materials`: elastic constants of the contact, its radius, and the numbers of its adhesion."""

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
from ..text import written
from ..writer import ordered, required

NOTES = {
    "h_N": "Compared with a numerical solution of the equations of equilibrium of the graded half-space.",
    "E_ti": "The axis of symmetry is normal to the surface. Normal contact holds with it as with E_star, also with "
    "adhesion or under a viscoelastic law; not tangential contact, stresses below the surface, or a graded half-space.",
    "lambda_M": "Maugis 1992 writes it by K = 4 E_star/3. With the greatest attraction 16 dgamma/(9 sqrt(3) z_0) of "
    "Lennard-Jones it is 1.157 times Tabor's number.",
}
CHECKS = {
    nt.young_1: "_require_bodies(E_1, nu_1, E_2, nu_2)",
    nt.C_11: "_require_positive(C_11, C_33, C_13, C_44)",
    nt.radius_1: "_require_gap(R_1, R_2)",
}
"""What is asked of constants that depend on one another, by the first of them."""
FORMULAS = {
    "E_star": [
        "compliance = np.divide((1.0 - nu_1) * (1.0 + nu_1), E_1) + np.divide((1.0 - nu_2) * (1.0 + nu_2), E_2)",
        "return np.divide(1.0, compliance)",
    ],
    "E_ti": [
        "mean = C_11 * np.sqrt(C_33 / C_11)",
        "high, low = mean + C_13, mean - C_13",
        "return 2.0 * high * np.sqrt(C_44 / C_11 * (low / (high + 2.0 * C_44)))",
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
    "R": [
        "# of a ball that nearly fills its cup the sum of the radii keeps the digits that the curvatures lose",
        "share = np.where(np.isinf(R_2), 1.0, R_2 / (R_1 + R_2))",
        "return np.where(np.isinf(R_1), R_2, R_1 * share)",
    ],
    "mu_T": ["return np.cbrt(R / z_0 * (dgamma / E_star / z_0) ** 2)"],
    "lambda_M": ["return np.cbrt(4.5 / np.pi * (sigma_0 / E_star) ** 2 * (R * sigma_0 / dgamma))"],
}
CHECKED = [
    Function(
        "_require_bodies", [f"{name}: ArrayLike" for name in ("E_1", "nu_1", "E_2", "nu_2")], [],
        ['require(young_1=_finite("E_1", E_1), nu_1=nu_1, young_2=_finite("E_2", E_2), nu_2=nu_2)'], returns="None",
    ),
    Function(
        "_finite", ["name: str", "modulus: ArrayLike"], [],
        ["array = numbers(name, modulus)", "return np.where(array == np.inf, 1.0, array)"],
        "A rigid body or a plane is allowed: its infinite modulus or radius passes as one.",
    ),
    Function(
        "_require_positive", [f"{name}: ArrayLike" for name in ("C_11", "C_33", "C_13", "C_44")], [],
        [
            "require(C_11=C_11, C_33=C_33, C_13=C_13, C_44=C_44)",
            *ordered(
                "np.abs(C_13) < np.sqrt(C_11) * np.sqrt(C_33)", "C_13**2 < C_11*C_33",
                "the energy of some strain would be negative; look at the order of the constants, C_11 is along the "
                "surface, and C_13 of both directions",
                ("C_11", "C_33", "C_13"),
            ),
        ],
        returns="None",
    ),
    Function(
        "_require_gap", ["R_1: ArrayLike", "R_2: ArrayLike"], [],
        [
            'require(radius_1=_finite("R_1", R_1), radius_2=_finite("R_2", R_2))',
            "one, two = np.asarray(R_1), np.asarray(R_2)",
            *ordered(
                "np.where(two > 0.0, np.minimum(one, two) < np.inf, two < -one)", "1/R_1 + 1/R_2 > 0",
                "give a cup as -R_2 > R_1, wider than the ball in it, and two planes as no contact",
                ("R_1", "R_2"),
            ),
        ],
        returns="None",
    ),
]  # fmt: skip
VALUES = {
    nt.young_1: "1", nt.nu_1: "3/10", nt.young_2: "2", nt.nu_2: "1/2", nt.E_0: "3", nt.c_0: "2", nt.k: "1/4",
    nt.nu: "3/10", nt.C_11: "3", nt.C_33: "2", nt.C_13: "1", nt.C_44: "1/2", nt.radius_1: "1", nt.radius_2: "-3",
    nt.R: "2", nt.E_star: "1", nt.dgamma: "1/2", nt.z_0: "1/10", nt.sigma_0: "3",
}  # fmt: skip


def module(entries: Mapping[str, Entry]) -> Module:
    """The module of the constants."""
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
    check = CHECKS.get(entry.parameters[0], required(entry.parameters))
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
    """The definition where the result is one division or root away from it, else the result."""
    if entry.definition.lhs == nt.w:
        found = f"{entry.quantity.symbol} = {written(entry.cases[0].expr)}"
        own = [f" with {name} = {written(value)}" for name, value in entry.profile.abbreviations
               if entry.cases[0].expr.has(name)]  # fmt: skip
        return docstring.wrapped(found + "".join(own))
    equation = entry.definition
    return docstring.usual(docstring.wrapped(f"{written(equation.lhs)} = {written(equation.rhs)}"))


def _example(entry: Entry) -> list[str]:
    known = {symbol: sp.Rational(value) for symbol, value in VALUES.items()}
    known |= {symbol: expr.subs(known) for symbol, expr in entry.profile.abbreviations}
    passed = ", ".join(example.literal(known[symbol]) for symbol in entry.parameters)
    value = example.number(entry.cases[0].expr, known)
    return example.doctest(PACKAGE, "materials", f"{entry.quantity.function}({passed})", value)
