"""Parts of the book that follow records: study figures, matrix, domains; nothing in them is typed."""

from __future__ import annotations

import copy
import itertools
import json
import math
import re
from pathlib import Path
from typing import Any

import pytest
from stored_book import stored

from axiderive import notation as nt
from axiderive.book import evidence, studies
from axiderive.book.handbook import templates
from axiderive.book.page import panel as panel_of
from axiderive.build.pdf import problems
from axiderive.physics.systems import pool_of
from axiderive.print.words import domain, prose

CATALOGUE = Path(__file__).parents[1] / "catalogue"
STUDIES, PROFILES = CATALOGUE / "evidence" / "study", CATALOGUE / "handbook" / "profiles"


@pytest.fixture(scope="module")
def records() -> dict[str, Any]:
    return {path.stem: json.loads(path.read_bytes()) for path in sorted(STUDIES.glob("*.json"))}


def test_the_error_panels_show_every_method_where_the_record_has_it(records: dict[str, Any]) -> None:
    record = records["error"]
    figure = studies.error_panels(record, frozenset({"cone.p"}))
    plots = studies.plots(record)
    assert [panel.key for panel in figure.panels] == list(plots)
    assert [panel.key for panel in figure.panels if panel.known] == ["cone.p"]
    (x0, low), (x1, high) = figure.xticks[0], figure.xticks[-1]
    for panel in figure.panels:
        plot = plots[panel.key]
        assert len(panel.lines) == len(plot)
        for line, rows in zip(panel.lines, plot.values(), strict=True):
            for (x, y), (ratio, worst) in zip(line.points, rows, strict=True):
                assert low + (x - x0) * (high - low) / (x1 - x0) == pytest.approx(math.log10(ratio), abs=0.02)
                assert y / studies.HEIGHT * 16 - 16 == pytest.approx(max(math.log10(worst), -16), abs=1e-9)
            assert 0 <= line.place[0] <= studies.WIDTH
            assert 0 <= line.place[1] <= studies.HEIGHT


def test_the_panels_of_a_line_name_their_axes_and_fit_on_it(records: dict[str, Any]) -> None:
    """The names of the vertical axes take room in the first column alone, and all three have 166 mm."""
    found = studies.spread(studies.figures(records, frozenset()), records)
    text = templates().get_template("study.tex.j2").render(spread=found, ratios=[])
    lines = text.partition("Where a printed")[0].split(r"\hbox to\textwidth{")[1:]
    assert (
        sum(line.count(r"\begin{tikzpicture}") for line in lines) == len(found["error"].panels) == len(studies.PANELS)
    )
    for line in lines:
        panels = line.count(r"\begin{tikzpicture}")
        assert line.count("run time over that of the function") == panels
        assert line.count("worst relative error") == 1
        assert "worst relative error" in line.partition(r"\end{tikzpicture}")[0]
        widths = [
            float(right) + float(left)
            for left, right in re.findall(r"bounding box\] \(-([\d.]+),-8\) rectangle \(([\d.]+),", line)
        ]
        assert len(widths) == panels
        assert sum(widths) < 166 - 2 * 2


def test_the_digits_that_a_printed_formula_keeps_are_those_of_the_record(records: dict[str, Any]) -> None:
    found = studies.spread(studies.figures(records, frozenset({"cone.p"})), records)
    assert [one.key for one in found["maps"].square] == list(studies.MAPS)
    rows = {row["key"]: row for row in found["digits"]}
    assert rows["cone.p"]["known"]
    assert not rows["cone.w"]["known"]
    assert not any(key.startswith("power_law") for key in rows)  # over an exponent, not a ratio
    for one in records["maps"]["maps"]:
        for (cell, _), digits in zip(studies.CELLS, rows.get(one["key"], {"digits": ()})["digits"], strict=False):
            ulps = one["naive"]["worst"][0][cell]
            assert 10.0 ** -(int(digits) + 1) < max(ulps, 1.0) * 2.0**-53 or int(digits) == 0
            assert max(ulps, 1.0) * 2.0**-53 <= 10.0 ** -int(digits) or int(digits) == 0


