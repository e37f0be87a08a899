"""Every kind of contact on every medium for every kind of profile: a folder that works, or a way to one."""

from __future__ import annotations

import itertools
import re
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path

import pytest
from scenes import composed_from, problems, run_plainly

from axiderive.scene import reading, text
from axiderive.scene.text import SceneError

PROFILES = {
    "compact": "cone", "flat tip": "truncated_cone", "waves": "wavy_paraboloid", "flat": "flat_punch",
    "convex face": "capped_cylinder", "concave face": "concave_paraboloid", "any concave face": "concave_power",
    "expression": "r**2/(2*R)", "algebraic expression": "r**2/sqrt(r**2 + q**2)",
    "any expression": "(1 - 1/cosh(100*r))/1000",
    "strip": "wedge", "concave strip": "concave_parabola", "eccentric": "eccentric_punch", "pressure": "uniform",
    "any power": "power",
}  # fmt: skip
KINDS = (
    "normal", "adhesive", "cohesive", "tangential", "torsion", "viscoelastic", "plane", "loads", "subsurface", "layer",
)  # fmt: skip
SLOW = {("waves", "homogeneous"), ("waves", "power_law")}
"""Quadratures over many waves."""
QUICK = {
    ("flat", "normal"), ("flat", "adhesive"), ("convex face", "normal"), ("concave face", "normal"),
    ("eccentric", "plane"), ("any power", "loads"), ("flat", "viscoelastic"), ("flat", "torsion"),
}  # fmt: skip
"""Composed also where time is short: what no other test of scenes does."""


@dataclass(frozen=True)
class Cell:
    profile: str
    kind: str
    medium: str

    @property
    def source(self) -> str:
        lines = [f'profile = "{PROFILES[self.profile]}"']
        lines += ["[medium]", f'kind = "{self.medium}"']
        value = '{ model = "maxwell" }' if self.kind == "viscoelastic" else "true"
        return "\n".join([*lines, "[physics]", f"{self.kind} = {value}", "[output]", 'formats = ["python"]', ""])

    def advised(self, message: str) -> Cell:
        """What the message tells to do."""
        way = message.split("the nearest is ")[-1] if "the nearest is" in message else message
        kind = re.search(r"(\w+) = true", way)
        found = replace(self, kind=kind[1]) if kind else self
        return replace(found, medium="homogeneous") if 'kind = "homogeneous"' in way else found


CELLS = [Cell(*row) for row in itertools.product(PROFILES, KINDS, ("homogeneous", "power_law"))]


@cache
def refusal(cell: Cell) -> str:
    try:
        reading.read(text.parse("scene.toml", cell.source.encode()))
    except SceneError as error:
        return str(error)
    return ""


@pytest.mark.parametrize("profile", PROFILES)
def test_a_refusal_names_line_rule_and_a_combination_that_is_at_hand(profile):
    """Following the advice ends within three steps: where a profile is not one of its kind, the medium comes next."""
    for cell in (cell for cell in CELLS if cell.profile == profile):
        for _ in range(4):
            message = refusal(cell)
            if not message:
                break
            first = message.splitlines()[0]
            assert re.match(r"scene\.toml:[1-9]\d*: ", first), message
            following = cell.advised(first)
            assert following != cell, message
            cell = following
        else:
            pytest.fail(f"the advice does not end: {message}")


def accepted(cell: Cell) -> bool:
    return not refusal(cell)


ACCEPTED = [cell for cell in CELLS if accepted(cell)]


@pytest.mark.parametrize(
    "cell",
    [
        pytest.param(
            cell,
            id=f"{cell.profile}-{cell.kind}-{cell.medium}",
            marks=[] if (cell.profile, cell.kind) in QUICK and cell.medium == "homogeneous"
            else [pytest.mark.sweep if (cell.profile, cell.medium) in SLOW else pytest.mark.slow],
        )
        for cell in ACCEPTED
    ],
)  # fmt: skip
def test_what_is_accepted_is_emitted_and_its_test_runs(cell, tmp_path: Path):
    result = composed_from(cell.source)
    assert "values agree with the definition" in result.lines[-1]
    assert "values agree" in run_plainly(result, tmp_path)


def test_the_matrix_is_full():
    """Every accepted cell is one of the catalogue or an expression; none is refused that has entries."""
    counts = {kind: sum(cell.kind == kind for cell in ACCEPTED) for kind in KINDS}
    assert counts == {
        "normal": 18, "adhesive": 16, "cohesive": 2, "tangential": 10, "torsion": 2, "viscoelastic": 10, "plane": 5,
        "loads": 2, "subsurface": 8, "layer": 7,
    }  # fmt: skip


@pytest.mark.parametrize(
    ("source", "message"),
    [
        ('profile = "wedge"\n', "wedge is a plane profile; write [physics] plane = true"),
        (
            'profile = "cone"\n[physics]\nloads = true\n',
            "cone is a round profile; write normal = true in place of loads",
        ),
        (
            'profile = "capped_cylinder"\n[physics]\nadhesive = true\n',
            "the edge comes loose at the same depth; the nea",
        ),
        (
            'profile = "flat_punch"\n[physics]\ntangential = true\n',
            "slips as a whole at F_x = mu F; the nearest is nor",
        ),
    ],
)
def test_the_reason_is_given(source, message):
    assert message in problems(source)
