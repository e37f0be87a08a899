"""Evidence in print: of a spread, and in the words of the guide.

The evidence of a spread as plain data: certificates, agreement with definitions, measured errors, limits.

Numbers in the words of the guide, each computed from what it says, so that none is typed.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cache
from typing import Any

import mpmath as mp

from ..entry import Entry
from ..print.words import prose


def evidence_rows(
    profile_id: str, own: Mapping[str, Mapping[str, Entry]], evidence: Mapping[str, Any]
) -> dict[str, Any]:
    """Certificate and checks of every entry; nothing is claimed that is not recorded.

    Those of the problem the spread begins with as a table without empty columns, the others in short: the fewest
    digits that agreed.
    """
    table: list[dict[str, Any]] = []
    grid: list[dict[str, Any]] = []
    for key, entries in own.items():
        records = evidence.get(key, {}).get("entries", {})
        measured = evidence.get(key, {}).get("evaluation", {})
        for suffix, entry in entries.items():
            if suffix not in records:
                continue
            found = _evidence(entry, records[suffix], measured.get(suffix, {}), profile_id)
            (table if key == profile_id else grid).append(found)
    used = [i for i, _ in enumerate(KINDS) if any(row["cells"][i] != NOTHING for row in table)]
    for row in table:
        row["cells"] = [row["cells"][i] for i in used]
    return {"heads": [list(KINDS.values())[i] for i in used], "table": table, "grid": grid}


def _evidence(entry: Entry, record: Mapping[str, Any], measured: Mapping[str, Any], profile_id: str) -> dict[str, Any]:
    passed = [check for check in record.get("checks", []) if check["outcome"] == "passed"]
    by_kind: dict[str, list[Any]] = {kind: [] for kind in KINDS}
    for check in passed:
        by_kind[kind_of(check["compared"])].append(check)
    digits = [check["digits"] for check in passed if check.get("digits")]
    return {
        "suffix": entry.key[len(profile_id) + 1 :],
        "certified": bool(record.get("certified")),
        "twice": bool(record.get("twice", {}).get("shown")),
        "cells": [_agreement(by_kind[kind]) for kind in KINDS],
        "evaluation": _evaluation(measured) if measured else [],
        "ruled": measured.get("form") == "rule",
        "digits": str(min(digits)) if digits else "--",
        "count": str(sum(check.get("count", 0) for check in passed if check.get("digits"))),
    }


def summary(own: Mapping[str, Mapping[str, Entry]], evidence: Mapping[str, Any]) -> dict[str, int] | None:
    """The evidence of a profile in numbers: formulas, those proved, roots, integrals, the fewest digits that agreed.

    None where a formula is not recorded, or agreed with nothing.
    """
    recorded = [
        (entry, evidence.get(key, {}).get("entries", {}).get(suffix, {}))
        for key, entries in own.items()
        for suffix, entry in entries.items()
    ]
    digits = [
        [c["digits"] for c in r.get("checks", ()) if c["outcome"] == "passed" and c.get("digits")] for _, r in recorded
    ]
    if not all(digits):
        return None
    others = [entry.status for entry, record in recorded if not record.get("certified")]
    return {
        "formulas": len(recorded),
        "proved": len(recorded) - len(others),
        "digits": min(map(min, digits)),
        "roots": others.count("root"),
        "integrals": others.count("integral"),
    }


KINDS = {
    "quadrature": "defining integral", "enclosure": "ball arithmetic", "identity": "identities", "units": "units",
}  # fmt: skip
"""Heads of the columns of the evidence table by the kind of check."""
NOTHING = "--"
"""The cell of a kind of check that an entry has not passed."""


def kind_of(compared: str) -> str:
    """Which column of the evidence table a check belongs to."""
    words = compared.lower()
    if "quadrature" in words:
        return "quadrature"
    if "ball" in words or "arb" in words or "enclosure" in words:
        return "enclosure"
    return "units" if "dimension" in words or "unit" in words else "identity"


def missing_certificates(
    profile_id: str, own: Mapping[str, Mapping[str, Entry]], evidence: Mapping[str, Any]
) -> list[tuple[list[str], str]]:
    """Ends of the keys without a certificate and the reason, those of one reason together."""
    groups: dict[str, list[str]] = {}
    for key, entries in own.items():
        for suffix, entry in entries.items():
            record = evidence.get(key, {}).get("entries", {}).get(suffix, {"certified": True})
            reason = record.get("certificate", {}).get("reason", "")
            if not record.get("certified") and reason:
                groups.setdefault(_reason(reason, entry.key, profile_id), []).append(entry.key[len(profile_id) + 1 :])
    return [
        (suffixes, reason.replace("as they rest", "as it rests") if len(suffixes) == 1 else reason)
        for reason, suffixes in groups.items()
    ]


_RESTS = re.compile(r"rests on (\S+), which is not proved|(\S+) is ((?:the root|an integral).*)")


def _reason(text: str, key: str, profile_id: str) -> str:
    """The reason in words; another entry of the spread by the end of its key."""
    plain = text.removeprefix(f"{key} is ").removeprefix(f"{key.rpartition('.')[2]} is ")
    found = _RESTS.fullmatch(plain)
    base = (found[1] or found[2]) if found else ""
    if not base.startswith(f"{profile_id}."):
        return prose(plain)
    return rf"as they rest on \own{{{base.removeprefix(f'{profile_id}.')}}}"


def _agreement(checks: list[Any]) -> str:
    """The fewest digits / all points, and the worst residual of all."""
    if not checks:
        return NOTHING
    counted = [check for check in checks if check.get("digits")]
    if not counted:
        return r"\ok"
    least = min(check["digits"] for check in counted)
    worst = max((check["worst"] for check in counted), key=float)
    residual = power_of_ten(worst) if float(worst) else "0"
    return rf"{least}\,/\,{sum(check['count'] for check in counted)}\enspace${residual}$"


FORMS = {"closed": "closed form", "kernel": "special function", "rule": "Gauss rule", "root": "iteration"}
"""How a function of the catalogue evaluates its formula."""


def _evaluation(measured: Mapping[str, Any]) -> list[str]:
    """The way of evaluation and the worst errors in ulps: usual lengths, extreme ones, the printed formula."""
    # bodies that rest on another module have no form of their own
    nodes = ", ".join(str(count) for count in measured.get("nodes", ()))
    form = FORMS.get(measured.get("form", ""), "--") + (f", {nodes} nodes" if nodes else "")
    usual, extreme = measured["bench"], measured["extreme"]
    return [form, *(_ulps(found) for found in (usual, extreme, usual.get("naive", {})))]


NO_DIGIT = 2.0**52
"""Units in the last place from which no digit is right."""


def _ulps(found: Mapping[str, Any]) -> str:
    """The worst error and at how many points, those lost as NaN or infinite in brackets."""
    if not found.get("points"):
        return "--"
    if found.get("worst_ulp", 0.0) >= NO_DIGIT:
        return "no digit"
    worst = f"{found['worst_ulp']:.2g}" if "worst_ulp" in found else ""
    lost = f" ({found['lost']} lost)" if found["lost"] else ""
    return rf"${power_of_ten(worst)}$\,/\,{found['points']}{lost}" if worst else f"all {found['lost']} lost"


def power_of_ten(text: str) -> str:
    """2.7e-51 as 2.7 x 10^-51."""
    mantissa, _, exponent = text.partition("e")
    if exponent and float(mantissa) == 0:
        return "0"
    return f"{mantissa}\\times10^{{{int(exponent)}}}" if exponent else text


BERKOVICH = 24.5
"""Projected area of a Berkovich or a Vickers pyramid over the square of its depth."""
CUBE_CORNER = 1.5 * 3**0.5


def half_angle(area: float) -> float:
    """Half-angle in degrees of the cone that has this area over the square of its depth."""
    return float(mp.degrees(mp.atan(mp.sqrt(area / mp.pi))))


def slope(angle: float) -> float:
    """Slope of the flank of a cone of this half-angle in degrees."""
    return float(mp.cot(mp.radians(angle)))


def slope_factor(angle: float, nu: float) -> float:
    """Stiffness of a cone of this half-angle over that of small slopes (Hay, Bolshakov and Pharr 1999)."""
    steep = mp.cot(mp.radians(angle)) * (1 - 2 * nu) / (4 * (1 - nu))
    return float(mp.pi * (mp.pi / 4 + 0.15483073 * steep) / (mp.pi / 2 - 0.83119312 * steep) ** 2)


@cache
def sphere_over_paraboloid(ratio: float) -> float:
    """Force of a sphere over that of its paraboloid at the contact radius `ratio` times R, from the integrals."""
    return float(_force(lambda x: x / mp.sqrt(1 - x * x), ratio) / _force(lambda x: x, ratio))


def _force(slope: Any, a: float) -> Any:
    """F/E* = 2 (a g(a) - int_0^a g dt) with g(t) = t int_0^t f'(r)/sqrt(t^2 - r^2) dr."""

    def depth(t: Any) -> Any:
        return t * mp.quad(lambda angle: slope(t * mp.sin(angle)), [0, mp.pi / 2])

    return 2 * (a * depth(mp.mpf(a)) - mp.quad(depth, [0, a]))


