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
from .page import INSIDE, OUTSIDE, values_table
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
    free = [f"s={POWER}"] if nt.sigma in load.parameters else []
    with mp.workdps(numbers.digits):
        force = mp.pi / (1 + mp.mpf(str(sp.sympify(load.exponent).subs(nt.sigma, POWER).evalf(numbers.digits))))
        sides = [[(x, numbers("w", mp.mpf(x))) for x in places] for places in (INSIDE, OUTSIDE)]
        columns = [(r"w E^{*}/(p_0 a)", "w")] * 2
        return values_table("r", ["a=1", "p_0=1", *free], [(r"F_{\mathrm N}", force)], columns, *sides)


def _tilted(profile: Profile, entries: Mapping[str, Entry]) -> dict[str, Any]:
    """The pressure over its mean on either side of the middle, before an edge lifts off."""
    values: Values = {nt.a: sp.S.One, nt.P: sp.Integer(2), nt.E_star: sp.S.One, nt.e: ECCENTRICITY}
    numbers = Strip(profile, entries, values)
    with mp.workdps(numbers.digits):
        heads = [(r"\varphi", numbers("phi")), (r"\bar p", mp.mpf(1))]
        sides = [[(s + x, numbers("p", mp.mpf(s + x))) for x in INSIDE] for s in ("-", "")]
        where = ["a=1", "P=2", f"e={float(ECCENTRICITY):g}"]
        return values_table("x", where, heads, [(r"p/\bar p", "p")] * 2, *sides)