def test_a_case_that_is_added_to_a_record_is_drawn(records: dict[str, Any]) -> None:
    record = copy.deepcopy(records["error"])
    one = {"key": "cone.fgm.adh.p", "setting": ""}
    record["rows"] += [
        one | {"method": "emitted", "ratio": 1.0, "worst": 3e-16},
        one | {"method": "a_method & more", "ratio": 1e9, "worst": 2e-5},
    ]
    figure = studies.error_panels(record, frozenset())
    assert figure.panels[-1].key == "cone.fgm.adh.p"
    assert figure.methods[-1][1] == r"a\_method \& more"
    assert max(x for panel in figure.panels for line in panel.lines for x, _ in line.points) <= studies.WIDTH
    assert studies.figures({}, frozenset()) == {"error": None, "speed": None, "maps": None, "extremes": None}


def test_the_heat_maps_colour_every_cell_by_its_error(records: dict[str, Any]) -> None:
    record = records["maps"]
    figure = studies.error_maps(record, frozenset())
    shown = {one.key: one for one in (*figure.plain, *figure.square)}
    assert set(shown) == {one["key"] for one in record["maps"]}
    bounds = {f"level{i}": bound for i, bound in enumerate((*studies.LEVELS, math.inf, -1.0))}
    for one in record["maps"]:
        for way in ("naive", "emitted"):
            cells = one[way]["worst"]
            coloured = 0
            for level in getattr(shown[one["key"]], way).levels:
                for x, y, width, tall in level.corners:
                    i = round(y * len(cells) / shown[one["key"]].height)
                    j = round(x * len(cells[0]) / studies.SIDE)
                    for value in cells[i][j : j + round(width * len(cells[0]) / studies.SIDE)]:
                        coloured += 1
                        bound = bounds[level.look]
                        lower = max((b for b in bounds.values() if 0 < b < bound), default=0.0)
                        assert value == -1 if bound < 0 else lower < value <= bound or value == lower == 0
                    assert tall == pytest.approx(shown[one["key"]].height / len(cells), abs=1e-3)
            assert coloured == sum(value is not None for row in cells for value in row)


def test_the_table_of_extremes_counts_every_case(records: dict[str, Any]) -> None:
    rows = studies.extremes(records["extremes"])
    assert sum(row["cases"] for row in rows) == len(records["extremes"]["rows"])
    limits = [row["limit"] for row in rows]
    assert len({limit for i, limit in enumerate(limits) if limit != limits[i - 1]}) == len(set(limits))
    made = [
        {"limit": "R -> infinity", "key": "x.p", "emitted": 2e-16, "naive": None, "ulps": 1.5},
        {"limit": "R -> infinity", "key": "x.w", "emitted": 3e-16, "naive": 0.25, "ulps": None},
    ]
    (row,) = studies.extremes({"rows": made})
    assert (row["limit"], row["keys"], row["lost"], row["refused"]) == (r"$R\to \infty$", "p, w", 1, 0)
    assert (row["ulps"], row["emitted"], row["naive"]) == ("$1.5$", r"$3\times10^{-16}$", "$0.25$")


def test_the_cells_of_the_matrix_count_by_kind() -> None:
    entries = {
        "d": {"status": "closed", "certified": True, "checks": []},
        "p": {"status": "integral", "certified": False, "checks": [{"outcome": "passed", "worst": "1", "digits": 46}]},
        "aF": {"status": "root", "certified": False, "checks": [{"outcome": "passed", "worst": "1", "digits": 50}]},
    }
    cells = evidence.matrix(["cone", "cone.vis"], {"cone": {"entries": entries}, "cone.vis": {"entries": {}}})
    own = cells["profiles"]["cone"]
    assert own["normal"] == "1 ✓, 1 ∫46, 1 √50"
    assert own["viscoelastic"] == evidence.NOT_VERIFIED


