"""What every emitted module beyond the normal contact has in common: interface, examples, messages."""

from __future__ import annotations

import doctest
from typing import Any

import pytest
from physics_package import derived, emitted, positional, public

from axiderive.letters import name_of
from axiderive.profiles import COMPACT_NAMES, COMPLETE_NAMES, NAMES
from axiderive.profiles.loads import LOADS

GROUPS = ("adhesive", "tangential", "viscoelastic", "loads")
ADHESIVE = {
    "retraction": ["a"],
    "depth": ["a"],
    "force": ["a"],
    "pressure": ["r", "a"],
    "displacement": ["r", "a"],
    "radius_from_depth": ["d"],
    "radius_from_force": ["F"],
    "pull_off": ["control"],
    "work_of_adhesion_from_pull_off": ["F"],
}
TANGENTIAL = {
    "tangential_force": ["a", "c"],
    "traction": ["r", "a", "c"],
    "tangential_displacement": ["a", "c"],
    "stick_radius": ["F_x", "a"],
    "full_slip_displacement": ["a"],
}


@pytest.mark.parametrize("name", COMPACT_NAMES)
def test_interface_of_adhesive_and_tangential(name: str) -> None:
    for group, functions, entries in (
        ("adhesive", ADHESIVE, derived()["adhesive"][name]),
        ("tangential", TANGENTIAL, derived()["tangential"][name]),
    ):
        signatures = public(emitted(f"{group}.{name}"))
        assert {key: positional(signature) for key, signature in signatures.items()} == functions
        for entry in entries.values():
            parameters = signatures[entry.quantity.function].parameters.values()
            own = [p.name for p in parameters if p.kind is p.KEYWORD_ONLY]
            assert own == [name_of(symbol) for symbol in entry.parameters], entry.key


@pytest.mark.parametrize("name", NAMES)
def test_interface_of_viscoelastic(name: str) -> None:
    signatures = public(emitted(f"viscoelastic.{name}"))
    entries = derived()["viscoelastic"][name]
    assert sorted(signatures) == sorted(entry.quantity.function for entry in entries.values())
    for function, signature in signatures.items():
        assert positional(signature) == ([] if function.startswith("contact_time") else ["t"]), function


def modules() -> list[str]:
    groups = derived()
    pairs = [
        f"{group}.{name}" for group in ("adhesive", "tangential", "viscoelastic", "loads") for name in groups[group]
    ]
    return [*pairs, "materials"]


def test_the_example_of_every_function_runs() -> None:
    """The expected number comes from the exact entry through mpmath, not from the module."""
    functions = examples = 0
    for name in modules():
        module = emitted(name)
        for test in doctest.DocTestFinder().find(module):
            assert doctest.DocTestRunner().run(test).failed == 0
            examples += bool(test.examples)
        functions += len(public(module))
    backed = {
        (system, name, entry.quantity.function)
        for system in (*GROUPS, "materials")
        for name, entries in derived()[system].items()
        for entry in entries.values()
    }
    # the inverse of pull_off is derived from its entries and is none itself
    assert functions == examples == len(backed) + len(derived()["adhesive"])


@pytest.mark.parametrize("group", GROUPS)
def test_packages_list_their_modules(group: str) -> None:
    module = emitted(group)
    assert sorted(module.__all__) == sorted([own.name for own in LOADS] if group == "loads" else NAMES)
    assert getattr(module, module.__all__[0]) is emitted(f"{group}.{module.__all__[0]}")


@pytest.mark.parametrize("name", COMPLETE_NAMES)
def test_complete_contacts_say_what_to_use(name: str) -> None:
    with pytest.raises(AttributeError, match="no partial slip; it slips as a whole at F_x = mu F"):
        _ = emitted(f"tangential.{name}").traction
    if name not in derived()["adhesive"]:
        with pytest.raises(AttributeError, match="use axicontact.adhesive.paraboloid"):
            _ = emitted(f"adhesive.{name}").pull_off


