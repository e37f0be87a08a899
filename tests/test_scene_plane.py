"""Scenes of plane contact: strips on both sides of the middle, against the integrals that define them."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest
from scenes import NO_PDF, composed_from, exchanged, run_plainly, titles

from axiderive.profiles.plane import load

PLANE = 'profile = "{}"\n{}[physics]\nplane = true\n'
FAST = ("truncated_wedge", "concave_quartic")
SLOW = ("wedge", "flat_punch", "power_law", "rounded_wedge", "rounded_punch", "concave_power")
PROFILES = [*FAST, *(pytest.param(name, marks=pytest.mark.slow) for name in SLOW)]
WORST = 1e-14
"""Relative; measured 6e-16 at worst."""


@pytest.mark.parametrize("profile", PROFILES)
def test_the_module_agrees_with_the_definition_and_its_test_runs(profile, tmp_path):
    result = composed_from(PLANE.format(profile, "") + NO_PDF)
    evidence = json.loads(result.files["evidence.json"])
    errors = {name: float(error) for name, error in evidence["module against 20-digit quadrature"].items()}
    assert {"pressure", "slope", "depth"} <= set(errors)
    assert ("load" in errors) == (load(profile).contact == "compact")
    assert max(errors.values()) < WORST
    assert "values agree" in run_plainly(result, tmp_path)
    page = result.files[f"profiles/plane.{profile}.tex"]
    assert titles(page) == ["Plane contact"]
    assert f"profiles/plane.{profile}".encode() in result.files["page.tex"]
    assert b"place across the contact" in result.files["page.tex"]
    assert b"indentation depth of the point" not in result.files["page.tex"]


def test_frozen_values_are_folded_in_and_fields_have_two_sides():
    frozen = '[parameters]\nR = "10 mm"\n[medium]\nE = "210 GPa"\nnu = 0.3\n'
    source = PLANE.format("parabola", frozen) + '[want]\nquantities = ["pressure", "slope"]\n'
    text = composed_from(source + NO_PDF).files["scene.py"].decode()
    assert "def _load" not in text
    assert "R = 0.01  # radius of curvature [m]" in text
    space: dict[str, object] = {}
    exec(text, space)
    x = np.array([-2e-4, 2e-4])
    pressure, slope = space["pressure"](x, 1e-4), space["slope"](x, 1e-4)
    assert pressure.tolist() == [0.0, 0.0]
    assert slope[0] == -slope[1] > 0.0
    modulus = 210e9 / (1 - 0.3**2)
    assert space["pressure"](-5e-5, 1e-4) == pytest.approx(modulus * math.sqrt(0.75) * 1e-4 / 0.02, rel=1e-14, abs=0.0)
    assert math.isnan(space["pressure"](0.0, -1.0))
    assert math.isnan(space["slope"](math.nan, 1.0))


@pytest.mark.parametrize(
    ("right", "wrong"),
    [
        ("return E_star * np.tan(theta) * a", "return E_star * np.sin(theta) * a"),
        pytest.param("np.log1p((a - x + root) / x)", "np.log1p((a - x + root) / a)", marks=pytest.mark.slow),
        ("value, -_profile_slope(", "value, _profile_slope("),
        pytest.param("a * np.log1p((L - a + root) / a)", "a * np.log1p((L - a + root) / L)", marks=pytest.mark.slow),
    ],
)
def test_a_wrong_rule_does_not_pass(right, wrong, monkeypatch):
    exchanged(monkeypatch, "plane/wedge.py", right, wrong)
    with pytest.raises(ArithmeticError, match="instead of"):
        composed_from(PLANE.format("wedge", "") + NO_PDF)
