"""The same text of every result, whatever the hash seed and the version of SymPy."""

from __future__ import annotations

import difflib
import hashlib
import os
import subprocess
import sys
from pathlib import Path

import pytest
import sympy as sp

import axiderive
from axiderive import profiles

NORMAL = """
from axiderive import profiles
from axiderive.physics import normal
from axiderive.physics.medium import GRADED, HOMOGENEOUS

for profile in map(profiles.load, profiles.NAMES):
    for medium in (HOMOGENEOUS, GRADED):
        for entry in normal.derive(profile, medium).values():
            print(entry.text())
"""
EVERYTHING = (
    NORMAL
    + """
from axiderive.physics import adhesive, plane, tangential, viscoelastic
from axiderive.profiles import plane as plane_profiles

for profile in map(profiles.load, profiles.NAMES):
    results = [viscoelastic.derive(profile)]
    if profile.contact == "compact":
        results += [rule.derive(profile, medium) for rule in (adhesive, tangential) for medium in (HOMOGENEOUS, GRADED)]
    for entry in (entry for entries in results for entry in entries.values()):
        print(entry.text())
for profile in map(plane_profiles.load, plane_profiles.NAMES):
    for entry in plane.derive(profile).values():
        print(entry.text())
"""
)
VERSIONS = ("1.12", "1.13.3", "1.14.0")


def results(script: str, seed: int, python: str | Path = sys.executable) -> str:
    """The text of entries from a fresh interpreter."""
    sources = str(Path(axiderive.__file__).parents[1])
    environment = {**os.environ, "PYTHONHASHSEED": str(seed), "PYTHONPATH": sources}
    command = [str(python), "-c", script]
    return subprocess.run(command, env=environment, capture_output=True, text=True, timeout=600, check=True).stdout


def same(first: str, second: str) -> None:
    """Compare by digest; show the differing lines, not two long texts."""
    differing = "\n".join(list(difflib.unified_diff(first.splitlines(), second.splitlines(), lineterm="", n=1))[:40])
    digests = [hashlib.sha256(text.encode()).hexdigest() for text in (first, second)]
    assert digests[0] == digests[1], differing


@pytest.mark.slow
def test_same_text_for_another_hash_seed():
    text = results(NORMAL, seed=0)
    assert all(f"{name}.F [" in text for name in profiles.NAMES)
    same(text, results(NORMAL, seed=1))


@pytest.fixture(scope="module")
def everything() -> str:
    return results(EVERYTHING, seed=0)


@pytest.mark.slow
@pytest.mark.parametrize("seed", [1, 2, 3, 17, 4242])
def test_same_text_for_every_hash_seed(everything, seed):
    same(everything, results(EVERYTHING, seed))


@pytest.mark.slow
@pytest.mark.parametrize("version", [v for v in VERSIONS if v != sp.__version__])
def test_same_text_for_every_sympy(everything, version, tmp_path):
    same(everything, results(EVERYTHING, 0, _environment(version, tmp_path)))


def _environment(version: str, folder: Path) -> Path:
    """An interpreter with this SymPy, or a skip where no package index can be reached."""
    subprocess.run([sys.executable, "-m", "venv", str(folder)], check=True, timeout=300, capture_output=True)
    python = folder / "bin" / "python"
    install = [str(python), "-m", "pip", "install", "--quiet", f"sympy=={version}", "mpmath<1.4"]
    done = subprocess.run(install, capture_output=True, text=True, timeout=600, check=False)
    if done.returncode:
        pytest.skip(f"SymPy {version} cannot be installed: {done.stderr.strip().splitlines()[-1]}")
    return python
