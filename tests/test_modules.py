"""The generated package against the table of functions, over all profiles by introspection."""

from __future__ import annotations

import doctest
import inspect
import json
import subprocess
import sys
from importlib import import_module

import pytest

from axiderive.code.normal import module as written
from axiderive.code.private import parameter_name
from axiderive.physics.normal import derive
from axiderive.profiles import COMPLETE_NAMES, NAMES, load

COMPACT_FUNCTIONS = {
    "profile": ["r"],
    "depth": ["a"],
    "force": ["a"],
    "pressure": ["r", "a"],
    "displacement": ["r", "a"],
    "stiffness": ["a"],
    "mean_pressure": ["a"],
    "load_within": ["r", "a"],
    "energy": ["a"],
    "radius_from_depth": ["d"],
    "radius_from_force": ["F"],
    "force_from_depth": ["d"],
    "depth_from_force": ["F"],
}
COMPLETE_FUNCTIONS = {
    "profile": ["r"],
    "load_within": ["r", "d"],
    "energy": ["d"],
    "force": ["d"],
    "pressure": ["r", "d"],
    "displacement": ["r", "d"],
    "stiffness": [],
    "depth_from_force": ["F"],
}
CONCAVE_FUNCTIONS = {"zero_radius": [], "minimum_depth": [], "minimum_force": []}


def expected(name: str) -> dict[str, list[str]]:
    if name not in COMPLETE_NAMES:
        return COMPACT_FUNCTIONS | ({"peak_pressure": ["a"]} if "pp" in derive(load(name)) else {})
    functions = COMPLETE_FUNCTIONS | (CONCAVE_FUNCTIONS if name.startswith("concave") else {})
    return functions | ({"stiffness": ["d"]} if name == "capped_cylinder" else {})


def public(name: str) -> dict[str, inspect.Signature]:
    module = import_module(f"axicontact.normal.{name}")
    return {
        key: inspect.signature(value)
        for key, value in vars(module).items()
        if inspect.isfunction(value) and value.__module__ == module.__name__ and not key.startswith("_")
    }


@pytest.mark.parametrize("name", NAMES)
def test_exactly_the_functions_of_the_table(name: str) -> None:
    found = {key: positional(signature) for key, signature in public(name).items()}
    assert found == expected(name)


def positional(signature: inspect.Signature) -> list[str]:
    return [p.name for p in signature.parameters.values() if p.kind is p.POSITIONAL_OR_KEYWORD]


@pytest.mark.parametrize("name", NAMES)
def test_geometry_and_material_are_keywords_of_the_entry(name: str) -> None:
    signatures = public(name)
    for entry in derive(load(name)).values():
        parameters = signatures[entry.quantity.function].parameters.values()
        keywords = [p.name for p in parameters if p.kind is p.KEYWORD_ONLY]
        assert keywords == [parameter_name(symbol) for symbol in entry.parameters], entry.key


@pytest.mark.parametrize("name", NAMES)
def test_the_example_of_every_function_runs(name: str) -> None:
    """The expected number comes from the exact result through mpmath, not from the module."""
    module = import_module(f"axicontact.normal.{name}")
    result = doctest.testmod(module)
    assert result.attempted == 3 * len(expected(name))
    assert result.failed == 0


@pytest.mark.parametrize("name", ["cone", "rounded_punch", "concave_power"])
def test_committed_text_is_what_the_entries_give(name: str) -> None:
    module = import_module(f"axicontact.normal.{name}")
    assert inspect.getsource(module) == written(derive(load(name))).source()


def test_generated_text_is_linted_and_formatted() -> None:
    folder = import_module("axicontact").__path__[0]
    for command in (["check", "-q"], ["format", "--check", "-q"]):
        done = subprocess.run([sys.executable, "-m", "ruff", *command, folder], capture_output=True, text=True)
        if "No module named ruff" in done.stderr:
            pytest.skip("ruff is not installed")
        assert done.returncode == 0, done.stdout


LOADED = """
import json, sys
import axicontact.normal.cone
heavy = [m for m in ("sympy", "scipy", "mpmath", "flint", "axiderive") if m in sys.modules]
print(json.dumps([heavy, sorted(m for m in sys.modules if m.startswith("axicontact"))]))
"""


def test_importing_one_profile_loads_no_other() -> None:
    done = subprocess.run([sys.executable, "-c", LOADED], capture_output=True, text=True, check=True)
    heavy, own = json.loads(done.stdout)
    assert heavy == []
    assert [name for name in own if name.startswith("axicontact.normal.")] == ["axicontact.normal.cone"]


def test_profiles_are_found_on_demand() -> None:
    import axicontact

    assert sorted(axicontact.normal.__all__) == sorted(NAMES)
    with pytest.raises(AttributeError, match="has no profile 'wedge'"):
        _ = axicontact.normal.wedge
