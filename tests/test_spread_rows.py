"""Rows of a spread that no entry stands behind: limits, universal curves, measured errors, read back as printed."""

from __future__ import annotations

import copy
import math
import re
from typing import Any

import pytest
from stored_book import evidence, stored

from axiderive.figures.given import axes_of
from axiderive.figures.plots import frames
from axiderive.physics.systems import problem
from axiderive.profiles import NAMES, load
from axiderive.readback.claims import wrong
from axiderive.readback.source import Further
from axiderive.rows.approaches import Further as Printed
from axiderive.rows.approaches import Rows, limit_rows
from axiderive.rows.blocks import blocks, every
from axiderive.rows.laws import power_of_depth, universal_rows
from axiderive.web.page import measured

WITH_LIMITS = [name for name in NAMES if load(name).limits]


def _rows(name: str, record: dict[str, Any] | None = None) -> Rows:
    return limit_rows(load(name), stored(name), record or evidence(name))


def _wrong(one: Printed, tex: str | None = None) -> bool:
    """Whether the row, or another text in its place, is not what its entries give."""
    return wrong(Further(one.kind, one.keys, one.small.strip("$"), tex or one.tex), stored)


@pytest.mark.parametrize("name", WITH_LIMITS)
def test_every_limit_of_a_profile_is_printed(name: str) -> None:
    assert len(_rows(name)) == len(load(name).limits)


def test_a_limit_that_was_not_checked_is_not_printed() -> None:
    failed = copy.deepcopy(evidence("rounded_punch"))
    for check in failed["entries"]["F"]["checks"]:
        if check["compared"].startswith("limit"):
            check["outcome"] = "failed"
    (one,) = _rows("rounded_punch", failed)
    assert r"g(a)\to" in one.tex
    assert r"F_{\mathrm N}\to" not in one.tex
    assert _rows("rounded_punch", {"entries": {}}) == []


POWER_LAWS = ("cone", "paraboloid", "quartic", "sextic", "power_law")
ADHESIVE = [f"{name}{group}" for name in POWER_LAWS for group in (".adh", ".fgm.adh")]


def _universal(key: str) -> Rows:
    return universal_rows(key, stored(key.removesuffix(".adh"))["d"], problem(key).system.medium)


@pytest.mark.parametrize("key", ADHESIVE)
def test_the_universal_curve_is_the_adhesive_contact_over_its_pull_off(key: str) -> None:
    rows = _universal(key)
    assert rows
    for one in rows:
        assert not _wrong(one), one.tex


@pytest.mark.parametrize("key", ["cone.adh", "power_law.adh", "power_law.fgm.adh"])
def test_no_changed_digit_of_a_universal_curve_passes(key: str) -> None:
    mutants = 0
    for one in _universal(key):
        text = one.tex
        for match in re.finditer(r"\d", text):
            changed = text[: match.start()] + str(int(match[0]) % 9 + 1) + text[match.end() :]
            assert _wrong(one, changed), changed
            mutants += 1
    assert mutants >= 4


def test_only_one_power_of_the_radius_has_a_universal_curve() -> None:
    for name in NAMES:
        entries = stored(name)
        if "d" in entries:
            assert (power_of_depth(entries["d"]) is None) == (name not in POWER_LAWS), name


def test_further_rows_stand_in_their_blocks() -> None:
    derived = {key: stored(key) for key in ("power_law", "power_law.adh")}
    found = blocks("power_law", derived, every("power_law", derived), {}, {"power_law": evidence("power_law")})
    labels = [[re.sub(r"\\hyperref\[.*?\]|[{}]", "", row.label) for row in line] for line in found["normal"].further]
    assert labels == [["Axis"]]  # the special cases stand in a table
    assert [row.label for row in found["normal"].approached if row.ruled][:2] == ["Edge", "Far field"]
    assert [row.label for line in found["adhesive"].further for row in line] == [
        "Universal curve",
    ]


def test_measured_errors_in_words() -> None:
    errors = {"points": 30, "worst_ulp": 3.5, "share_above_5": 0.0, "lost": 0}
    ruled = {"form": "rule", "nodes": [24, 32], "bench": errors | {"naive": errors | {"worst_ulp": 1.6e17}},
             "extreme": {"points": 19, "lost": 19, "share_above_5": 1.0}}  # fmt: skip
    plain = {"form": "kernel", "nodes": [], "bench": errors | {"naive": errors | {"worst_ulp": 3.9e9, "lost": 2}},
             "extreme": {"points": 0}}  # fmt: skip
    assert measured(ruled) == (
        "evaluation by Gauss rule, 24, 32 nodes; error $3.5$ ulp at 30 points, at extreme lengths all 19 lost,"
        " of the formula as printed no digit"
    )
    assert measured(plain) == (
        "evaluation by special function; error $3.5$ ulp at 30 points,"
        r" of the formula as printed $3.9\times10^{9}$ ulp at 30 points (2 lost)"
    )
    assert measured({}) == ""


PAIR = re.compile(r"\(([-\d.e]+),([-\d.e]+)\)")


def test_the_frames_of_a_prescribed_pressure_show_its_displacement() -> None:
    """Uniform pressure: w = 2 p_0 a/E* in the middle, 4/pi at the edge; far away that of the whole force."""
    entries = stored("loads.uniform")
    pressure, displacement = axes_of(entries["w"].profile, entries)
    assert {y for _, y in pressure.curves[0].rows} == {1.0}
    shown = dict(displacement.curves[0].rows)
    assert shown[min(shown)] == pytest.approx(2.0, abs=2e-3)
    below, above = max(x for x in shown if x < 1), min(x for x in shown if x > 1)
    assert shown[above] < 4 / math.pi < shown[below]
    last = max(shown)
    assert shown[last] == pytest.approx(1 / last * (1 + 1 / (8 * last**2)), rel=2e-3)


def test_the_frames_of_the_eccentric_punch_show_a_pressure_of_mean_one() -> None:
    entries = stored("plane.eccentric_punch")
    pressure, tilt = axes_of(entries["p"].profile, entries)
    assert [curve.label for curve in pressure.curves] == ["0", "0.25", "0.5", "0.75"]
    x, middle = min(pressure.curves[0].rows, key=lambda point: abs(point[0]))
    assert abs(x) < 0.1
    assert middle == pytest.approx(2 / math.pi / math.sqrt(1 - x * x), rel=1e-4)
    lifted = pressure.curves[-1].rows
    assert all(y == 0 for x, y in lifted if x < 0)  # zero beyond 4 e - 3 a = 0
    slope = [y / x for x, y in tilt.curves[0].rows if 0 < x < 0.5]
    assert max(slope) == pytest.approx(4.0, rel=1e-4) == min(slope)
    assert tilt.curves[0].rows[-1][1] > 4.0


def test_the_displacement_beside_a_graded_punch_is_that_of_its_formula() -> None:
    """Homogeneous: 2/pi arcsin(a/r), one at the edge; a medium that is softer at its surface sinks less around."""
    entries = stored("flat_punch")
    _, beside = frames(entries["F"].profile, entries, stored("flat_punch.fgm"))
    plain, softer = (dict(curve.rows) for curve in beside.curves[1:])
    assert max(plain) == 3.0
    for r in plain.keys() - {1.0}:
        assert plain[r] == pytest.approx(2 / math.pi * math.asin(1 / r), rel=1e-3)
        assert softer[r] < plain[r]