def test_what_is_known_of_the_formulas_is_counted() -> None:
    checks = [{"outcome": "passed", "worst": "1", "digits": 46}, {"outcome": "failed", "worst": "1", "digits": 3}]
    entries = [
        {"status": "closed", "certified": True, "twice": {"shown": True}, "checks": checks},
        {"status": "root", "certified": True, "twice": {"shown": False}, "checks": checks[:1]},
        {"status": "integral", "certified": False, "checks": [{"outcome": "passed", "worst": "1", "digits": 41}]},
        {"status": "equation", "certified": False, "checks": [{"outcome": "passed", "worst": "1", "digits": 13}]},
        {"status": "closed", "certified": False, "checks": []},
    ]
    counted = {"formulas": 5, "certified": 2, "twice": 1, "closed": 1, "integral": 1, "root": 0, "equation": 1}
    counted["expansion"] = 0
    counted["digits"] = 13
    counted["least"] = 0  # the last one agreed with nothing
    assert evidence.coverage(entries) == counted


def test_domains_are_printed_with_printed_symbols() -> None:
    """tau > 0 is the domain of the relaxation time, whose name is another one."""
    for record in nt.all_notation():
        text = domain(record)
        bare = re.sub(r"\\(?:mathrm|text|operatorname)\{[^}]*\}", "", text)
        assert not re.findall(r"(?<![\\A-Za-z])[A-Za-z]{2,}", bare), text
        assert bool(text) == bool(record.domain), record.name


def test_a_bound_is_printed_once() -> None:
    """The eccentricity once stood with its domain, -a < e < a, and with the rule abs(e) < a behind it."""
    profile = pool_of("plane.eccentric_punch").load("eccentric_punch")
    lines = dict(panel_of(profile, stored("plane.eccentric_punch"), plane=True))
    assert lines["Parameters"] == r"$a>0$, $\lvert e\rvert<a$"


@pytest.mark.parametrize(
    ("text", "printed"),
    [
        ("15.6 at k = -0.5 and", "15.6 at $k=-0.5$ and"),
        ("k = 0.3, -1/2, 1.8", "$k=0.3$, $-1/2$, 1.8"),
        ("for -1 < k < 1", "for $-1<k<1$"),
        ("a - b, points 3-4", "$a-b$, points 3-4"),
    ],
)
def test_signs_of_numbers_belong_to_the_mathematics(text: str, printed: str) -> None:
    assert prose(text) == printed


def test_an_overfull_line_of_the_main_file_is_not_blamed_on_the_last_profile() -> None:
    sources = {
        "book.tex": b"\\documentclass{article}\n" + b"text\n" * 30 + b"%% matrix cone\n" + b"row\n" * 9,
        "profiles/cone.tex": b"%% cone.p\nrow\n",
    }
    log = "(./book.tex (./profiles/cone.tex [1])\nOverfull \\hbox (26.0pt too wide) in alignment at lines 34--36\n"
    assert problems(log, sources) == ["book.tex:34: [matrix] line is 9.1 mm too wide"]


SKETCHED = sorted(path.name for path in PROFILES.glob("*.tex") if "d/pointer" in path.read_text())


@pytest.mark.parametrize("name", SKETCHED)
def test_the_arrow_of_the_displacement_ends_on_the_surface(name: str) -> None:
    text = (PROFILES / name).read_text()
    (x, top), (_, end) = _drawn(text, "d/pointer")[-1]
    right = next(points for points in _drawn(text, "d/surface") if points[0][0] > 0)
    (x1, y1), (x2, y2) = next(pair for pair in itertools.pairwise(right) if pair[0][0] <= x <= pair[1][0])
    assert top == 0
    assert end == pytest.approx(y1 + (y2 - y1) * (x - x1) / (x2 - x1), abs=3e-3)


def _drawn(text: str, look: str) -> list[list[tuple[float, ...]]]:
    """The points of the lines of a look."""
    lines = re.findall(rf"^ \\path\[[^]]*{look}\] (.*);$", text, re.MULTILINE)
    return [[tuple(map(float, point.split(","))) for point in re.findall(r"\(([^)]*)\)", line)] for line in lines]
