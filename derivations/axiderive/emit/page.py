"""Parts of a page as plain data: rows, check values, calls, derivation, evidence, notation."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..abel import masters
from ..contact.systems import BODIES
from ..entry import Entry
from ..profiles.profile import Profile
from .printer import Printer
from .prose import prose
from .symbols import LETTERS
from .values import Numbers
from .width import width

INSIDE = ("0.1", "0.25", "0.5", "0.75", "0.9", "0.99")
OUTSIDE = ("1.01", "1.25", "1.5", "2", "5", "10")
CHECK_DIGITS = 12
SPECIAL = {
    sp.elliptic_f: "elliptic integrals", sp.elliptic_e: "elliptic integrals", masters.C0: r"$\mathrm C_0$",
    masters.LegendreChi2: r"Legendre's $\chi_2$", masters.ArctanIntegral: r"$\mathrm{Ti}_2$",
    masters.IncompleteBeta: "the incomplete Beta function", masters.StruveH: "Struve functions",
    masters.Dawson: "Dawson's function", sp.gamma: "the Gamma function",
}  # fmt: skip


def spaced(value: Any, digits: int = CHECK_DIGITS) -> str:
    """A number with `digits` decimals in groups of three: 2.993 222 846 126."""
    whole, _, decimals = _rounded(value, digits).partition(".")
    return whole + "." + r"\,".join(decimals[i : i + 3] for i in range(0, len(decimals), 3))


def _rounded(value: Any, digits: int) -> str:
    """Decimal text with exactly `digits` decimals, rounded to nearest."""
    scaled = int(mp.nint(abs(value) * mp.mpf(10) ** digits))
    whole, decimals = divmod(scaled, 10**digits)
    return f"{'-' if value < 0 else ''}{whole}.{decimals:0{digits}d}"


def check_table(profile: Profile, numbers: Numbers) -> dict[str, Any]:
    """Dimensionless values to twelve decimals, at the parameters of the sketch and E_star = 1."""
    with mp.workdps(numbers.digits):
        mean, depth, radius = numbers.mean_pressure, numbers.depth, numbers["a"]
        breaks = [numbers[b.name] / radius for b in profile.breaks]
        inside = [(x, spaced(numbers("p", mp.mpf(x) * radius) / mean)) for x in _off_breaks(INSIDE, breaks)]
        outside = [(x, spaced(numbers("w", mp.mpf(x) * radius) / depth)) for x in OUTSIDE]
        force = "P" if numbers.place("p") == nt.x else r"F_{\mathrm N}"
        heads = [("d", spaced(depth)), (force, spaced(numbers("F"))), (r"\bar p", spaced(mean))]
    shown = [(s, v) for s, v in numbers.values.items() if s != nt.E_star and s not in dict(profile.abbreviations)]
    # the depth of a strip goes with the load, so that of the sketch is none of its parameters
    left_out = (nt.N, nt.d) if force == "P" else (nt.N,)
    where = [f"{_symbol_tex(s)}={_plain(v)}" for s, v in shown if s not in left_out]
    if force == "P":
        where.append("L=2.7\\,a")
    return {
        "place": numbers.place("p").name,
        "where": ", ".join(f"${text}$" for text in where),
        "heads": heads,
        "rows": list(zip(inside, outside, strict=True)),
    }


def _off_breaks(ratios: tuple[str, ...], breaks: list[Any]) -> list[str]:
    """The ratios with those moved on that meet a break, where the pressure may be infinite."""
    return [f"{float(x) + 0.05:g}" if any(abs(mp.mpf(x) - b) < 1e-3 for b in breaks) else x for x in ratios]


def _symbol_tex(symbol: sp.Symbol) -> str:
    return nt.describe(symbol).latex if nt.known(symbol.name) else symbol.name


def _plain(value: Any) -> str:
    return f"{float(value):g}"


MOST_CALLED = ("d", "F", "P", "p", "w", "s", "phi", "E_star", "G_star", "H", "h_N")


def calls(profile_id: str, entries: Mapping[str, Entry]) -> list[str]:
    """How the generated functions are called, one line per function."""
    package, _, name = profile_id.rpartition(".")
    source = "" if name in BODIES.names else f".{package or 'normal'}"
    lines = [f"from axicontact{source} import {name}"]
    for entry in entries.values():
        if entry.suffix in MOST_CALLED:
            fields = [LETTERS.get(s, s.name) for s in entry.quantity.arguments]
            keywords = [LETTERS.get(p, str(getattr(p, "label", p))) for p in entry.parameters]
            arguments = [*fields, *(f"{k}={k}" for k in keywords if k not in fields)]
            lines.append(f"{name}.{entry.quantity.function}({', '.join(arguments)})")
    return lines


PLANE_START = (
    r"A flat strip of half-width $t$ under the load $P$ has the pressure $P/(\pi\sqrt{t^2-x^2})$. A contact grows by "
    r"strips of the load $P'(t)\,\mathrm dt$; pressure, slope and depth are one algebraic integral each."
)
LOAD_START = (
    r"(11.104) gives $w_{\mathrm{1D}}=(p_0 a/E^{*})\,\mathrm B(\frac12,s+1)\,(1-x^2/a^2)^{s+1/2}$; "
    r"(11.105) is then one moment, over $(0,r)$ inside and over $(0,a)$ outside."
)
TILTED_START = (
    r"The strip carries $p=(\alpha+\beta x)/\sqrt{a^2-x^2}$. Load and moment fix $\alpha$ and $\beta$; the contact "
    r"loses the edge at which the pressure vanishes, $|e|=a/2$, and keeps the other."
)


def derivation(profile_id: str, profile: Profile, entries: Mapping[str, Entry]) -> str:
    """Which rule gives what, and which functions it takes."""
    if not entries:
        return ""
    if profile_id == "materials":
        return ""
    if nt.e in profile.parameters:
        return TILTED_START
    if profile_id.startswith("plane."):
        start = PLANE_START
    elif profile_id.startswith("loads."):
        start = LOAD_START
    elif profile.contact == "complete":
        start = (
            r"A flat punch carries $E^{*}d/(\pi\sqrt{a^2-r^2})$ (11.15). With $w_{\mathrm{1D}}=d-g$ "
            r"the edge term of (11.107), "
            r"$E^{*}w_{\mathrm{1D}}(a)/(\pi\sqrt{a^2-r^2})$, remains, because the edge is fixed and $d$ is free."
        )
    else:
        derivative = sp.diff(profile.pieces[-1].expr, nt.r)
        slope = min((Printer()(form) for form in (derivative, sp.factor(derivative))), key=width)
        beyond = f" beyond $r={Printer()(profile.breaks[-1])}$" if profile.breaks else ""
        split = ", split at the break," if profile.breaks else ""
        start = (
            rf"The slope $f'(r)={slope}${beyond} enters the integral (11.29), which{split} gives $g(a)$. "
            r"Exchanging the order of integration leaves one algebraic integral each for $F_{\mathrm N}$ (11.20), "
            r"$p$ (11.23) and $w$ (11.26)."
        )
    needed = _functions(entries)
    open_ends = [e.suffix for e in entries.values() if e.status == "integral"]
    text = start + (f" The results need {_listed(needed)}." if needed else " All results are elementary.")
    if open_ends:
        names = " and ".join(f"${s}(r)$" for s in open_ends)
        text += f" No closed form of {names} in standard functions was found; the integral that remains is regular."
    return text


def _functions(entries: Mapping[str, Entry]) -> list[str]:
    found: list[str] = []
    for entry in entries.values():
        for case in entry.cases:
            for kind, name in SPECIAL.items():
                if case.expr.has(kind) and name not in found:
                    found.append(name)
    return sorted(found)


def _listed(names: list[str]) -> str:
    return names[0] if len(names) == 1 else ", ".join(names[:-1]) + " and " + names[-1]


def evidence_rows(
    profile_id: str, own: Mapping[str, Mapping[str, Entry]], evidence: Mapping[str, Any]
) -> dict[str, list[dict[str, Any]]]:
    """Certificate and checks of every entry; nothing is claimed that is not recorded.

    Those of the problem the spread begins with as a table, the others in short: the fewest digits that agreed.
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
    return {"table": table, "grid": grid}


