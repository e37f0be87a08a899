"""The same indenter with friction, on a graded and on a viscoelastic half-space: one example of each physics."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Entry
from ..figures.values import Numbers, Values
from ..oracle.evaluate import case_at, evaluated
from ..oracle.shape import number
from ..physics import materials
from .cases import ACRYLIC, CARTILAGE, CERAMIC, ELASTOMER, PMMA, POLYETHYLENE, POLYMER, SILICONE, Case
from .contact import loaded
from .shown import DIGITS, given_text, quantity_text, stated_text

GRADED, SOLIDS = {SILICONE: CARTILAGE, PMMA: POLYMER}, {SILICONE: ELASTOMER, PMMA: ACRYLIC}
"""Materials that an indenter of the same size is pressed into; those of steel are a ceramic and polyethylene."""
Entries = Mapping[str, Entry]
Derived = Mapping[str, Entries]
Shown = list[tuple[str, Any, str, str]]
"""Name in print, value, unit and end of the key."""


def further(profile_id: str, derived: Derived, case: Case, contact: Numbers) -> list[dict[str, Any]]:
    """Examples after the normal contact: what they are of, what is given, and the numbers with their keys."""
    found = []
    for group, example in (("tan", _with_friction), ("fgm", _graded), ("vis", _relaxing)):
        entries = derived.get(f"{profile_id}.{group}")
        if entries:
            with mp.workdps(DIGITS):
                title, words, shown = example(entries, case, contact)
            numbers = [(name, quantity_text(value, unit), key) for name, value, unit, key in shown]
            found.append({"title": title, "words": words, "numbers": numbers})
    if profile_id in BLUNTED:
        found.insert(0, _sharp(contact))
    return found


BLUNTED = ("rounded_cone", "sphere_tipped_cone")


def _sharp(contact: Numbers) -> dict[str, Any]:
    """The force on a cone without the tip at the same depth: whether the blunting matters.

    The formula is that of the entry of the cone, with which the number is read back: an entry is printed from its own.
    """
    with mp.workdps(DIGITS):
        force = 2 * contact["E_star"] * contact.depth**2 / (mp.pi * mp.tan(contact["theta"]))
    numbers = [(r"F_{\mathrm N}", quantity_text(force, "N"), "")]
    return {"title": "Sharp cone", "words": "of the same inclination at the same depth", "numbers": numbers}


def _with_friction(entries: Mapping[str, Entry], case: Case, contact: Numbers) -> tuple[str, str, Shown]:
    """Half of the force at which everything slips, to three digits."""
    friction, radius = sp.Rational(case.material.friction), contact["a"]
    pulled = sp.Rational(f"{float(friction) * case.load / 2:.3g}")  # as it is printed
    values = contact.values | {nt.mu: friction, nt.G_star: case.material.shear, nt.F_x: pulled}
    lowest = contact[contact.profile.breaks[0].name] if contact.profile.truncated else radius / 10**6

    def excess(logarithm: Any) -> Any:
        return Numbers(contact.profile, entries, values | {nt.c: mp.exp(logarithm)}, DIGITS)("F") / number(pulled) - 1

    stick = mp.exp(_root(excess, mp.log(lowest), mp.log(radius)))
    slipping = Numbers(contact.profile, entries, values | {nt.c: stick}, DIGITS)
    given = [
        rf"$\mu={case.material.friction}$",
        rf"$G^{{*}}={quantity_text(number(case.material.shear), 'Pa')}$",
        rf"$F_x={stated_text(number(pulled), 'N')}$",
    ]
    shown: Shown = [
        ("c", stick, "m", "tan.c"),
        ("u", slipping("u"), "m", "tan.u"),
        (r"u_{\mathrm s}", slipping("us"), "m", "tan.us"),
        (r"\tau(a/2)", slipping("tau", radius / 2), "Pa", "tan.tau"),
    ]
    return "Partial slip", "; ".join(given), shown


def _graded(entries: Mapping[str, Entry], case: Case, contact: Numbers) -> tuple[str, str, Shown]:
    """A rigid body of this shape under the same force."""
    medium = GRADED.get(case.material, CERAMIC)
    own: Values = {nt.describe(name).symbol: sp.Rational(getattr(medium, name)) for name in ("E_0", "c_0", "k", "nu")}
    modulus = foundation_modulus(materials.derive(), own)
    values = {s: x for s, x in contact.values.items() if s not in (nt.a, nt.E_star)} | own | {nt.H: modulus}
    if not contact.compact:
        values[nt.a] = contact.values[nt.a]
    pressed = loaded(contact.profile, entries, values, case, Numbers)
    radius = pressed["a"]
    given = [f"${nt.describe(name).latex}={given_text(name, getattr(medium, name))}$" for name in ("E_0", "c_0", "k")]
    given += [
        rf"$\nu={medium.nu}$",
        rf"$H={quantity_text(modulus, 'Pa')[:-1]}\,m}}^{{-k}}$",
    ]
    shown: Shown = [
        *([("a", radius, "m", "fgm.aF")] if contact.compact else []),
        ("d", pressed.depth, "m", "fgm.d" if contact.compact else "fgm.dF"),
        (r"\bar p", pressed.mean_pressure, "Pa", "fgm.pm" if "pm" in entries else ""),
    ]
    return "Graded half-space", f"{medium.words}; " + "; ".join(given), shown


def foundation_modulus(entries: Entries, values: Values) -> Any:
    """H from Young's modulus at a depth; the values get what it is short for."""
    for symbol, expr in entries["H"].profile.abbreviations:
        values[symbol] = evaluated(expr, values)
    return value_of(entries["H"], values)


