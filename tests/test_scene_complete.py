"""Scenes whose edge is fixed, or lifts off: numbers without fields, the rules between parameters, wrong rules."""

from __future__ import annotations

import math
import re

import pytest
from scenes import NO_PDF, composed_from, exchanged, problems

from axiderive.scene.linker import library, module

SHOE = 'profile = "eccentric_punch"\n[parameters]\na = 0.02\n{}[medium]\nE_star = 3e9\n[physics]\nplane = true\n'


def functions_of(source: str) -> dict[str, object]:
    space: dict[str, object] = {}
    exec(composed_from(source + '[output]\nformats = ["python"]\n').files["scene.py"].decode(), space)
    return space


@pytest.mark.parametrize("e", [0.004, -0.012])
def test_load_and_moment_of_an_eccentric_punch(e):
    """Both regimes: the pressure carries P at x = e, on the side of the load, and nothing where the edge is off."""
    import numpy as np

    space = functions_of(SHOE.format(f"e = {e}\n"))
    width = space["contact_width"]()
    assert width == pytest.approx(0.04 if abs(e) < 0.01 else 4 * (0.02 - abs(e)), rel=1e-15, abs=0.0)
    nodes, weights = np.polynomial.legendre.leggauss(60)
    middle = math.copysign(0.02 - width / 2, e)
    u = np.pi / 2 * nodes
    x = middle + width / 2 * np.sin(u)
    share = np.pi / 4 * width * np.cos(u) * weights * space["pressure"](x, 7.0)
    assert np.sum(share) == pytest.approx(7.0, rel=1e-12, abs=0.0)
    assert np.sum(share * x) == pytest.approx(7.0 * e, rel=1e-12, abs=0.0)
    assert space["pressure"](-math.copysign(0.0199, e), 7.0) == 0.0 or abs(e) < 0.01
    assert math.isnan(space["pressure"](0.0, -1.0))


def test_rules_between_parameters_are_asked_when_one_stays_free():
    space = functions_of(SHOE.format(""))
    assert space["tilt"](1.0, e=0.019) > 0.0
    with pytest.raises(ValueError, match=r"abs\(e\) < a is violated; a load beyond the edge"):
        space["contact_width"](e=-0.02)
    frozen = SHOE.format('e = "3 cm"\n')
    assert "a = 0.02, e = 0.03: abs(e) < a is violated" in problems(frozen)


def test_the_rule_of_the_waves_follows_the_grading():
    """At this height the contact is compact for k = 1/2 and not for k = 0, whose number is 12.39 in place of 10.18."""
    source = 'profile = "wavy_paraboloid"\n[parameters]\nR = 1.0\nwavelength = 1e-3\nh = 9e-8\n'
    assert "12.39" in problems(source)
    graded = source + '[medium]\nkind = "power_law"\nk = {}\n[want]\nquantities = ["depth"]\n'
    from axiderive.scene import reading, text

    assert reading.read(text.parse("scene", graded.format(0.5).encode())).values["k"] == 0.5
    assert "k = 0.1: g' < 0 at a = 0.000" in problems(graded.format(0.1))


def test_a_bump_has_a_module():
    """Its kernel is x/D(x): read as another form of Dawson's integral it refused every scene of this profile."""
    from axicontact.normal import gaussian

    source = 'profile = "gaussian"\n[parameters]\nh = 1e-3\ns = 3e-3\n[want]\nquantities = ["displacement"]\n'
    found = functions_of(source)["displacement"]([1e-3, 4e-3], 2e-3)
    assert found == pytest.approx(gaussian.displacement([1e-3, 4e-3], 2e-3, h=1e-3, s=3e-3), rel=2e-15, abs=0.0)


def test_numbers_without_fields_are_functions():
    source = 'profile = "concave_paraboloid"\n[parameters]\na = 2e-3\nh = 3e-6\n[medium]\n{}[want]\n{}'
    wanted = 'quantities = ["minimum_depth", "minimum_force", "zero_radius", "stiffness"]\n'
    space = functions_of(source.format("E_star = 1e9\n", wanted))
    found = [space[name]() for name in ("minimum_depth", "minimum_force", "zero_radius", "stiffness")]
    assert found == pytest.approx([6e-6, 32.0, 0.0, 4e6], rel=1e-14, abs=0.0)


@pytest.mark.parametrize(
    ("source", "right", "wrong"),
    [
        (SHOE.format(""), "2 * e + a", "e + a"),
        (SHOE.format("e = 0.0175\n"), "along - end", "along + end"),
        (SHOE.format("e = 0.015\n"), "2 * np.pi * short)", "np.pi * short)"),
        (
            'profile = "power"\n[physics]\nloads = true\n',
            "power(r, a, s)",
            "power(r, a, 0.5 * s)",
        ),
        ('profile = "capped_cylinder"\n', "np.maximum(excess, 0.0)\n", "0.0 * excess\n"),
    ],
)
def test_a_wrong_rule_does_not_pass(source, right, wrong, monkeypatch):
    name = re.search(r'(?:kind|profile) *= *"(\w+)"', source)[1]
    package = "plane" if "plane = true" in source else "loads" if "loads = true" in source else "normal"
    exchanged(monkeypatch, f"{package}/{name}.py", right, wrong)
    with pytest.raises(ArithmeticError, match="instead of"):
        composed_from(source + NO_PDF)


def test_a_load_seen_from_the_wrong_side_does_not_pass(monkeypatch):
    seen = module.TEMPLATES["leaning"].replace("np.copysign(1.0, x) * e", "e")
    monkeypatch.setitem(module.TEMPLATES, "leaning", seen)
    with pytest.raises(ArithmeticError, match="pressure"):
        composed_from(SHOE.format("e = 0.004\n") + NO_PDF)


@pytest.mark.parametrize(
    ("profile", "right", "wrong"),
    [("cone", "18 * dgamma", "16 * dgamma"), ("concave_paraboloid", "- hess_retraction(", "+ hess_retraction(")],
)
def test_a_wrong_pull_off_does_not_pass_alone(profile, right, wrong, monkeypatch):
    """Also where no force and no depth is wanted that the state could be compared with."""
    module = library.Module

    def changed(name: str, text: str) -> object:
        return module(name, text.replace(right, wrong) if name.startswith("adhesive.") else text)

    monkeypatch.setattr(library, "Module", changed)
    source = f'profile = "{profile}"\n[physics]\nadhesive = true\n[want]\nquantities = ["pull_off"]\n'
    with pytest.raises(ArithmeticError, match="pull_off"):
        composed_from(source + NO_PDF)
