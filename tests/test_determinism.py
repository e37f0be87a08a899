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
from stored_book import KEYS, stored

import axiderive

EVERYTHING = """
import json
from axiderive.physics.systems import problems
from axiderive.store.records import entry_record, read_entry

for problem in problems():
    for entry in problem.derive().values():
        back = read_entry(json.loads(json.dumps(entry_record(entry))), problem.profile)
        assert back == entry and back.primitives == entry.primitives, entry.key
        print(back.text())
"""
"""Derives all, and prints what a record of it reads as: what is published was read back."""
VERSIONS = ("1.12", "1.13.3", "1.14.0")
"""The oldest is tried with the slow tests, those between with `-m sweep`."""


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


@pytest.fixture(scope="module")
def everything() -> str:
    """The text of the entries as a build has stored them, which has another hash seed than those below."""
    return "".join(f"{entry.text()}\n" for key in KEYS for entry in stored(key).values())


@pytest.mark.slow
def test_same_text_for_another_hash_seed(everything: str) -> None:
    """The tests below have seeds of their own."""
    same(everything, results(EVERYTHING, 1))


@pytest.mark.parametrize(
    ("version", "seed"),
    [
        pytest.param(version, seed, marks=pytest.mark.slow if version == VERSIONS[0] else pytest.mark.sweep)
        for seed, version in enumerate(VERSIONS, 2) if version != sp.__version__
    ],
)  # fmt: skip
def test_same_text_for_every_sympy(everything: str, version: str, seed: int, tmp_path: Path) -> None:
    same(everything, results(EVERYTHING, seed, _environment(version, tmp_path)))


def _environment(version: str, folder: Path) -> Path:
    """An interpreter with this SymPy, or a skip where no package index can be reached."""
    subprocess.run([sys.executable, "-m", "venv", str(folder)], check=True, timeout=300, capture_output=True)
    python = folder / "bin" / "python"
    install = [str(python), "-m", "pip", "install", "--quiet", f"sympy=={version}", "mpmath<1.4"]
    done = subprocess.run(install, capture_output=True, text=True, timeout=600, check=False)
    if done.returncode:
        pytest.skip(f"SymPy {version} cannot be installed: {done.stderr.strip().splitlines()[-1]}")
    return python
