"""The displacement under a prescribed pressure as it is emitted, by its measured errors."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import mpmath
import pytest

import axicontact
from axicontact.loads import power
from axiderive.code.module import PLACE, runtime_sources
from axiderive.code.physics import loads
from axiderive.physics.systems import problem
from axiderive.stable.measure import closure
from axiderive.stable.records import record

mp = mpmath.mp.clone()
mp.dps = 40
ROOT = Path(axicontact.__file__).parents[1]
FRESH = {path.relative_to(ROOT).as_posix(): path.read_text() for path in (ROOT / "axicontact" / PLACE).rglob("*.py")}
FRESH |= {f"axicontact/{path}": text for path, text in runtime_sources().items()}
"""The runtime, what is not generated as it stands in the engine."""


def measured(name: str, runtime: Mapping[str, str] = FRESH) -> dict[str, Any]:
    """The errors of the displacement under a prescribed pressure."""
    own = problem(f"loads.{name}")
    entries = own.derive()
    sources = {**runtime, own.module: loads.module(entries).source()}
    found: dict[str, Any] = record(own.key, closure(sources, own.module), entries)["w"]
    return found


def test_the_displacement_under_a_hertzian_pressure_is_a_kernel() -> None:
    """The printed formula cancels far away."""
    row = measured("hertzian")
    assert row["form"] == "kernel"
    assert row["extreme"]["worst_ulp"] <= 5.0
    assert row["bench"]["naive"]["worst_ulp"] > 1e6


@pytest.mark.parametrize(
    ("name", "bound", "constant", "coarser"),
    [("uniform", 6.5, "STEPS, SHORTEST = 7,", "STEPS, SHORTEST = 5,"), ("power", 6.5, "= 44.0, 0.23", "= 44.0, 0.29")],
)
def test_functions_of_the_runtime_under_a_pressure(name: str, bound: float, constant: str, coarser: str) -> None:
    """Complete elliptic integrals, 6.3 units at 8000 points, and any exponent, 3.2.

    Fewer means or longer steps than were found to be enough are seen.
    """
    row = measured(name)
    assert max(row[domain]["worst_ulp"] for domain in ("bench", "extreme")) <= bound
    assert row["bench"]["lost"] == row["extreme"]["lost"] == 0
    path = f"axicontact/{PLACE}/physics/circle.py"
    assert constant in FRESH[path]
    worse = measured(name, runtime=FRESH | {path: FRESH[path].replace(constant, coarser)})
    assert max(worse[domain]["worst_ulp"] for domain in ("bench", "extreme")) > 10 * bound


@pytest.mark.parametrize(
    ("r", "s"), [(0.9998091099792111, 907.5445631480933), (0.9994079197006065, 350127.98456624727)]
)
def test_displacement_under_a_pressure_of_a_large_exponent(r: float, s: float) -> None:
    """What a point is beside the middle of the path: as a difference it lost 10 and 308 units of the last place."""
    x, n = mp.mpf(r), mp.mpf(s)
    wanted = mp.sqrt(mp.pi) * mp.gamma(n + 2) / (n + 1) / mp.gamma(n + 1.5) * mp.hyp2f1(-n - 0.5, 0.5, 1, x * x)
    found = power.displacement(r, a=1.0, p_0=1.0, s=s, E_star=1.0)
    assert abs(found / wanted - 1) * 2**52 <= 4.5
