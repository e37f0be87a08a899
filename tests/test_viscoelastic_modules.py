"""Emitted viscoelastic modules against the exact entries at 30 digits."""

from __future__ import annotations

import math

import pytest
import sympy as sp
from physics_package import CLOSED, derived, emitted, exact, keywords, values

from axiderive import notation as nt
from axiderive.code.physics.viscoelastic import kind_and_law
from axiderive.physics.viscoelastic import in_radius
from axiderive.profiles import NAMES, load


@pytest.mark.parametrize("name", NAMES)
def test_viscoelastic_entries(name: str) -> None:
    profile, module = load(name), emitted(f"viscoelastic.{name}")
    for entry in derived()["viscoelastic"][name].values():
        function = getattr(module, entry.quantity.function)
        known = values(profile) | {nt.time: sp.Rational(9, 10), nt.d: sp.Rational(3, 5), nt.F: sp.Rational(1, 2)}
        given = keywords(function, profile, known)
        found = function(*([0.9] if entry.arguments else []), **given)
        back = nt.v_2 in entry.parameters
        if back and entry.arguments:
            early = getattr(module, f"earlier_time_{kind_and_law(entry.quantity)[1].name}")
            known[nt.t_1] = sp.Float(early(0.9, **keywords(early, profile, known)), 30)
        if in_radius(entry):
            inverse = emitted(f"normal.{name}").radius_from_depth
            sunk = float(known[nt.v] * known[nt.t_1 if back else nt.time])
            known[nt.a] = sp.Float(inverse(sunk, **keywords(inverse, profile, known)), 30)
        if entry.status == "closed" and len(entry.cases) == 1:
            assert found == pytest.approx(exact(entry, known), rel=CLOSED, abs=0.0), entry.key
        else:
            assert found > 0.0 or math.isnan(found), entry.key


def test_long_ramp() -> None:
    """m/x - m (m - 1)/x^2 ... for large x = t/tau, where a series in x fails."""
    cone = emitted("viscoelastic.cone")
    given = {"v": 1.0, "theta": 0.3, "E": 1.0, "tau": 1e-3}
    for t in (0.01, 0.0399, 0.0401, 1.0, 1e6):
        x = t / 1e-3
        expected = 2 / x * (1 - (1 - math.exp(-x)) / x) * 2 * t**2 / (math.pi * math.tan(0.3))
        assert cone.ramp_force_maxwell(t, **given) == pytest.approx(expected, rel=1e-14, abs=0.0)
    assert cone.ramp_force_maxwell(0.0, **given) == 0.0
    punch = emitted("viscoelastic.flat_punch")
    assert punch.ramp_force_kelvin_voigt(0.0, v=0.5, a=2.0, E=3.0, eta=0.7) == pytest.approx(2 * 2.0 * 0.5 * 0.7)
