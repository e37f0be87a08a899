"""The table of material and load parameters with closed or open domains, read off the notation."""

from __future__ import annotations

import re

import sympy as sp

from ... import notation as nt
from .text import RENAMED

INSTEAD = {
    "dgamma": "use dgamma = 0 for a contact without adhesion",
    "mu": "give the coefficient as a positive number; mu = 0 is the contact without friction",
    "s": "a steeper edge carries an infinite force; use s > -1, or the flat punch for s = -1/2",
    "v": "a shrinking contact does not obey the rule of Lee and Radok; only growing contacts, v > 0, are at hand",
    "alpha": "use the Maxwell law for a fluid (alpha = 1) and the elastic contact for alpha = 0",
    "k": "use a modulus that grows less than linearly with depth, or k = 0 for a homogeneous half space",
}
RECORDS = (
    nt.dgamma, nt.mu, nt.G_star, nt.v, nt.E, nt.E_inf, nt.E_1, nt.relaxation, nt.eta, nt.alpha, nt.t_0, nt.p_0,
    nt.sigma, nt.k,
)  # fmt: skip
OTHERS = (
    ("nu", "-1.0", "0.5", False, True, "-1 < nu <= 1/2", "Poisson ratio"),
    ("nu_1", "-1.0", "0.5", False, True, "-1 < nu_1 <= 1/2", "Poisson ratio of the first body"),
    ("nu_2", "-1.0", "0.5", False, True, "-1 < nu_2 <= 1/2", "Poisson ratio of the second body"),
    ("E_2", "0.0", "inf", False, False, "E_2 > 0", "modulus of the second body, in Pa"),
    ("E_0", "0.0", "inf", False, False, "E_0 > 0", "modulus at the depth of reference, in Pa"),
    ("c_0", "0.0", "inf", False, False, "c_0 > 0", "depth of reference, in m"),
    ("d", "0.0", "inf", True, False, "d >= 0", "indentation depth, in m"),
    ("F", "0.0", "inf", True, False, "F >= 0", "normal force, in N"),
)

HEAD = '''"""Domains of material and load parameters: what is wrong, what is allowed, what to use instead."""

from __future__ import annotations

from math import inf
from typing import TYPE_CHECKING

import numpy as np

from ._domain import numbers

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

PHYSICS = {
'''
TAIL = '''}


def require_physics(**parameters: ArrayLike) -> None:
    """Check parameters against the domains of the notation.

    Raises
    ------
    ValueError
        With the parameter, its value, the rule and what to use instead.
    TypeError
        If a value is not a real number or an array of real numbers.
    """
    for name, value in parameters.items():
        low, high, from_low, to_high, rule, meaning, instead = PHYSICS[name]
        array = numbers(name, value)
        above = (low <= array) if from_low else (low < array)
        below = (array <= high) if to_high else (array < high)
        inside = np.isfinite(array) & above & below
        if not inside.all():
            wrong = float(array[~inside].flat[0])
            message = f"{name} = {wrong!r} is outside {rule}; {name} is the {meaning}{instead}"
            raise ValueError(message)
'''


def bounds_source() -> str:
    """The text of `_bounds.py`."""
    rows = [_row(symbol) for symbol in RECORDS] + list(OTHERS)
    lines = []
    for name, low, high, from_low, to_high, rule, meaning in rows:
        instead = f"; {INSTEAD[name]}" if name in INSTEAD else ""
        values = [low, high, str(from_low), str(to_high), f'"{rule}"', f'"{meaning}"', f'"{instead}"']
        lines += [f'    "{name}": (', *(f"        {value}," for value in values), "    ),"]
    return HEAD + "\n".join(lines) + "\n" + TAIL


def _row(symbol: sp.Symbol) -> tuple[str, str, str, bool, bool, str, str]:
    record, name = nt.describe(symbol), RENAMED.get(symbol, str(symbol))
    unit = "" if record.unit == "1" else f", in {record.unit}"
    two = re.fullmatch(r"(\S+) < \w+ < (\S+)", record.domain)
    if two:
        low, high, closed = two[1], two[2], False
    else:
        one = re.fullmatch(r"\w+ (>=?) (\S+)", record.domain)
        assert one is not None
        low, high, closed = one[2], "inf", one[1] == ">="
    high = high if high == "inf" else repr(float(high))
    return name, repr(float(low)), high, closed, False, record.domain, record.meaning + unit
