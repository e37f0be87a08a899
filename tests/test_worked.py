"""Worked examples against the modules that a reader calls: the printed digits, from floats alone."""

from __future__ import annotations

from functools import cache
from typing import Any

import pytest
from stored_book import KEYS, stored

from axicontact.graded.normal import concave_power as graded_face
from axicontact.graded.normal import sphere as graded_sphere
from axicontact.materials import effective_modulus, effective_shear_modulus, graded_modulus
from axicontact.normal import sphere
from axicontact.tangential import sphere as slipping
from axicontact.viscoelastic import sphere as relaxing
from axiderive.emit.readback.numbers import number
from axiderive.emit.spread import pool_of, problems_of
from axiderive.emit.values import Numbers
from axiderive.emit.worked import worked
from axiderive.emit.worked.cases import CASES, STEEL


@cache
def _examples(name: str) -> dict[str, Any]:
    """Numbers by name, by title; those of the normal contact have none."""
    derived = {problem.key: stored(problem.key) for problem in problems_of(name)}
    found = worked(name, pool_of(name).load(name), derived, Numbers)
    further = {one["title"]: one["numbers"] for one in found["further"]}
    return {
        title: {key: tex for key, tex, _ in numbers} for title, numbers in {"": found["numbers"], **further}.items()
    }


def _agrees(tex: str, value: float) -> bool:
    printed = number(tex)
    return bool(abs(printed.value - value) <= printed.half * (1 + 1e-9))


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
    assert _agrees(graded["p(a/2)"], graded_sphere.pressure(radius / 2, radius, **medium))
    solid: dict[str, Any] = {"R": 5e-3, "E_inf": 2e6, "E_1": 1e6, "tau": 10.0}
    depth, rest = sphere.depth(a, R=5e-3), shown["Standard solid"]
    first = relaxing.step_force_standard_solid(0.0, d=depth, **solid)
    assert _agrees(rest["F(0)"], first)
    assert _agrees(rest[r"F(\tau)"], relaxing.step_force_standard_solid(10.0, d=depth, **solid))
    for name, time in ((r"a(\tau)", 10.0), (r"a(10\tau)", 100.0)):
        assert _agrees(rest[name], relaxing.step_load_radius_standard_solid(time, F=first, **solid))


def test_the_example_of_a_complete_face_is_what_its_module_gives() -> None:
    graded = _examples("concave_power")["Graded half-space"]
    face = {"a": 2e-3, "h": 2e-6, "n": 3.0, "k": 0.15, "H": graded_modulus(E_0=250e9, c_0=1e-3, k=0.15, nu=0.22)}
    depth = graded_face.depth_from_force(5e3, **face)
    assert set(graded) == {"d", r"\bar p", "p(a/2)"}
    assert _agrees(graded["d"], depth)
    assert _agrees(graded["p(a/2)"], graded_face.pressure(1e-3, depth, **face))


def test_effective_moduli_are_those_of_the_materials() -> None:
    both = {"E_1": 210e9, "nu_1": 0.3, "E_2": 210e9, "nu_2": 0.3}
    assert float(STEEL.modulus) == pytest.approx(effective_modulus(**both), rel=1e-14, abs=0.0)
    assert float(STEEL.shear) == pytest.approx(effective_shear_modulus(**both), rel=1e-14, abs=0.0)
    assert {name for name in CASES if "." not in name} == {k for k in KEYS if "." not in k} - {"materials"}
