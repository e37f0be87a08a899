"""A worked example for every profile: real materials, a real load, and the function behind every number."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Entry
from ..figures.values import Numbers
from ..profiles.profile import Profile
from .cases import CASES, Case
from .contact import infinite, largest, loaded, number, parameters, pull_off
from .further import further
from .python import in_python
from .quantities import given_text, quantity_text, stated_text

DISTANCE = sp.Rational(5, 100)
"""Of the point that the depth of a plane example is related to, in m."""


def worked(
    profile_id: str, profile: Profile, derived: Mapping[str, Mapping[str, Entry]], make: Callable[..., Numbers]
) -> Any:
    """Heading, numbers with the key of their formula, and the examples of further physics; None without a case."""
    case = CASES.get(profile_id)
    if case is None:
        return None
    entries = derived[profile_id]
    values = parameters(profile, case)
    values[nt.E_star] = case.material.modulus
    for symbol, expr in profile.abbreviations:
        values.setdefault(symbol, expr.xreplace(values))
    numbers = loaded(profile, entries, values, case, make)
    radius = numbers["a"]
    mean = numbers.mean_pressure
    plane = numbers.place("p") == nt.x
    depth = numbers("d", number(DISTANCE)) if plane else numbers.depth
    shown = [
        *([("a", radius, "m", "aP" if plane else "aF")] if numbers.compact else []),
        ("d", depth, "m", "d" if "d" in entries else "dF"),
        (r"\bar p", mean, "Pa", "pm" if "pm" in entries else ""),
    ]
    place = infinite(profile, values)
    if not place:
        ends = [mp.mpf(0), *(numbers[b.name] for b in profile.breaks), radius]
        shown.append(
            (r"p_{\mathrm{max}}", largest(lambda r: numbers("p", r), ends), "Pa", "pp" if "pp" in entries else "p")
        )
    if not plane:
        shown.append(("w(2a)", numbers("w", 2 * radius), "m", "w"))
    if case.material.separation and numbers.compact and not profile.breaks:
        shown.append(("F_{\\mathrm c}", pull_off(numbers, case), "N", "adh.Fc"))
    results = [value for name, value, _, _ in shown if name in ("a", "d", "w(2a)")][:2]
    given = [
        rf"${_latex(name)}={given_text(name, text, _degree(name, profile, case))}$"
        for name, text in case.parameters.items()
    ]
    name, unit = ("P", "N/m") if plane else (r"F_{\mathrm N}", "N")
    load = f"${name}={stated_text(mp.mpf(case.load), unit)}$"
    distance = [f"$L={stated_text(number(DISTANCE), 'm')}$"] if plane else []
    modulus = rf"$E^{{*}}={quantity_text(number(case.material.modulus), 'Pa')}$"
    return {
        "words": "; ".join(
            [case.material.words, modulus, *given, load, *distance, *([case.remark] if case.remark else [])]
        ),
        "numbers": [
            *((name, quantity_text(value, unit), key) for name, value, unit, key in shown),
            *([(f"p({place})", r"\infty", "p")] if place else []),
        ],
        "further": further(profile_id, derived, case, numbers),
        "python": in_python(profile_id, profile, entries, case, results),
    }


def _latex(name: str) -> str:
    return nt.describe(name).latex if nt.known(name) else name


def _degree(name: str, profile: Profile, case: Case) -> int:
    """The power of r that belongs to an amplitude."""
    if name.startswith("A_"):
        return int(name[2:])
    if name != "A":
        return 0
    shape = profile.pieces[0].expr
    return (
        int(case.parameters["n"])
        if "n" in case.parameters
        else int(sp.degree(shape, nt.x if shape.has(nt.x) else nt.r))
    )
