"""Scenes of prescribed pressures, against the quadrature of their definition."""

from __future__ import annotations

import json

import pytest
from scenes import NO_PDF, composed_from, exchanged, problems, run_plainly, titles

LOADS = 'profile = "{}"\n{}[physics]\nloads = true\n'
WORST = 1e-14
"""Relative; measured 2.4e-16 at worst."""


@pytest.mark.parametrize("load", ["uniform", "hertzian", "punch", "power"])
def test_the_module_agrees_with_the_definition_and_its_test_runs(load, tmp_path):
    result = composed_from(LOADS.format(load, "") + NO_PDF)
    evidence = json.loads(result.files["evidence.json"])
    errors = {name: float(error) for name, error in evidence["module against 20-digit quadrature"].items()}
    assert set(errors) == {"displacement"}
    assert max(errors.values()) < WORST
    assert run_plainly(result, tmp_path) == "3 values agree\n"
    assert titles(result.files[f"profiles/loads.{load}.tex"]) == ["Displacement"]


def test_frozen_values_are_folded_in():
    frozen = '[parameters]\na = "2 mm"\np_0 = "3 MPa"\n[medium]\nE_star = "1 GPa"\n'
    text = composed_from(LOADS.format("uniform", frozen) + NO_PDF).files["scene.py"].decode()
    assert "a = 0.002  # " in text
    assert "_require" not in text
    space: dict[str, object] = {}
    exec(text, space)
    assert space["displacement"](0.0) == pytest.approx(2.0 * 0.002 * 3e6 / 1e9, rel=1e-14, abs=0.0)


@pytest.mark.parametrize(
    ("load", "right", "wrong"),
    [
        ("uniform", "p_0 / E_star * a * uniform", "p_0 * a * uniform"),
        ("hertzian", "a * beside(", "2 * a * beside("),
        ("punch", "inside = np.pi", "inside = 2 * np.pi"),
    ],
)
def test_a_wrong_rule_does_not_pass(load, right, wrong, monkeypatch):
    exchanged(monkeypatch, f"loads/{load}.py", right, wrong)
    with pytest.raises(ArithmeticError, match="instead of"):
        composed_from(LOADS.format(load, "") + NO_PDF)


@pytest.mark.parametrize(
    ("source", "message"),
    [
        (LOADS.format("powr", ""), "unknown prescribed pressure 'powr'; did you mean 'power'?"),
        (LOADS.format("power", "[parameters]\ns = -1\n"), "s = -1 is outside s > -1"),
        (LOADS.format("cone", ""), "cone is a round profile"),
        (LOADS.format("r**2", ""), "the nearest is normal = true"),
        (LOADS.format("uniform", '[medium]\nkind = "power_law"\n'), 'the nearest is kind = "homogeneous"'),
        (LOADS.format("uniform", "") + "adhesive = true\n", "adhesive and loads together are not derived"),
        (LOADS.format("uniform", "").replace("= true", "= 3"), "write loads = true"),
        (LOADS.format("uniform", "") + '[want]\nat = { F = "1 N" }\n', "leave at out"),
        (LOADS.format("uniform", "") + '[want]\nquantities = ["force"]\n', "unknown quantity 'force' of loads"),
    ],
)
def test_what_is_not_at_hand_is_refused(source, message):
    assert message in problems(source)