def _evidence(entry: Entry, record: Mapping[str, Any], measured: Mapping[str, Any], profile_id: str) -> dict[str, Any]:
    passed = [check for check in record.get("checks", []) if check["outcome"] == "passed"]
    by_kind: dict[str, list[Any]] = {kind: [] for kind in KINDS}
    for check in passed:
        by_kind[kind_of(check["compared"])].append(check)
    digits = [check["digits"] for check in passed if check.get("digits")]
    return {
        "suffix": entry.key[len(profile_id) + 1 :],
        "certified": bool(record.get("certified")),
        "cells": [_agreement(by_kind[kind]) for kind in KINDS],
        "evaluation": _evaluation(measured) if measured else [],
        "ruled": measured.get("form") == "rule",
        "digits": str(min(digits)) if digits else "--",
        "count": str(sum(check.get("count", 0) for check in passed if check.get("digits"))),
    }


KINDS = ("quadrature", "enclosure", "identity", "units")


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
                text = prose(reason.replace(f"{entry.key} is ", ""))
                groups.setdefault(text, []).append(entry.key[len(profile_id) + 1 :])
    return [(suffixes, reason) for reason, suffixes in groups.items()]


def _agreement(checks: list[Any]) -> str:
    """Digits / points and the worst residual; the fewest digits / all points of several identities."""
    if not checks:
        return "--"
    counted = [check for check in checks if check.get("digits")]
    if not counted:
        return r"\ok"
    least = min(check["digits"] for check in counted)
    if len(checks) > 1:
        return rf"{least}\,/\,{sum(check['count'] for check in counted)}"
    (check,) = counted
    worst = rf"\enspace${power_of_ten(check['worst'])}$" if check.get("worst") and float(check["worst"]) else ""
    return rf"{least}\,/\,{check['count']}{worst}"


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


def symbols(entries: Mapping[str, Entry]) -> set[str]:
    """Names of the symbols that occur in the rows of a profile."""
    found = {"a", "f", "g", "d", "F"}
    for entry in entries.values():
        printed_symbols = {s.name for case in entry.cases for s in case.expr.free_symbols if isinstance(s, sp.Symbol)}
        found |= printed_symbols | {s.name for s in (entry.quantity.symbol, *entry.quantity.arguments)}
    return found
