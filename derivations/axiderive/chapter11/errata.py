"""What the checks of chapter 11 leave for the evidence and the handbook: errata as they show them, as plain data."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import mpmath as mp

from .equation import FORCE, GUARD, LENGTH, STRESS, Draw, Residual, Row, agreed, equations
from .first_principles import steps
from .graded_punch import exponent
from .quadrature import even_pressure, kappa, panels, pressure, rings, singular, total_force
from .round_trip import edge_pressure

ZERO, HALF = mp.mpf(0), mp.mpf(1) / 2


@dataclass(frozen=True)
class Remark:
    """A slip of the text, or a condition it leaves unsaid; `check` shows the right form to hold where there is one."""

    place: str
    printed: str
    right: str
    reason: str
    check: Callable[[Draw], Iterator[Residual]] | None = None


def agreement(remark: Remark, digits: int, seed: int) -> int:
    """Digits to which the right form of a remark with a check holds at random parameters."""
    assert remark.check
    with mp.workdps(digits + GUARD):
        return agreed(max(x.relative() for x in remark.check(Draw(f"{seed}:{remark.place}"))), digits + GUARD)


def _edge_pressure(draw: Draw) -> Iterator[Residual]:
    """Flat punch of depth d plus the contact of g: w1D(a) = d; pressure and displacement."""
    g, a, E_star, extra = draw.even_sum(2), draw.length(), draw.stress(), draw.length()
    r = a * draw.number(0.2, 0.9)
    inner = -E_star / mp.pi * singular(lambda x: -g.slope(x) / mp.sqrt(x**2 - r**2), r, a)
    both = edge_pressure(extra, r, a, E_star) + inner
    yield Residual(E_star * extra / mp.pi / mp.sqrt(a**2 - r**2) + pressure(g, r, a, E_star), both, STRESS)
    moved = rings(lambda t: edge_pressure(extra, t, a, E_star) + even_pressure(g, t, a, E_star), ZERO, a, E_star)
    yield Residual(moved, extra + g(a), LENGTH)


def _edge_force(draw: Draw) -> Iterator[Residual]:
    g, a, E_star, extra = draw.even_sum(2), draw.length(), draw.stress(), draw.length()
    force = total_force(lambda t: edge_pressure(extra, t, a, E_star) + even_pressure(g, t, a, E_star), a)
    by_parts = 2 * E_star * a * extra - 2 * E_star * singular(lambda x: -x * g.slope(x), ZERO, a)
    yield Residual(force, by_parts, FORCE)
    yield Residual(force, 2 * E_star * singular(lambda x: extra + g(a) - g(x), ZERO, a), FORCE)


def _jump(draw: Draw) -> Iterator[Residual]:
    """(11.60) applied to the depth of random powers with a step at b returns the stepped profile."""
    f, a, step, k = draw.power_sum(), draw.length(), draw.length(), exponent(draw)
    b = a * draw.number(0.3, 0.7)
    smooth = f.times(lambda n: kappa(n, k))

    def depth(x: Any) -> Any:
        stepped = step * x ** (1 - k) * ((x - b) * (x + b)) ** ((k - 1) / 2) if x > b else ZERO
        return smooth(x) + stepped

    strongest = max(float(1 - k), float(1 + k)) / 2
    back = panels(lambda x: x**k * depth(x) / (a**2 - x**2) ** ((1 + k) / 2), ZERO, a, (b,), strongest)
    yield Residual(f(a) + step, 2 * mp.cos(k * mp.pi / 2) / mp.pi * back, LENGTH)


REMARKS = (
    Remark(
        "Before (11.102)",
        "rho and xi uniquely define the location of point B",
        "rho and xi belong to two points of the chord, at the same distance rho from the centre",
        "This is why (11.102) needs both signs",
    ),
    Remark(
        "(11.107)",
        "p(rho) = -E*/pi int_rho^a w1D'(xi)/sqrt(xi^2 - rho^2) dxi",
        "p(rho) = E*/pi [w1D(a)/sqrt(a^2 - rho^2) - int_rho^a w1D'(xi)/sqrt(xi^2 - rho^2) dxi]",
        "The printed form holds where w1D(a) = 0. This does not follow from (11.104) for every pressure, as is said "
        "after (11.109): under flat or concave punches, and with adhesion, w1D(a) is not zero",
        _edge_pressure,
    ),
    Remark(
        "(11.110), third line",
        "-2 E* int_0^a xi w1D'(xi) dxi = 2 E* int_0^a w1D(xi) dxi",
        "2 E* a w1D(a) - 2 E* int_0^a xi w1D'(xi) dxi = 2 E* int_0^a w1D(xi) dxi",
        "The printed form holds where w1D(a) = 0, its right-hand side always",
        _edge_force,
    ),
    Remark(
        "(11.29) and (11.61)",
        "g(a) as an integral of f' alone",
        "a step of height D in f at r = b adds D a^(1-k) (a^2 - b^2)^((k-1)/2) for a > b, with k = 0 in (11.29)",
        "The text does not say that f is taken to start at zero and to be absolutely continuous",
        _jump,
    ),
    Remark(
        "Section 11.8.1",
        "the modulus m = k^2; F and K for 0 <= k^2 <= 1 and 0 <= theta <= pi/2",
        "the parameter m = k^2; F and K without k = 1 together with theta = pi/2",
        "The modulus is k itself, and F(pi/2, 1) = K(1) is infinite",
    ),
    Remark(
        "(11.86), (11.93), (11.97)",
        "the upper Gamma function for Re z > 0; the series of 2F1 and H_n for all arguments",
        "every z; abs(z) < 1, and c neither zero nor a negative integer; a branch cut where n is not an integer",
        "The first range is too narrow, the others are too wide",
    ),
    Remark(
        "(11.34)-(11.39)",
        "pressured ring",
        "loaded disc",
        "The load covers the whole circle r < a",
    ),
    Remark(
        "Closing paragraph of 11.9",
        "flat punch with axisymmetric load, among the plane problems",
        "flat punch with asymmetric, that is eccentric, load",
        "Plane problems have no axis, and the symmetric load is named just before",
    ),
)


def record(rows: Iterable[Row], digits: int = 30, seed: int = 11) -> dict[str, Any]:
    """What `equation.run` found, the errata those rows show, and the exact steps from the point load to the punch.

    Returns
    -------
    dict
        JSON-able: the digits demanded, the seed, `rows` (an equation each), `errata` (place, printed, right,
        reason, evidence: misprints, then slips of the text) and `steps` (equations, claim, holds).
    """
    rows = tuple(rows)
    misprints = [_misprint(row) for row in rows if row.verdict == "misprint"]
    return {
        "digits": digits,
        "seed": seed,
        "rows": [_row(row) for row in rows],
        "errata": [*misprints, *(_slip(remark, digits, seed) for remark in REMARKS)],
        "steps": [{"equations": step.equations, "claim": step.claim, "holds": step.holds()} for step in steps()],
    }


def failures(found: Mapping[str, Any]) -> list[str]:
    """What of a record does not hold, one sentence each."""
    wrong = [f"({row['name']}) {row['title']}" for row in found["rows"] if row["verdict"] == "fails"]
    return wrong + [f"{step['equations']}: {step['claim']}" for step in found["steps"] if not step["holds"]]


def _row(row: Row) -> dict[str, Any]:
    """The residual is that of the form that holds; that of a misprint stands beside it."""
    misprint = row.verdict == "misprint"
    return {
        "name": row.name,
        "title": row.title,
        "verdict": row.verdict,
        "digits": row.digits(),
        "residual": f"{(row.corrected or row.printed).residual():.1e}",
        "as_printed": f"{row.printed.values:.1e}" if misprint else "",
        "right_form": row.right_form if misprint else "",
    }


def _misprint(row: Row) -> dict[str, str]:
    own = equations()[row.number]
    units = ", and it scales wrongly with the units" if (row.printed.units or 0) > 1e-3 else ""
    shown = (
        f"{row.title}: printed form off by a relative {row.printed.values:.2g}{units}; "
        f"right form holds to {row.digits()} digits"
    )
    return _erratum(f"({row.name})", own.printed_form, own.right_form, own.reason, shown)


def _slip(remark: Remark, digits: int, seed: int) -> dict[str, str]:
    shown = ""
    if remark.check:
        found = agreement(remark, digits, seed)
        shown = f"right form holds to {found} digits"
        if found < digits:
            message = f"{remark.place}: the right form agrees to {found} digits only, {digits} were asked for"
            raise ArithmeticError(message)
    return _erratum(remark.place, remark.printed, remark.right, remark.reason, shown)


def _erratum(place: str, printed: str, right: str, reason: str, evidence: str) -> dict[str, str]:
    return {"place": place, "printed": printed, "right": right, "reason": reason, "evidence": evidence}