BAD: list[tuple[str, str, tuple[float, ...], dict[str, Any], str]] = [
    (
        "adhesive.cone",
        "force",
        (1.0,),
        {"theta": 0.3, "E_star": 1.0, "dgamma": -1.0},
        r"dgamma = -1\.0 is outside dgamma >= 0; .*use dgamma = 0",
    ),
    (
        "adhesive.cone",
        "pull_off",
        ("up",),
        {"theta": 0.3, "E_star": 1.0, "dgamma": 1.0},
        "control = 'up' must be 'force' or 'depth'",
    ),
    (
        "adhesive.power_law",
        "pull_off",
        (),
        {"A": 1.0, "n": 0.5, "E_star": 1.0, "dgamma": 1.0},
        r"n = 0\.5: n > 1/2 is violated; .*no pull-off",
    ),
    (
        "adhesive.power_law",
        "radius_from_depth",
        (1.0,),
        {"A": 1.0, "n": 0.4, "E_star": 1.0, "dgamma": 1.0},
        r"n = 0\.4: n > 1/2",
    ),
    (
        "tangential.cone",
        "traction",
        (0.1, 1.0, 0.5),
        {"theta": 0.3, "E_star": 1.0, "mu": -0.1},
        r"mu = -0\.1 is outside mu >= 0; .*positive",
    ),
    (
        "tangential.cone",
        "tangential_force",
        (1.0, 1.5),
        {"theta": 0.3, "E_star": 1.0, "mu": 0.1},
        r"c = 1\.5, a = 1\.0: c <= a is violated; .*exchange a and c",
    ),
    (
        "viscoelastic.cone",
        "ramp_force_maxwell",
        (1.0,),
        {"v": -1.0, "theta": 0.3, "E": 1.0, "tau": 1.0},
        r"v = -1\.0 is outside v > 0; .*shrinking contact",
    ),
    (
        "viscoelastic.cone",
        "step_force_maxwell",
        (1.0,),
        {"d": -1.0, "theta": 0.3, "E": 1.0, "tau": 1.0},
        r"d = -1\.0 is outside d >= 0",
    ),
    (
        "loads.power",
        "displacement",
        (1.0,),
        {"a": 1.0, "p_0": 1.0, "s": -1.0, "E_star": 1.0},
        r"s = -1\.0 is outside s > -1; .*infinite force",
    ),
    ("materials", "effective_modulus", (1.0, 0.6, 1.0, 0.3), {}, r"nu_1 = 0\.6 is outside -1 < nu_1 <= 1/2"),
    ("materials", "h_N", (1.0, 0.3), {}, r"k = 1\.0 is outside -1 < k < 1"),
    (
        "materials",
        "transversely_isotropic_modulus",
        (1.0, 4.0, -2.0, 1.0),
        {},
        r"C_13 = -2\.0: C_13\*\*2 < C_11\*C_33 is violated; .*C_11 is along the surface",
    ),
    (
        "materials",
        "transversely_isotropic_modulus",
        (1.0, 4.0, float("nan"), 1.0),
        {},
        r"C_13 = nan is outside -oo < C_13 < oo",
    ),
    ("materials", "effective_radius", (1.0, -1.0), {}, r"1/R_1 \+ 1/R_2 > 0 is violated; give a cup as -R_2 > R_1"),
    ("materials", "effective_radius", (1.0, 0.0), {}, r"1/R_1 \+ 1/R_2 > 0 is violated"),
    ("materials", "effective_radius", (float("inf"), float("inf")), {}, r"two planes as no contact"),
    ("materials", "effective_radius", (-2.0, 1.0), {}, r"R_1 = -2\.0 is outside R_1 > 0"),
    ("materials", "tabor", (1.0, 1.0, 1.0, 0.0), {}, r"z_0 = 0\.0 is outside z_0 > 0"),
]


@pytest.mark.parametrize(("name", "function", "fields", "given", "message"), BAD)
def test_bad_input(name: str, function: str, fields: tuple[Any, ...], given: dict[str, Any], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        getattr(emitted(name), function)(*fields, **given)
