"""The greatest pressure as a function of its own: one call, the pressure and its radius."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from ...entry import Entry
from ...notation import a, r_peak
from ...physics.medium import HOMOGENEOUS
from ...physics.peak import stretch_of_arc
from ...stable.signs import facts_of
from ..private import PrivateFunctions
from ..text import python
from .compact import Compact

RADIUS = "peak_radius"
"""The private function of the radius; that of the pressure bears the name of the public one."""
RESULT = "PeakPressure"


def bodies(compact: Compact, functions: PrivateFunctions, entries: Mapping[str, Entry]) -> None:
    """The private functions of both results, where the profile has them."""
    ring, greatest = entries.get("rp"), entries.get("pp")
    if ring is None or greatest is None:
        return
    if ring.status == "root":
        build = _of_arc if stretch_of_arc(ring.profile) else _beyond if compact.b else _of_power
        build(compact, functions, greatest)
        return
    if all(case.expr == 0 for case in ring.cases):
        condition = compact.domain()
        nothing = f"np.where({condition}, 0.0, np.nan)" if condition else "np.zeros_like(a)"
        functions.add(RADIUS, ("a",), [f"return {nothing}"])
        middle = functions["pressure"].call("np.zeros_like(a)", "a")
        functions.add(greatest.quantity.function, ("a",), [f"return {middle}"])
        return
    for entry, name in ((ring, RADIUS), (greatest, greatest.quantity.function)):
        (case,) = entry.cases
        form = functions.form(entry, case.expr, facts_of(case.chain))
        functions.add(name, ("a",), functions.returned(form))


def _of_power(compact: Compact, functions: PrivateFunctions, entry: Entry) -> None:
    """By what is left of a**2 outside the ring, which says more than the radius next to the edge."""
    functions.add(RADIUS, ("a",), ["return a * ring_of_greatest_pressure(n)"])
    rise = sp.Symbol("rise", positive=True)
    (case,) = entry.cases
    expr = case.expr.subs(r_peak, a * sp.sqrt(1 - 1 / rise**2))
    form = functions.form(entry, expr, facts_of(case.chain))
    *lines, value = functions.returned(form)
    lines += ["rise = rise_to_greatest_pressure(n)", f"greatest = {value.removeprefix('return ')}"]
    functions.add(entry.quantity.function, ("a",), [*lines, "return np.where(n > 1.0, greatest, np.inf)"])


def _of_arc(compact: Compact, functions: PrivateFunctions, entry: Entry) -> None:
    """By the angles artanh(a/R) and artanh(u) of equal levels, which say more than the radii next to the edge."""
    (case,), stretch = entry.cases, stretch_of_arc(entry.profile)
    within = f"np.where({compact.domain()}, {{}}, np.nan)"
    place = f"(a, {case.chain[-1]})"
    functions.add(RADIUS, ("a",), [f"return {within.format(f'arc_peak_radius{place}')}"])
    greatest = f"{python(HOMOGENEOUS.pressure_scale * stretch)} * arc_peak_pressure{place}"
    functions.add(entry.quantity.function, ("a",), [f"return {within.format(greatest)}"])


def _beyond(compact: Compact, functions: PrivateFunctions, entry: Entry) -> None:
    """By the share of the rounding that the radius lies in, which says more than the radius next to a = b."""
    name = entry.quantity.function
    b, slope, condition = compact.b, compact.slopes["beyond"][0], compact.domain()
    # without an edge ring and pressure have no bound, which the product of nothing and infinity does not say
    within = f"np.where({condition}, np.where(a < np.inf, {{}}, a), np.nan)"
    ring = f"{b} + (a - {b}) * peak_share(a, {b})"
    functions.add(RADIUS, ("a",), [f"return {within.format(ring)}"])
    growth = f"peak_integral_beyond({slope.with_parameters()}, peak_share(a, {b}), a, {b})"
    value = within.format(f"{python(HOMOGENEOUS.pressure_scale)} * growth")
    functions.add(name, ("a",), [f"growth = {growth}", f"return {value}"])
