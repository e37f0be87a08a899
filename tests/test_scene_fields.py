"""Scenes of fields below the surface: modules with the values of the definitions, and with nothing else."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest
from scenes import composed_from, exchanged, problems, run_plainly

from axiderive.exits import CommandError

BALL = 'profile = "paraboloid"\n[parameters]\nR = "10 mm"\n[medium]\nE = "210 GPa"\nnu = 0.3\n'
FRICTION = "[physics]\nsubsurface = { mu = 0.2 }\n"
EVERYTHING = (
    "stress", "displacement", "surface_stress", "surface_displacement", "sliding_stress", "partial_slip_stress",
    "greatest_von_mises", "greatest_shear", "add", "hydrostatic", "principal", "tresca", "von_mises", "pressure",
)  # fmt: skip


def wanted(*names: str, language: str = "python") -> str:
    output = f'[output]\nlanguage = "{language}"\nformats = ["{language}", "json"]\n'
    return f"[want]\nquantities = {json.dumps(names)}\n{output}"


def module(text: bytes) -> dict[str, object]:
    space: dict[str, object] = {"__name__": "scene"}
    exec(compile(text, "scene.py", "exec"), space)
    return space


def test_all_functions_below_a_ball(tmp_path):
    """The greatest values of Hertz are 0.3100 p_0 and 0.6200 p_0, 0.481 a below the axis."""
    result = composed_from(BALL + FRICTION + wanted(*EVERYTHING))
    assert run_plainly(result, tmp_path) == "23 values agree\n"
    errors = json.loads(result.files["evidence.json"])["module against 20-digit quadrature"]
    assert set(errors) == set(EVERYTHING)
    assert max(map(float, errors.values())) < 1e-14
    space = module(result.files["scene.py"])
    p_0 = 2 * 210e9 / 0.91 * 1e-3 / (math.pi * 10e-3)
    shear, mises = space["greatest_shear"](1e-3), space["greatest_von_mises"](1e-3)
    assert (shear.value / p_0, shear.z / 1e-3) == pytest.approx((0.31, 0.481), abs=5e-4)
    assert mises.value == pytest.approx(2 * shear.value, rel=1e-12)
    many = space["stress"](np.array([[1e-4], [-1.0]]), np.array([0.0, 1e-4, 1.0]), 1e-3)
    assert many.zz.shape == (2, 3)
    assert np.isnan(many.zz[1]).all()
    assert -many.zz[0, 0] == pytest.approx(space["pressure"](1e-4, 1e-3), rel=1e-14)
    with pytest.raises(TypeError, match="is no bare number; give z.to"):
        space["stress"](0.0, np.ma.masked_array([1.0]), 1e-3)


def test_a_module_has_only_what_is_asked_for_at_a_depth_too():
    """The centre of a contact sinks by the depth at which the normal contact has its radius."""
    asked = wanted("displacement", "radius_from_depth").replace("[want]", '[want]\nat = { d = "0.1 mm" }')
    text = composed_from(BALL + FRICTION + asked).files["scene.py"].decode()
    assert "Example: at d = 0.0001 m it is a = 0.001 m, F = 30769.23 N." in text
    space = module(text.encode())
    assert space["displacement"](0.0, 0.0, space["radius_from_depth"](1e-4)).z == pytest.approx(1e-4, rel=1e-14)
    assert not [
        name for name in ("FRICTION", "SlidingStress", "greatest", "E_star", "mu =", "EXP", "COSH") if name in text
    ]
    assert max(map(len, text.splitlines())) <= 120


def test_a_wrong_slope_is_not_emitted(monkeypatch):
    right = "tip = Piece(PLAIN, 0.0, a, polynomial, (0.0, 2 / R))"
    exchanged(monkeypatch, "subsurface/paraboloid.py", right, right.replace("2 / R", "2.00001 / R"))
    with pytest.raises(CommandError, match=r"stress\(.* gives Stress\(.* instead of"):
        composed_from(BALL + FRICTION + wanted("stress"))


def test_a_place_that_is_not_the_greatest_is_not_emitted(monkeypatch):
    from axiderive.scene.linker import library

    zoom = library.RUN_TIME["_runtime.subsurface.stresses"].definitions["ZOOMS"]
    monkeypatch.setattr(zoom.node.value, "value", 2)
    with pytest.raises(CommandError, match="greatest_shear"):
        composed_from(BALL + FRICTION + wanted("greatest_shear"))


@pytest.mark.parametrize(
    "profile",
    [
        "flat_punch",
        pytest.param("capped_cylinder", marks=pytest.mark.slow),
        pytest.param("truncated_cone", marks=pytest.mark.slow),
        pytest.param("power_law", marks=pytest.mark.slow),
        pytest.param("r**2/(2*R) + q*r**4", marks=pytest.mark.slow),
    ],
)
def test_free_parameters_edges_breaks_and_powers(profile, tmp_path):
    """Where the pressure is infinite so is the greatest stress."""
    source = f'profile = "{profile}"\n[physics]\nsubsurface = true\n'
    result = composed_from(source + wanted("stress", "sliding_stress", "greatest_shear", "von_mises"))
    assert "values agree" in run_plainly(result, tmp_path)
    stress = module(result.files["scene.py"])["stress"]
    given = {"flat_punch": {"a": 1.0}, "capped_cylinder": {"a": 1.0, "R": 2.0}}.get(profile)
    if given:
        assert stress(0.5, 0.3, 0.1, E_star=1.0, nu=0.5, **given).zz < 0.0
        with pytest.raises(ValueError, match="nu = 0.51 is outside"):
            stress(0.5, 0.3, 0.1, E_star=1.0, nu=0.51, **given)


@pytest.mark.slow
def test_the_greatest_stress_next_to_the_surface(tmp_path):
    """Seven times that of the axis, 31 um below the edge of the face; the waves of the definition do not reach it."""
    source = 'profile = "rounded_punch"\n[parameters]\nR = "2 mm"\nb = "5 mm"\n[medium]\nE = "210 GPa"\nnu = 0.3\n'
    result = composed_from(source + "[physics]\nsubsurface = true\n" + wanted("greatest_von_mises"))
    assert run_plainly(result, tmp_path) == "1 values agree\n"


def test_what_has_no_program_says_so():
    for names in (("stress",), ("force", "von_mises")):
        with pytest.raises(CommandError, match=f"{names[-1]}: no program in c .* go over arrays.*; write language"):
            composed_from(BALL + FRICTION + wanted(*names, language="c"))


@pytest.mark.parametrize(
    ("source", "message"),
    [
        ("[physics]\nsubsurface = { nu = 0.4 }\n", "nu stands below [medium] already; leave it out of subsurface"),
        ("[physics]\nsubsurface = { phi = 1 }\n", "unknown key 'phi' of subsurface; there are nu, mu"),
        ('[want]\nquantities = ["stress"]\n', "stress is a function of subsurface contact; write [physics] subsurface"),
    ],
)
def test_what_is_wrong_is_said(source, message):
    assert message in problems(BALL + source)


def test_an_expression_whose_depth_has_no_rate_is_refused():
    for expression, reason in (
        ("r**2/sqrt(r**2 + q**2)", "no atom is known for it; the nearest is normal = true"),
        ("q*r**2 + Max(0, r - b)*tan(theta)", "an expression without breaks"),
    ):
        assert reason in problems(f'profile = "{expression}"\n[physics]\nsubsurface = true\n')
