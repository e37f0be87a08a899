"""What holds for a contact on a graded or a viscoelastic half-space whatever the numbers, the grading among them."""

from __future__ import annotations

from importlib import import_module
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from test_properties import EPS, ROUND_TRIP, keywords_of, modules

FACED = ("truncated_cone", "rounded_punch")
"""With a flat face of radius b, over which every contact extends."""
GRADING = st.floats(-0.95, 0.95)
SOLVED = 32
"""Units by which the radius of an adhesive load is found again; 8 measured, of a cone of 4e-24 m at k = -0.9."""
LAWS = ("maxwell", "kelvin_voigt", "standard_solid", "power_creep")


def called(module: ModuleType, function: str, *fields: Any, **known: Any) -> Any:
    """A function with those of the keywords that it takes."""
    own = getattr(module, function)
    return own(*fields, **{key: known[key] for key in keywords_of(own)})


def radius(name: str, known: dict[str, float], x: float) -> float:
    return known["b"] * (1.0 + x) if name in FACED else x * known.get("R", 1.0)


@pytest.mark.parametrize("name", ["cone", "sphere", "hyperboloid", "truncated_cone", "rounded_punch"])
@given(k=GRADING, x=st.floats(1e-3, 0.95))
@settings(max_examples=10)
def test_a_graded_contact_grows_and_is_found_again(name: str, k: float, x: float) -> None:
    """A power of the radius that is off by k is found again neither by the depth nor by the force."""
    module = import_module(f"axicontact.graded.normal.{name}")
    known = keywords_of(module.force) | {"k": k}
    a = radius(name, known, x)
    d, force = called(module, "depth", a, **known), called(module, "force", a, **known)
    assert called(module, "depth", 1.001 * a, **known) > d
    assert called(module, "force", 1.001 * a, **known) > force
    assert called(module, "radius_from_depth", d, **known) == pytest.approx(a, rel=ROUND_TRIP, abs=0.0)
    assert called(module, "radius_from_force", force, **known) == pytest.approx(a, rel=ROUND_TRIP, abs=0.0)
    assert called(module, "force_from_depth", d, **known) == pytest.approx(force, rel=ROUND_TRIP, abs=0.0)
    assert called(module, "depth_from_force", force, **known) == pytest.approx(d, rel=ROUND_TRIP, abs=0.0)


@pytest.mark.parametrize("name", ["cone", "sphere", "hyperboloid", "gaussian", "truncated_cone", "rounded_punch"])
@given(k=GRADING, x=st.floats(1e-3, 0.99), y=st.floats(0.0, 0.999))
@settings(max_examples=10)
def test_a_graded_contact_does_not_pull(name: str, k: float, x: float, y: float) -> None:
    """On the axis as well, where for k < -1/2 an integrand is asked for its limit; and the surface falls off."""
    module = import_module(f"axicontact.graded.normal.{name}")
    known = keywords_of(module.pressure) | {"k": k}
    a = radius(name, known, x)
    axis, beside, within, beyond = called(module, "pressure", np.array([0.0, 1e-9, y, 1.001]) * a, a, **known)
    assert within > 0.0 == beyond
    # a cone has a singularity there, where k <= 0
    assert axis == pytest.approx(beside, rel=ROUND_TRIP, abs=0.0) or (name == "cone" and axis > beside)
    surface = called(module, "displacement", np.array([0.99, 1.0, 1.001, 2.0]) * a, a, **known)
    assert np.all(np.diff(surface) < 0.0) and surface[-1] > 0.0


@pytest.mark.parametrize("name", ["cone", "paraboloid", "sphere", "hyperboloid", "rounded_punch"])
@given(k=st.floats(-0.9, 0.9), over=st.floats(1.01, 30.0))
@settings(max_examples=8)
def test_a_graded_adhesive_contact_is_found_again(name: str, k: float, over: float) -> None:
    """On its stable branch, where depth and force grow with the radius."""
    module = import_module(f"axicontact.graded.adhesive.{name}")
    known = keywords_of(module.force) | {"k": k}
    for control in ("force", "depth"):
        a = over * module.pull_off(control, **known).radius
        value = called(module, control, a, **known)
        step = called(module, control, 1.001 * a, **known) - value
        if name == "sphere" and np.isnan(step):
            continue
        assert step > 0.0
        # the load is a difference: a unit in the last place of its terms changes the radius by this much
        without = called(module, control, a, **(known | {"dgamma": 0.0}))
        unit = EPS * (2.0 * without - value) / (step / 0.001)
        found = called(module, f"radius_from_{control}", value, **known)
        assert found == pytest.approx(a, rel=SOLVED * (EPS + unit), abs=0.0)


@pytest.mark.parametrize("name", ["cone", "paraboloid", "sphere", "rounded_punch", "hyperboloid"])
@given(k=GRADING, share=st.floats(1e-3, 0.999))
@settings(max_examples=8)
def test_graded_slip_grows_from_the_edge(name: str, k: float, share: float) -> None:
    module = import_module(f"axicontact.graded.tangential.{name}")
    known = keywords_of(module.traction) | keywords_of(module.tangential_displacement) | {"k": k}
    a = radius(name, known, 0.4)
    low = known["b"] if name in FACED else 0.0
    c = low + share * (a - low)
    force, step = called(module, "tangential_force", a, c, **known), 1e-3 * (c - low)
    more = called(module, "tangential_force", a, c - step, **known)
    assert 0.0 < force < more
    moved = called(module, "tangential_displacement", a, np.array([c - step, c]), **known)
    assert moved[0] > moved[1] > 0.0
    found = called(module, "stick_radius", force, a, **known)
    # a unit in the last place of c changes a force from a narrow ring of slip by many of its own
    unit = EPS * c * (more - force) / step
    again = called(module, "tangential_force", a, found, **known)
    assert again == pytest.approx(force, rel=ROUND_TRIP, abs=4 * unit)
    traction = called(module, "traction", np.linspace(0.0, 1.1 * a, 12), a, c, **known)
    assert np.all(traction >= 0.0) and traction[-1] == 0.0


