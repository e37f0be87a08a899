"""Check values of what has no profile: prescribed pressures, and the punch that an eccentric load tilts."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Entry
from ..profiles.loads import Load
from ..profiles.profile import Profile
from .given import Strip
from .page import INSIDE, OUTSIDE, spaced
from .values import Numbers, Values

POWER, ECCENTRICITY = sp.Integer(2), sp.Rational(3, 10)
"""Of the tables: the exponent of a pressure, the place of a load over the half-width."""


def given_table(profile: Profile, entries: Mapping[str, Entry]) -> dict[str, Any]:
    """Dimensionless values to twelve decimals, at unit lengths and loads."""
    return _pressed(profile, entries) if isinstance(profile, Load) else _tilted(profile, entries)


def _pressed(load: Load, entries: Mapping[str, Entry]) -> dict[str, Any]:
    """The displacement inside and outside the circle."""
    values: Values = {nt.a: sp.S.One, nt.p_0: sp.S.One, nt.E_star: sp.S.One, nt.sigma: POWER}
    numbers = Numbers(load, entries, values)
    with mp.workdps(numbers.digits):
        force = mp.pi / (1 + mp.mpf(str(sp.sympify(load.exponent).subs(nt.sigma, POWER).evalf(numbers.digits))))
        inside, outside = ([(x, spaced(numbers("w", mp.mpf(x)))) for x in places] for places in (INSIDE, OUTSIDE))
    free = [f"$s={POWER}$"] if nt.sigma in load.parameters else []
    return {
        "place": "r",
        "where": ", ".join(["$a=1$", "$p_0=1$", *free]),
        "heads": [(r"F_{\mathrm N}", spaced(force))],
        "columns": ((r"w E^{*}/(p_0 a)", "w"),) * 2,
        "rows": list(zip(inside, outside, strict=True)),
    }


def _tilted(profile: Profile, entries: Mapping[str, Entry]) -> dict[str, Any]:
    """The pressure over its mean on either side of the middle, before an edge lifts off."""
    values: Values = {nt.a: sp.S.One, nt.P: sp.Integer(2), nt.E_star: sp.S.One, nt.e: ECCENTRICITY}
    numbers = Strip(profile, entries, values)
    with mp.workdps(numbers.digits):
        left, right = ([(s + x, spaced(numbers("p", mp.mpf(s + x)))) for x in INSIDE] for s in ("-", ""))
        tilt = numbers("phi")
    return {
        "place": "x",
        "where": f"$a=1$, $P=2$, $e={float(ECCENTRICITY):g}$",
        "heads": [(r"\varphi", spaced(tilt)), (r"\bar p", spaced(mp.mpf(1)))],
        "columns": ((r"p/\bar p", "p"),) * 2,
        "rows": list(zip(left, right, strict=True)),
    }
