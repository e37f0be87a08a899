"""Partial slip on the graded half-space, where the stick radius is close to the contact radius."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
import sympy as sp
from graded_modules import derived, emitted, keywords, values

from axiderive import notation as nt
from axiderive.profiles import COMPACT_NAMES, load
from axiderive.profiles.profile import Profile
from axiderive.stable.measure import ulps
from axiderive.stable.reference import enclosed

EXPONENTS = ("-0.9", "0.3")
GAPS = (1e-3, 1e-9, 2.0**-45)
"""1 - c/a, down to a few units of the last place of a."""
GRADED = 45.0
"""Units of the last place: 1e-14."""
PARTS = 4e-15
"""Of the sum of two gains; the largest deviation found is 1.3e-15."""
FUNCTIONS = ("traction", "tangential_force", "tangential_displacement")


@pytest.mark.parametrize("k", EXPONENTS)
@pytest.mark.parametrize("name", ["cone", "power_law", "capped_paraboloid", "truncated_paraboloid"])
def test_close_to_full_stick(name: str, k: str) -> None:
    """The closed formulas, for the doubles as they are given."""
    profile, entries = load(name), derived("tangential", name)
    known = {symbol: float(value) for symbol, value in values(profile, k).items()}
    for entry in (entries[suffix] for suffix in ("F", "u", "tau") if suffix != "tau" or name in ("cone", "power_law")):
        function = getattr(emitted(f"tangential.{name}"), entry.quantity.function)
        for gap in GAPS:
            point = known | {nt.c: known[nt.a] * (1.0 - gap), nt.r: known[nt.a] * (1.0 - gap) * 0.9}
            found = function(
                *(point[symbol] for symbol in entry.quantity.arguments), **keywords(function, profile, point)
            )
            assert ulps(found, enclosed(entry, point, ())) <= GRADED, (entry.key, gap)


@pytest.mark.parametrize("k", EXPONENTS)
@pytest.mark.parametrize("name", COMPACT_NAMES)
def test_gains_add_up(name: str, k: str) -> None:
    """From c to a is from c to m and from m to a, which a difference keeps to the first digits alone."""
    profile, known, module = load(name), values(load(name), k), emitted(f"tangential.{name}")
    a = float(known[nt.a])
    for function in FUNCTIONS:
        for gap in GAPS:
            gain = _gain(getattr(module, function), 0.9 * a, profile, known)
            assert 0.0 < gain(a * (1.0 - gap / 4.0), a) < gain(a * (1.0 - gap), a * (1.0 - gap / 4.0))
            _assert_parts(gain, a * (1.0 - gap), a * (1.0 - gap / 4.0), a)


@pytest.mark.parametrize("k", EXPONENTS)
@pytest.mark.parametrize("name", ["rounded_cone", "capped_paraboloid", "rounded_curved_punch", "sphere_tipped_cone"])
def test_gains_add_up_across_a_break(name: str, k: str) -> None:
    profile, known, module = load(name), values(load(name), k), emitted(f"tangential.{name}")
    b = float(sp.sympify(profile.breaks[0]).subs(known))
    for function in FUNCTIONS:
        for gap in GAPS:
            gain = _gain(getattr(module, function), 0.9 * b, profile, known)
            _assert_parts(gain, b * (1.0 - gap), b, b * (1.0 + gap))


def _assert_parts(gain: Callable[[float, float], float], c: float, m: float, a: float) -> None:
    assert gain(c, m) + gain(m, a) == pytest.approx(gain(c, a), rel=PARTS, abs=0.0), (c, m, a)


def _gain(
    function: Callable[..., float], r: float, profile: Profile, known: dict[sp.Symbol, Any]
) -> Callable[[float, float], float]:
    given = keywords(function, profile, known)
    place = (r,) if function.__name__ == "traction" else ()
    return lambda c, a: function(*place, a, c, **given)
