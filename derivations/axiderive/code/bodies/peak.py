"""The greatest pressure as a function of its own: one call, the pressure and its radius."""

from __future__ import annotations

from collections.abc import Mapping

from ...entry import Entry
from ...physics.medium import HOMOGENEOUS
from ...stable.signs import facts_of
from ..private import PrivateFunctions
from ..text import python
from .compact import Compact

RADIUS = "peak_radius"
"""The private function of the radius; that of the pressure bears the name of the public one."""
RESULT = "PeakPressure"


def bodies(compact: Compact, functions: PrivateFunctions, entries: Mapping[str, Entry]) -> None:
    """The private functions of both results, where the profile has them."""
    if "rp" not in entries:
        return
    if entries["rp"].status == "root":
        _beyond(compact, functions, entries["pp"].quantity.function)
        return
    for suffix, name in (("rp", RADIUS), ("pp", entries["pp"].quantity.function)):
        (case,) = entries[suffix].cases
        form = functions.form(entries[suffix], case.expr, facts_of(case.chain))
        functions.add(name, ("a",), functions.returned(form), functions.needs(form, ("a",)))


def _beyond(compact: Compact, functions: PrivateFunctions, name: str) -> None:
    """By the share of the rounding that the radius lies in, which says more than the radius next to a = b."""
    b, slope, (condition, _) = str(compact.b), compact.slopes["beyond"][0], compact.domain()
    within = f"np.where({condition}, {{}}, np.nan)"
    ring = f"{b} + (a - {b}) * peak_share(a, {b})"
    functions.add(RADIUS, ("a",), [f"return {within.format(ring)}"], {b})
    growth = f"peak_integral_beyond({slope.with_parameters()}, peak_share(a, {b}), a, {b})"
    value = within.format(f"{python(HOMOGENEOUS.pressure_scale)} * growth")
    functions.add(name, ("a",), [f"growth = {growth}", f"return {value}"], {"E_star", b, *slope.needs})
