"""What an import brings along: nothing that only a first call, an array or a message needs."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

import axicontact

ROOT = Path(axicontact.__file__).parent
LATE = ("bare", "symbols", "programs")
"""The words of messages; tracing, compiling, arrays beyond the range of doubles, all that is in `programs`."""
GRADED = ("graded.displacement", "graded.inverse", "graded.pressure", "graded.slip", "inverse",
          "physics.stable", "physics.unknowns")  # fmt: skip
"""Fields, inverses and slip on the graded half-space, which a depth or a force does without."""
HEAVY = ("dataclasses", "inspect", "dis", "fractions", "decimal")


def of_runtime(modules: set[str]) -> set[str]:
    """The files of the run time among these modules, without the packages around them."""
    return {name.removeprefix("_runtime.") for name in modules if name.startswith("_runtime.")}


def imported(module: str) -> list[str]:
    """What comes with a module over NumPy."""
    code = f"import sys, numpy; before = set(sys.modules); import {module}; print(*set(sys.modules) - before)"
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    return run.stdout.split()


@pytest.mark.parametrize(
    ("module", "most"),
    [("normal.cone", 6), ("adhesive.cone", 13), ("plane.wedge", 10), ("viscoelastic.cone", 13), ("materials", 5)],
)
def test_an_import_is_short(module: str, most: int) -> None:
    """Of the cone, with its compiled files: 1.0 ms over NumPy for 6 files; a package around some costs 0.1 ms."""
    found = imported(f"axicontact.{module}")
    own = {name.removeprefix("axicontact.") for name in found if name.startswith("axicontact.")}
    assert not of_runtime(own) & {*LATE, "graded"}
    assert not set(found) & set(HEAVY)
    assert len(own) <= most, sorted(own)


@pytest.mark.parametrize(
    ("module", "most"),
    [("normal.sphere_tipped_cone", 14), ("normal.gaussian", 12), ("tangential.rounded_cone", 17)],
)
def test_a_graded_module_brings_along_what_its_depth_and_force_need(module: str, most: int) -> None:
    """Of these 2.0 to 2.6 ms over NumPy, where it was 6 to 16 ms for 31 to 36 files."""
    found = imported(f"axicontact.graded.{module}")
    own = {name.removeprefix("axicontact.") for name in found if name.startswith("axicontact.")}
    assert not of_runtime(own) & {*LATE, *GRADED}
    assert not set(found) & set(HEAVY)
    assert len(own) <= most, sorted(own)


def test_a_graded_module_with_adhesion_brings_along_no_fields() -> None:
    own = {name.removeprefix("axicontact.") for name in imported("axicontact.graded.adhesive.sphere_tipped_cone")}
    assert not of_runtime(own) & ({*LATE, *GRADED} - {"inverse"})
    assert len(own) <= 22, sorted(own)


def test_kernels_come_with_the_functions_that_have_them() -> None:
    assert "axicontact._runtime.kernels" not in imported("axicontact.normal.cone")
    assert "axicontact._runtime.kernels" in imported("axicontact.normal.gaussian")


def test_every_module_says_what_it_is_for() -> None:
    """`dir` and `import *` have the functions of the interface alone, `subsurface` its types too."""
    code = """
import importlib, inspect, pathlib, sys
for path in sorted(pathlib.Path(sys.argv[1]).rglob("*.py")):
    parts = path.relative_to(pathlib.Path(sys.argv[1]).parent).with_suffix("").parts
    if any(part.startswith("_") and part != "__init__" for part in parts):
        continue
    name = ".".join(parts).removesuffix(".__init__")
    module = importlib.import_module(name)
    assert dir(module) == sorted(module.__all__), name
    for own in module.__all__:
        value = getattr(module, own)
        home = getattr(value, "__module__", name).replace("_runtime.subsurface.stresses", "subsurface")
        assert inspect.ismodule(value) or (callable(value) and home == name), (name, own)
    public = [k for k, v in vars(module).items() if inspect.isfunction(v) and v.__module__ == name and k[0] != "_"]
    assert set(public) <= set(module.__all__), name
    print(name)
"""
    run = subprocess.run([sys.executable, "-c", code, str(ROOT)], capture_output=True, text=True, check=False)
    assert not run.stderr, run.stderr
    assert len(run.stdout.split()) > 150
