"""Emitted modules of the graded half-space: functions, arguments, shapes, messages."""

from __future__ import annotations

import inspect
import math
import warnings
from importlib import import_module
from typing import Any

import numpy as np
import pytest
import sympy as sp
from graded_modules import GROUPS, derived, emitted, keywords, public, values

from axiderive import notation as nt
from axiderive.abel.reduce import NotReducibleError
from axiderive.code.graded.families import family
from axiderive.letters import name_of
from axiderive.profiles import COMPACT_NAMES, COMPLETE_NAMES, NAMES, load
from axiderive.profiles.profile import Piece, Profile

COMPACT = {
    "profile": ["r"], "depth": ["a"], "force": ["a"], "pressure": ["r", "a"], "displacement": ["r", "a"],
    "stiffness": ["a"], "mean_pressure": ["a"], "radius_from_depth": ["d"], "radius_from_force": ["F"],
    "force_from_depth": ["d"], "depth_from_force": ["F"],
}  # fmt: skip


COMPLETE = {
    "profile": ["r"], "force": ["d"], "pressure": ["r", "d"], "displacement": ["r", "d"], "stiffness": [],
    "depth_from_force": ["F"],
}  # fmt: skip
CONCAVE = {"zero_radius": [], "minimum_depth": [], "minimum_force": []}
ADHESIVE = {
    "retraction": ["a"], "depth": ["a"], "force": ["a"], "pressure": ["r", "a"], "displacement": ["r", "a"],
    "radius_from_depth": ["d"], "radius_from_force": ["F"], "pull_off": ["control"],
    "work_of_adhesion_from_pull_off": ["F"],
}  # fmt: skip
TANGENTIAL = {
    "tangential_force": ["a", "c"], "traction": ["r", "a", "c"], "tangential_displacement": ["a", "c"],
    "stick_radius": ["F_x", "a"], "full_slip_displacement": ["a"],
}  # fmt: skip


@pytest.mark.parametrize("name", NAMES)
def test_interface(name: str) -> None:
    normal = public(emitted(f"normal.{name}"))
    if name in COMPACT_NAMES:
        assert normal == COMPACT
        assert public(emitted(f"adhesive.{name}")) == ADHESIVE
        assert public(emitted(f"tangential.{name}")) == TANGENTIAL
    else:
        stiffness = {"stiffness": ["d"]} if name == "capped_cylinder" else {}
        assert normal == COMPLETE | (CONCAVE if name.startswith("concave") else {}) | stiffness
    for group in GROUPS:
        for entry in derived(group, name).values():
            function = getattr(emitted(f"{group}.{name}"), entry.quantity.function)
            own = [p.name for p in inspect.signature(function).parameters.values() if p.kind is p.KEYWORD_ONLY]
            assert own == [name_of(symbol) for symbol in entry.parameters], entry.key


@pytest.mark.parametrize("name", COMPLETE_NAMES)
def test_complete_contacts_say_what_to_use(name: str) -> None:
    with pytest.raises(AttributeError, match=r"slips as a whole at F_x = mu F, with F from axicontact\.graded\.normal"):
        _ = emitted(f"tangential.{name}").traction
    if name == "capped_cylinder":
        with pytest.raises(AttributeError, match=r"use axicontact\.graded\.adhesive\.paraboloid"):
            _ = emitted(f"adhesive.{name}").pull_off


def test_a_profile_without_graded_integrals_is_refused() -> None:
    odd = load("cone")
    pieces = (Piece(None, nt.h * (1 - sp.exp(-nt.r / nt.s))),)
    with pytest.raises(NotReducibleError, match="add its depth, rate, force, pressure and sag"):
        family(Profile(**{**vars(odd), "pieces": pieces}))