def _relaxing(entries: Mapping[str, Entry], case: Case, contact: Numbers) -> tuple[str, str, Shown]:
    """A rigid body of this shape, pressed in to the same depth; then the first force instead kept constant."""
    rubber = SOLIDS.get(case.material, POLYETHYLENE)
    solid = {nt.describe(name).symbol: sp.Rational(getattr(rubber, name)) for name in ("E_inf", "E_1", "relaxation")}
    time = number(solid[nt.relaxation])
    values = contact.values | solid | {nt.d: contact.depth}

    def force(t: Any) -> Any:
        return value_of(entries["step_sls"], values | {nt.time: t})

    first = force(mp.mpf(0))
    shown: Shown = [
        (r"F_{\mathrm N}(0)", first, "N", "vis.step_sls"),
        (r"F_{\mathrm N}(\tau)", force(time), "N", "vis.step_sls"),
    ]
    if "load_sls" in entries:
        for name, t in ((r"a(\tau)", time), (r"a(10\tau)", 10 * time)):
            shown.append((name, _grown(entries["load_sls"], values | {nt.F: first, nt.time: t}), "m", "vis.load_sls"))
    else:
        shown.append((r"F_{\mathrm N}(10\tau)", force(10 * time), "N", "vis.step_sls"))
    names = {"E_inf": r"E_\infty", "E_1": "E_1", "relaxation": r"\tau"}
    units = {"relaxation": "s"}
    given = [f"${names[name]}={stated_text(mp.mpf(getattr(rubber, name)), units.get(name, 'Pa'))}$" for name in names]
    held = (
        r"held at the depth $d$, or under the force $F_{\mathrm N}(0)$"
        if "load_sls" in entries
        else r"held at the depth $d$"
    )
    return "Standard solid", "; ".join([rubber.words, *given, held]), shown


def value_of(entry: Entry, values: Values) -> Any:
    """The value of an explicit entry, or of the right side of its equation."""
    expr = case_at(entry, values).expr
    return mp.re(evaluated(expr.rhs if isinstance(expr, sp.Equality) else expr, values))


def _grown(entry: Entry, values: Values) -> Any:
    """The contact radius, larger than that of the first moment, which the values hold."""
    if entry.status == "closed":
        return value_of(entry, values)

    def excess(logarithm: Any) -> Any:
        at = values | {nt.a: mp.exp(logarithm)}
        expr = case_at(entry, at).expr
        return evaluated(expr.lhs, at) / evaluated(expr.rhs, at) - 1

    start = mp.log(evaluated(nt.a, values))
    return mp.exp(_root(excess, start, start + mp.mpf("0.4")))


def _root(function: Callable[[Any], Any], low: Any, high: Any) -> Any:
    """The root between two logarithms, which are borders themselves."""
    inside = mp.mpf(10) ** -12
    return mp.findroot(function, (low + inside, high - inside), solver="anderson", tol=mp.mpf(10) ** (-2 * DIGITS + 8))