@cache
def layer_factor(ratio: float, nu: float) -> float:
    """Force of a paraboloid on a bonded layer over that on a half-space, at sqrt(R d) = `ratio` times the thickness.

    To the second order in the ratio; the kernel is that of a layer on a rigid base.
    """
    k = 3 - 4 * mp.mpf(nu)

    def lost(u: Any) -> Any:
        # with exp(-2 u) in front of both, so that nothing overflows
        fall = mp.exp(-2 * u)
        above = fall * (2 * k * fall + 4 * u * u + 4 * u + 1 + k * k)
        return above / (k * (1 + fall**2) + (4 * u * u + 1 + k * k) * fall)

    first = 2 / mp.pi * mp.quad(lost, [0, 1, 4, mp.inf]) * ratio
    return float(1 + first + mp.mpf(7) / 6 * first**2)


def first_yield(nu: float) -> tuple[float, float]:
    """Greatest shear stress on the axis of Hertz's contact over p_0, and its depth over the contact radius."""

    def shear(z: Any) -> Any:
        along = -1 / (1 + z * z)
        across = -(1 + nu) * (1 - z * mp.acot(z)) + 1 / (2 * (1 + z * z))
        return (across - along) / 2

    depth = mp.findroot(lambda z: mp.diff(shear, z), 0.5)
    return float(shear(depth)), float(depth)


def without_slip(nu: float) -> float:
    """Stiffness of a flat punch that sticks over that of one without friction (Spence 1968)."""
    return float((1 - nu) * mp.log(3 - 4 * nu) / (1 - 2 * nu))


def retraction_at_pull_off() -> float:
    """Retraction over Tabor's number times the range of adhesion, for the paraboloid under given force."""
    return float(mp.sqrt(2 * mp.pi) * (9 * mp.pi / 8) ** (mp.mpf(1) / 6))
