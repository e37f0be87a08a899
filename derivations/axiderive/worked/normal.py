"""A worked example for every profile: real materials, a real load, and the function behind every number.

What has no profile has one too: prescribed pressures, a punch under an eccentric load, elastic constants.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Entry
from ..figures.values import Numbers, Values
from ..letters import name_of
from ..oracle.evaluate import evaluated
from ..oracle.shape import number
from ..profiles.loads import Load
from ..profiles.profile import Profile
from .cases import BLOCK, CASES, CERAMIC, Case
from .contact import infinite, largest, loaded, parameters, pull_off
from .further import foundation_modulus, further, value_of
from .shown import DIGITS, Lines, called, given_text, in_python, modulus, quantity_text, shown, stated_text

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


PRESSED: Mapping[sp.Symbol, str] = {nt.p_0: "500e6", nt.a: "2e-3", nt.sigma: "2"}
TILTED: Mapping[sp.Symbol, str] = {nt.P: "1e6", nt.a: "2e-3", nt.e: "5e-4"}
BODIES: Mapping[sp.Symbol, str] = {nt.young_1: "210e9", nt.nu_1: "0.3", nt.young_2: "70e9", nt.nu_2: "0.33"}
"""Steel and aluminium."""
GRADED: Mapping[sp.Symbol, str] = {nt.E_0: CERAMIC.E_0, nt.c_0: CERAMIC.c_0, nt.k: CERAMIC.k, nt.nu: CERAMIC.nu}


def worked_bodies(entries: Mapping[str, Entry]) -> dict[str, Any]:
    """Two bodies in one modulus, and a graded half-space."""
    values: Values = {symbol: sp.Rational(text) for symbol, text in {**BODIES, **GRADED}.items()}
    with mp.workdps(DIGITS):
        modulus = foundation_modulus(entries, values)
        normal, shear, factor = (value_of(entries[suffix], values) for suffix in ("E_star", "G_star", "h_N"))
        numbers = [
            ("E^{*}", quantity_text(normal, "Pa"), "E_star"),
            ("G^{*}", quantity_text(shear, "Pa"), "G_star"),
            (r"h_{\mathrm N}", mp.nstr(factor, 4, strip_zeros=False), "h_N"),
            ("H", rf"{quantity_text(modulus, 'Pa')[:-1]}\,m}}^{{-k}}", "H"),
        ]
    bodies, graded = (
        ", ".join(f"${nt.describe(symbol).latex}={given_text(symbol.name, text)}$" for symbol, text in known.items())
        for known in (BODIES, GRADED)
    )
    words = f"steel on aluminium, {bodies}; {CERAMIC.words}, {graded}"
    both = {name_of(symbol): text for symbol, text in BODIES.items()}
    lines = [
        ("from axicontact import materials", ""),
        (called("materials", entries["E_star"], both), shown(normal)),
        (called("materials", entries["H"], {name_of(symbol): text for symbol, text in GRADED.items()}), shown(modulus)),
    ]
    return {"words": words, "numbers": numbers, "further": [], "python": lines}


def worked_given(profile: Profile, entries: Mapping[str, Entry]) -> dict[str, Any]:
    """Heading, and the numbers with the key of their formula."""
    pressed = isinstance(profile, Load)
    known = {
        symbol: text for symbol, text in (PRESSED if pressed else TILTED).items()
        if symbol in profile.parameters or symbol == nt.P
    }  # fmt: skip
    values: Values = {symbol: sp.Rational(text) for symbol, text in known.items()}
    values[nt.E_star] = BLOCK.modulus
    with mp.workdps(DIGITS):
        numbers = _displacements(profile, entries, values) if isinstance(profile, Load) else _tilt(entries, values)
    stated = rf"$E^{{*}}={quantity_text(number(BLOCK.modulus), 'Pa')}$"
    given = [f"${nt.describe(symbol).latex}={given_text(symbol.name, text)}$" for symbol, text in known.items()]
    words = "; ".join([BLOCK.words, stated, *given])
    return {"words": words, "numbers": numbers, "further": [], "python": _lines(profile, entries, known, values)}


def _lines(profile: Profile, entries: Mapping[str, Entry], known: Mapping[sp.Symbol, str], values: Values) -> Lines:
    """The displacement of a pressure at twice its radius, or the inclination of the punch."""
    given = {name_of(symbol): text for symbol, text in known.items()}
    if isinstance(profile, Load):
        package, entry, fields, place = "loads", entries["w"], (f"2*{given['a']}",), {nt.r: 2 * values[nt.a]}
    else:
        package, entry, fields, place = "plane", entries["phi"], (given["P"],), {}
    with mp.workdps(DIGITS):
        result = shown(value_of(entry, values | place))
    call = called(profile.name, entry, given, *fields)
    return [(f"from axicontact.{package} import {profile.name}", ""), (modulus(BLOCK), ""), (call, result)]


def _displacements(load: Load, entries: Mapping[str, Entry], values: Values) -> list[tuple[str, str, str]]:
    force = sp.pi * nt.p_0 * nt.a**2 / (load.exponent + 1)
    near = values[nt.a] * sp.Rational(1, 10**12)  # the middle itself is the border of the first range
    places = (("w(0)", near), ("w(a/2)", values[nt.a] / 2), ("w(2a)", 2 * values[nt.a]), ("w(10a)", 10 * values[nt.a]))
    found = [("F", quantity_text(evaluated(force, values), "N"), "")]
    return found + [
        (name, quantity_text(value_of(entries["w"], values | {nt.r: place}), "m"), "w") for name, place in places
    ]


def _tilt(entries: Mapping[str, Entry], values: Values) -> list[tuple[str, str, str]]:
    places = (("p(-a/2)", -values[nt.a] / 2), ("p(0)", sp.S.Zero), ("p(a/2)", values[nt.a] / 2))
    found = [(name, quantity_text(value_of(entries["p"], values | {nt.x: place}), "Pa"), "p") for name, place in places]
    return [
        (r"\varphi", quantity_text(value_of(entries["phi"], values), "rad"), "phi"),
        (r"\ell", quantity_text(value_of(entries["cw"], values), "m"), "cw"),
        *found,
    ]
