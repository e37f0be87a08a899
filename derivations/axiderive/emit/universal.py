"""Adhesion of a power law as one curve: force and depth over those of pull-off, for all parameters."""

from __future__ import annotations

from typing import Any

import sympy as sp

from ..contact import adhesive
from ..contact.medium import GRADED, HOMOGENEOUS, Medium
from ..entry import Entry
from ..notation import a
from .printer import Printer
from .shorthand import LINE
from .width import width

RATIO = sp.Symbol("x", positive=True)
"""a/a_c, the contact radius over that of pull-off under force control."""


def universal_rows(key: str, depth: Entry, graded: bool) -> list[dict[str, Any]]:
    """Rows of an adhesive problem whose depth is one power of the contact radius, one if they fit on a line.

    At pull-off the retraction is 2 n/xi of the depth g, by the condition of
    stationarity, and F_N = n/(n + 1 + k) of stiffness times g.
    """
    exponent = power_of_depth(depth)
    if exponent is None:
        return []
    force, depth_ratio = curve(exponent, GRADED if graded else HOMOGENEOUS)
    ratio = r",\qquad x=\frac{a}{a_{\mathrm c}}"
    found = {
        f"{key}.F": rf"\frac{{F_{{\mathrm{{adh}}}}}}{{F_{{\mathrm c}}}}={force}",
        f"{key}.d": rf"\frac{{d_{{\mathrm{{adh}}}}}}{{d_{{\mathrm c}}}}={depth_ratio}",
    }
    joined = r",\qquad ".join(found.values()) + ratio
    if width(joined) <= LINE:
        return [_row(" ".join(found), joined)]
    return [_row(key, text + ratio) for key, text in found.items()]


def _row(keys: str, tex: str) -> dict[str, Any]:
    return {
        "half": False,
        "comment": f"universal {keys}",
        "label": "Universal curve",
        "small": "",
        "tex": tex,
        "remark": "",
    }


def power_of_depth(depth: Entry) -> sp.Expr | None:
    """n of g = c a**n."""
    if depth.status != "closed" or len(depth.cases) != 1:
        return None
    base, exponent = depth.cases[0].expr.as_independent(a, as_Add=False)[1].as_base_exp()
    return exponent if base == a else None


def curve(n: sp.Expr, medium: Medium) -> tuple[str, str]:
    """F/F_c and d/d_c over x = a/a_c as LaTeX."""
    xi, k, whole = adhesive.pull_off_number(medium)["force"], medium.k, n + 1 + medium.k
    pulled = [_power((3 + k) / 2), _power((1 - k) / 2)]
    force = _quotient(2, whole, pulled[0], xi, RATIO**whole, sp.expand(2 * whole - xi))
    depth = _quotient(2, n, pulled[1], xi, RATIO**n, sp.expand(2 * n - xi))
    return force, depth


def _power(exponent: sp.Expr) -> sp.Expr:
    """A power of x that keeps the sign of its exponent in print."""
    if exponent.is_Integer or exponent == sp.S.Half:
        return RATIO**exponent
    above, below = sp.fraction(sp.together(exponent))
    top = f"({Printer()(above)})" if above.is_Add else Printer()(above)
    return sp.Symbol(f"x^{{{top}/{below}}}", positive=True)


def _quotient(number: int, factor: sp.Expr, pulled: sp.Expr, xi: sp.Expr, elastic: sp.Expr, below: sp.Expr) -> str:
    """(number factor pulled - xi elastic)/below, with plain numbers divided."""
    if below.is_number:
        return Printer(names=_names(pulled))(number * factor / below * pulled - xi / below * elastic)
    names = _names(pulled)
    shares = [sp.cancel(part / below) for part in (number * factor, xi)]
    if all(share.is_number for share in shares):
        return Printer(names=names)(shares[0] * pulled - shares[1] * elastic)
    if factor.is_Add:  # 2 (k + 2) is read better than 2 k + 4
        whole = sp.Symbol("whole", positive=True)
        names[whole] = f"({Printer()(factor)})"
        factor = whole
    if below.xreplace({GRADED.k: sp.S.Zero}).is_negative:
        number, xi, below = -number, -xi, -below
    return rf"\frac{{{Printer(names=names)(number * factor * pulled - xi * elastic)}}}{{{Printer()(below)}}}"


def _names(pulled: sp.Expr) -> dict[sp.Symbol, str]:
    return {pulled: pulled.name} if isinstance(pulled, sp.Symbol) else {}
