"""Worked examples against the modules that a reader calls: the printed digits, from floats alone."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest
import sympy as sp
from examples import number
from stored_book import KEYS, stored

from axicontact.graded.normal import concave_power as graded_face
from axicontact.graded.normal import sphere as graded_sphere
from axicontact.materials import effective_modulus, effective_shear_modulus, graded_modulus
from axicontact.normal import sphere
from axicontact.tangential import sphere as slipping
from axicontact.viscoelastic import sphere as relaxing
from axiderive.book.spread import problems_of
from axiderive.figures.values import Numbers, StripNumbers
from axiderive.physics.systems import pool_of
from axiderive.worked.cases import CASES, CERAMIC, POLYETHYLENE, STEEL
from axiderive.worked.further import GRADED, SOLIDS
from axiderive.worked.normal import worked


@cache
def _example(name: str) -> dict[str, Any]:
    plane = name.startswith("plane.")
    derived = {problem.key: stored(problem.key) for problem in problems_of(name)}
    found: dict[str, Any] = worked(name, profile_of(name), derived, StripNumbers if plane else Numbers)
    return found


def profile_of(name: str) -> Any:
    return pool_of(name).load(name.rpartition(".")[2])


@cache
def _examples(name: str) -> dict[str, Any]:
    """Numbers by name, by title; those of the normal contact have none."""
    found = _example(name)
    further = {one["title"]: one["numbers"] for one in found["further"]}
    return {
        title: {key: tex for key, tex, _ in numbers} for title, numbers in {"": found["numbers"], **further}.items()
    }


def _value(tex: str) -> float:
    return number(tex)[0]


ROUND = tuple(name for name in CASES if not name.startswith("plane."))


@pytest.mark.parametrize("name", CASES)
def test_the_contact_of_an_example_reaches_its_break(name: str) -> None:
    """Once the flank of a blunted tip did not touch, and the example was one of another profile."""
    case, profile = CASES[name], profile_of(name)
    for symbol in profile.breaks:
        values = {s: sp.Rational(case.parameters[s.name]) for s in profile.parameters}
        end = float(dict(profile.abbreviations).get(symbol, symbol).subs(values))
        reached = [_value(shown["a"]) for shown in _examples(name).values() if "a" in shown]
        assert len(reached) == (1 if name not in ROUND else 2)
        assert min(reached) > end


@pytest.mark.parametrize("name", CASES)
def test_the_material_of_an_example_bears_its_mean_pressure(name: str) -> None:
    """Or the reader is told: a Berkovich indenter is elastic up to no load."""
    case, shown = CASES[name], _examples(name)
    media = {"": case.material.strength, "Graded half-space": GRADED.get(case.material, CERAMIC).strength}
    pressed = {title: _value(shown[title][r"\bar p"]) / media[title] for title in media if title in shown}
    assert (max(pressed.values()) > 1) == bool(case.remark)
    assert max(pressed.values()) < (2.5 if case.remark else 1)


@pytest.mark.parametrize("name", [name for name in ROUND if CASES[name].material.separation])
def test_the_load_of_an_adhesive_example_is_more_than_its_pull_off(name: str) -> None:
    shown = _examples(name)
    pulled = -_value(shown[""][r"F_{\mathrm c}"])
    assert 0 < pulled < CASES[name].load / 2
    assert pulled < _value(shown["Standard solid"][r"F_{\mathrm N}(\tau)"]) / 2


def test_no_solid_of_an_example_is_so_soft_that_it_would_stick() -> None:
    """A rubber was once pressed by less than a tenth of what pulls it off; the others are a thousand times as stiff."""
    for name in ROUND:
        if not CASES[name].material.separation:
            assert float(SOLIDS.get(CASES[name].material, POLYETHYLENE).E_inf) > 1e8
            assert _value(_examples(name)["Standard solid"][r"F_{\mathrm N}(0)"]) > 1e-3


@pytest.mark.parametrize("name", CASES)
def test_the_lines_of_python_give_what_is_printed_behind_them(name: str) -> None:
    lines = _example(name)["python"]
    known: dict[str, Any] = {}
    for line, _ in lines[:-1]:
        exec(line, known)
    expression, printed = lines[-1]
    found = np.atleast_1d(eval(expression, known))
    assert 3 <= len(lines) <= 4
    assert [f"{value:.4g}" for value in found] == [f"{value:.4g}" for value in np.atleast_1d(eval(printed))]
    assert all(not shown for _, shown in lines[:-1])


def test_the_blunting_of_a_tip_matters_by_a_hundredth() -> None:
    """PMMA, half-angle 70.3 degrees, tip radius 100 nm, at a depth of one micrometre."""
    for name, load in (("rounded_cone", 6.432e-3), ("sphere_tipped_cone", 6.429e-3)):
        shown = _examples(name)
        assert _value(shown[""]["d"]) == pytest.approx(1e-6, rel=1e-4)
        assert _value(shown[""]["a"]) == pytest.approx(1.789e-6, rel=1e-4)
        assert _value(shown["Sharp cone"][r"F_{\mathrm N}"]) == pytest.approx(6.350e-3, rel=1e-4)
        assert CASES[name].load == load


@pytest.mark.parametrize(
    ("name", "place"),
    [("cone", "p(0)"), ("polynomial", "p(0)"), ("truncated_cone", "p(b)"), ("capped_paraboloid", "p(b)"),
     ("flat_punch", "p(a)"), ("sphere", ""), ("rounded_punch", ""), ("rounded_cone", ""), ("plane.wedge", "p(0)")],
)  # fmt: skip
def test_the_largest_pressure_is_printed_or_where_it_is_infinite(name: str, place: str) -> None:
    shown = _examples(name)[""]
    assert [key for key, tex in shown.items() if tex == r"\infty"] == ([place] if place else [])
    assert (r"p_{\mathrm{max}}" in shown) is not bool(place)


def _agrees(tex: str, value: float) -> bool:
    printed, half = number(tex)
    return abs(printed - value) <= half * (1 + 1e-9)


def test_the_examples_of_the_sphere_are_what_its_modules_give() -> None:
    shown, silicone = _examples("sphere"), 2e6 / 0.75
    a = sphere.radius_from_force(0.5, R=5e-3, E_star=silicone)
    slip = {"R": 5e-3, "E_star": silicone, "mu": 0.8}
    shear = 4 * 2e6 / 3 / 1.5
    c = slipping.stick_radius(0.2, a, **slip)
    partial = shown["Partial slip"]
    assert _agrees(partial["c"], c)
    assert _agrees(partial["u"], slipping.tangential_displacement(a, c, **slip, G_star=shear))
    assert _agrees(partial[r"u_{\mathrm s}"], slipping.full_slip_displacement(a, **slip, G_star=shear))
    assert _agrees(partial[r"\tau(a/2)"], slipping.traction(a / 2, a, c, **slip))
    medium = {"R": 5e-3, "H": graded_modulus(E_0=6e6, c_0=1e-3, k=0.4, nu=0.45), "k": 0.4}
    radius, graded = graded_sphere.radius_from_force(0.5, **medium), shown["Graded half-space"]
    assert _agrees(graded["a"], radius)
    assert _agrees(graded["d"], graded_sphere.depth(radius, R=5e-3, k=0.4))
    assert _agrees(graded[r"\bar p"], graded_sphere.mean_pressure(radius, **medium))
    solid: dict[str, Any] = {"R": 5e-3, "E_inf": 2e6, "E_1": 1e6, "tau": 10.0}
    depth, rest = sphere.depth(a, R=5e-3), shown["Standard solid"]
    first = relaxing.step_force_standard_solid(0.0, d=depth, **solid)
    assert _agrees(rest[r"F_{\mathrm N}(0)"], first)
    assert _agrees(rest[r"F_{\mathrm N}(\tau)"], relaxing.step_force_standard_solid(10.0, d=depth, **solid))
    for name, time in ((r"a(\tau)", 10.0), (r"a(10\tau)", 100.0)):
        assert _agrees(rest[name], relaxing.step_load_radius_standard_solid(time, F=first, **solid))


def test_the_example_of_a_complete_face_is_what_its_module_gives() -> None:
    graded = _examples("concave_power")["Graded half-space"]
    face = {"a": 2e-3, "h": 2e-6, "n": 3.0, "k": 0.15, "H": graded_modulus(E_0=250e9, c_0=1e-3, k=0.15, nu=0.22)}
    depth = graded_face.depth_from_force(5e3, **face)
    assert set(graded) == {"d", r"\bar p"}
    assert _agrees(graded["d"], depth)


def test_effective_moduli_are_those_of_the_materials() -> None:
    both = {"E_1": 210e9, "nu_1": 0.3, "E_2": 210e9, "nu_2": 0.3}
    assert float(STEEL.modulus) == pytest.approx(effective_modulus(**both), rel=1e-14, abs=0.0)
    assert float(STEEL.shear) == pytest.approx(effective_shear_modulus(**both), rel=1e-14, abs=0.0)
    assert {name for name in CASES if "." not in name} == {k for k in KEYS if "." not in k} - {"materials"}