@pytest.mark.parametrize("name", ["cone", "sphere", "hyperboloid", "rounded_cone"])
@given(t=st.floats(1e-3, 30.0), alpha=st.floats(0.05, 0.95))
@settings(max_examples=10)
def test_what_is_held_relaxes_and_what_is_loaded_creeps(name: str, t: float, alpha: float) -> None:
    """Between the moduli at once and at last, and J(t) E(t) <= 1, which no law of relaxation and creep escapes."""
    module, normal = (import_module(f"axicontact.{group}.{name}") for group in ("viscoelastic", "normal"))
    times = t * np.array([1.0, 1.1])
    found = {}
    for law in LAWS:
        known = keywords_of(getattr(module, f"step_load_radius_{law}")) | {"d": 0.2}
        known |= {"alpha": alpha} if "alpha" in known else {}
        held = called(module, f"step_force_{law}", times, **known)
        relaxed = held / called(normal, "force_from_depth", known["d"], **(known | {"E_star": 1.0}))
        a = called(module, f"step_load_radius_{law}", times, **known)
        crept = called(normal, "force", a, **(known | {"E_star": 1.0})) / known["F"]
        assert relaxed[0] >= relaxed[1] > 0.0 and 0.0 < crept[0] <= crept[1], law
        assert np.all(relaxed * crept <= 1.0 + ROUND_TRIP), law
        found[law] = held, relaxed, crept, known
    _, relaxed, crept, known = found["power_creep"]
    np.testing.assert_allclose(relaxed * crept, np.sinc(alpha), rtol=ROUND_TRIP)
    held, relaxed, crept, known = found["standard_solid"]
    soft, stiff = known["E_inf"], known["E_inf"] + known["E_1"]
    for modulus in (relaxed, 1.0 / crept):
        assert np.all((soft * (1.0 - ROUND_TRIP) <= modulus) & (modulus <= stiff * (1.0 + ROUND_TRIP)))
    fluid = called(module, "step_force_maxwell", times, **(known | {"E": known["E_1"]}))
    spring = called(normal, "force_from_depth", known["d"], **(known | {"E_star": soft}))
    np.testing.assert_allclose(held, fluid + spring, rtol=ROUND_TRIP)


@pytest.mark.parametrize("name", ["cone", "paraboloid", "quartic", "flat_punch"])
@given(t=st.floats(1e-3, 100.0), alpha=st.floats(0.05, 0.95))
@settings(max_examples=6)
def test_a_ramp_has_relaxed_less_than_what_is_held(name: str, t: float, alpha: float) -> None:
    """At the same depth at the same time; its force grows, and a spring and a fluid side by side add up."""
    module = import_module(f"axicontact.viscoelastic.{name}")
    times = t * np.array([1.0, 1.01])
    force = {}
    for law in LAWS:
        known = keywords_of(getattr(module, f"ramp_force_{law}"))
        known |= {"alpha": alpha} if "alpha" in known else {}
        force[law] = called(module, f"ramp_force_{law}", times, **known)
        held = called(module, f"step_force_{law}", times, **known, d=known["v"] * times)
        assert np.all(force[law] > held) and np.all(held > 0.0), law
        assert force[law][1] > force[law][0] * (1.0 - ROUND_TRIP), law
    known = keywords_of(module.ramp_force_standard_solid)
    fluid = called(module, "ramp_force_maxwell", times, **(known | {"E": known["E_1"]}))
    spring = called(module, "step_force_standard_solid", np.inf, **known, d=known["v"] * times)
    np.testing.assert_allclose(force["standard_solid"], fluid + spring, rtol=ROUND_TRIP)


@pytest.mark.parametrize("k", [-0.3, 0.3])
@pytest.mark.parametrize("package", ["normal", "adhesive"])
def test_a_contact_of_no_extent_carries_nothing(package: str, k: float) -> None:
    """On the graded half-space wherever it does on the homogeneous one; powers of k of nothing are infinite."""
    fields = {"depth": (0.0,), "force": (0.0,), "displacement": (0.5, 0.0)}
    fields |= {"force_from_depth": (0.0,), "depth_from_force": (0.0,)} if package == "normal" else {}
    tried = 0
    names = {name.rpartition(".")[2] for name in modules(f"graded.{package}")} - {*FACED, "truncated_paraboloid"}
    for name in sorted(names):
        plain, graded = (import_module(f"axicontact.{folder}{package}.{name}") for folder in ("", "graded."))
        for function in (function for function in fields if hasattr(plain, function)):
            if called(plain, function, *fields[function], **keywords_of(getattr(plain, function))) == 0.0:
                known = keywords_of(getattr(graded, function)) | {"k": k}
                assert called(graded, function, *fields[function], **known) == 0.0, (name, function)
                tried += 1
    assert tried > 30
    if package == "normal":
        cone, paraboloid = (import_module(f"axicontact.graded.normal.{name}") for name in ("cone", "paraboloid"))
        assert cone.mean_pressure(0.0, theta=0.2, H=1.0, k=k) == (np.inf if k < 0.0 else 0.0)
        assert paraboloid.mean_pressure(0.0, R=2.0, H=1.0, k=k) == 0.0