BAD: list[tuple[str, str, tuple[Any, ...], dict[str, Any], str]] = [
    ("normal.cone", "depth", (1.0,), {"theta": 0.3, "k": 1.0}, r"k = 1\.0 is outside -1 < k < 1; .*k = 0 for a homog"),
    ("normal.cone", "force", (1.0,), {"theta": 0.3, "H": 1.0, "k": -1.0}, r"k = -1\.0 is outside -1 < k < 1"),
    ("normal.cone", "force", (1.0,), {"theta": 0.3, "H": 0.0, "k": 0.2}, r"H = 0\.0 is outside H > 0"),
    (
        "normal.truncated_cone",
        "depth",
        (0.2,),
        {"theta": 0.3, "b": 0.5, "k": 0.2},
        r"a = 0\.2 is below b = 0\.5: .*use",
    ),
    ("normal.concave_power", "force", (1.0,), {"a": 1.0, "h": 1.0, "n": 1.2, "H": 1.0, "k": -0.3}, "n > 1 - k is viol"),
    (
        "normal.wavy_paraboloid",
        "depth",
        (1.0,),
        {"R": 1.0, "h": 0.01, "wavelength": 0.38, "k": -0.5},
        r"steepest_waves\(k\)\*R\*h <= wavelength\*\*2 is violated; steeper waves leave gaps",
    ),
    ("adhesive.power_law", "pull_off", (), {"A": 1.0, "n": 0.3, "H": 1.0, "k": 0.2, "dgamma": 1.0}, r"n > \(1 - k\)/2"),
    ("adhesive.cone", "pull_off", ("up",), {"theta": 0.3, "H": 1.0, "k": 0.2, "dgamma": 1.0}, "'force' or 'depth'"),
    ("adhesive.cone", "depth", (1.0,), {"theta": 0.3, "H": 1.0, "k": 0.2, "dgamma": -1.0}, "dgamma >= 0"),
    (
        "tangential.cone",
        "tangential_force",
        (1.0, 1.5),
        {"theta": 0.3, "H": 1.0, "k": 0.2, "mu": 0.1},
        "c <= a is viol",
    ),
]


@pytest.mark.parametrize(("name", "function", "fields", "given", "message"), BAD)
def test_bad_input(name: str, function: str, fields: tuple[Any, ...], given: dict[str, Any], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        getattr(emitted(name), function)(*fields, **given)


def test_waves_that_only_some_grading_allows() -> None:
    """wavelength**2 >= 12.39 h R without grading; a softer surface (k < 0) follows the waves into their troughs."""
    wavy = emitted("normal.wavy_paraboloid")
    limit = import_module("axicontact._runtime.graded.waves").steepest_waves
    least = float(load("wavy_paraboloid").rules[0].left.subs({nt.R: 1, nt.h: 1}))
    assert limit(0.0) == pytest.approx(least, rel=1e-6)
    assert np.all(np.diff(limit([-0.9, -0.5, 0.0, 0.5, 0.9])) < 0.0)
    assert wavy.depth(1.0, R=1.0, h=0.01, wavelength=0.38, k=0.3) > 0.0


@pytest.mark.parametrize("name", NAMES)
def test_shapes_limits_and_silence(name: str) -> None:
    profile, module, known = load(name), emitted(f"normal.{name}"), values(load(name), "0.3")
    edge = float(known[nt.d if profile.contact == "complete" else nt.a])
    a = float(known[nt.a])
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        p = module.pressure([0.0, a / 2, a, 2 * a, -1.0, math.nan], edge, **keywords(module.pressure, profile, known))
        assert p[3] == 0.0 and np.isnan(p[4:]).all() and p[1] > 0.0
        given = keywords(module.displacement, profile, known)
        w = module.displacement([0.3 * a, a, a * (1 + 1e-12)], edge, **given)
        f = module.profile([0.3 * a, a], **keywords(module.profile, profile, known))
        depth = edge if profile.contact == "complete" else module.depth(edge, **keywords(module.depth, profile, known))
        np.testing.assert_allclose(w[:2], depth - f, rtol=1e-14)
        assert w[2] == pytest.approx(w[1], rel=1e-4)
        assert isinstance(module.force(edge, **keywords(module.force, profile, known)), float)
        k = np.array([-0.6, 0.2, 0.8])
        force = keywords(module.force, profile, known) | {"k": k}
        value = module.force(np.full((2, 1), edge), **force)
        assert value.shape == (2, 3)
        alone = [module.force(edge, **(force | {"k": own})) for own in k]
        np.testing.assert_allclose(value, [alone, alone], rtol=1e-14)
