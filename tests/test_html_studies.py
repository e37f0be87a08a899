"""What the web edition shows beside formulas with a key: limits, universal curves, measured errors, the studies."""

from __future__ import annotations

import copy
import itertools
import json
import math
import re
from functools import cache
from html import unescape
from typing import Any

import pytest
from stored_book import CATALOGUE, KEYS, stored
from web_page import Page

from axiderive.book import studies as studies_of_book
from axiderive.book.handbook import page_models
from axiderive.figures.plots import frames
from axiderive.figures.svg import Picture
from axiderive.profiles import load
from axiderive.web import html_sources
from axiderive.web.page import figures
from axiderive.web.site import studies_model

SAMPLE = ("power_law", "rounded_punch", "plane.eccentric_punch", "loads.power")
LARGEST = 1_000_000
"""Bytes of a page."""
NEAR = 0.01
"""Decades by which rounding to a tenth of an SVG unit may move a point; a decade is 8 units or more."""


@cache
def record(name: str) -> dict[str, Any]:
    found: dict[str, Any] = json.loads((CATALOGUE / "evidence" / f"{name}.json").read_bytes())
    return found


STUDIES = {name: record(f"study/{name}") for name in ("error", "speed", "maps", "extremes")}


@pytest.fixture(scope="module")
def derived() -> dict[str, Any]:
    own = [key for key in KEYS if any(key == name or key.startswith(f"{name}.") for name in SAMPLE)]
    return {key: stored(key) for key in own}


@pytest.fixture(scope="module")
def evidence(derived: dict[str, Any]) -> dict[str, Any]:
    return {key: record(key)["evidence"] for key in derived}


@pytest.fixture(scope="module")
def models(derived: dict[str, Any], evidence: dict[str, Any]) -> Any:
    return page_models(derived, evidence)


@pytest.fixture(scope="module")
def site(derived: dict[str, Any], evidence: dict[str, Any], models: Any) -> dict[str, str]:
    modules = {
        str(path.relative_to(CATALOGUE)): path.read_text(encoding="utf-8")
        for path in (CATALOGUE / "axicontact").rglob("*.py")
    }
    return html_sources(derived, evidence, None, models, modules, STUDIES)


def _row(page: str, anchor: str) -> str:
    start = page.index(f'id="{anchor}"')
    return page[start : page.index("</article>", start)]


def test_limits_and_universal_curves_have_an_address_on_the_page(site: dict[str, str], models: Any) -> None:
    count = 0
    for name in SAMPLE:
        shown = [one for block in models[name]["blocks"].values() for one in block.approached]
        # the numbers below the surface stand behind all others
        above = site[f"{name}.html"].partition('<details class="physics" id="about.subsurface"')[0]
        addresses = re.findall(r'<article class="row further" id="([^"]+)"', above)
        assert len(addresses) == len(shown) == len(set(addresses))
        for anchor, one in zip(addresses, shown, strict=True):
            row = _row(site[f"{name}.html"], anchor)
            assert one.tex.replace(r"\begin{aligned}[t]", r"\begin{aligned}") in Page(row).formulas
            assert f"#{anchor}" in Page(row).addresses
        count += len(shown)
    assert count == 17
    assert 'href="cone.html"' not in site["power_law.html"]  # no page in this edition: plain words
    assert 'id="limit.cone"' in site["power_law.html"]
    assert 'id="universal.fgm.adh.d"' in site["power_law.html"]


def test_measured_errors_stand_with_the_evidence_of_their_formula(site: dict[str, str]) -> None:
    """Read off the record, not off the model of the page."""
    measured = record("rounded_punch")["evidence"]["evaluation"]
    for suffix, found in measured.items():
        if suffix == "slope":  # of the rules of p and w; no formula of the page
            continue
        row = unescape(re.sub(r"<span[^>]*>|</span>", "", _row(site["rounded_punch.html"], suffix)))
        for where, part in (("error ", found["bench"]), ("at extreme lengths ", found["extreme"])):
            if "worst_ulp" not in part or part["worst_ulp"] > 1e4:
                continue
            mantissa, _, power = f"{part['worst_ulp']:.2g}".partition("e")
            worst = mantissa + (rf"\times10^{{{int(power)}}}" if power else "")
            assert f"{where}{worst} ulp at {part['points']} points" in row, suffix
    assert "evaluation by Gauss rule" in _row(site["rounded_punch.html"], "p")


def test_errors_of_functions_below_the_surface_stand_with_the_first_of_its_numbers(site: dict[str, str]) -> None:
    measured = record("rounded_punch.sub")["evidence"]["evaluation"]
    row = unescape(re.sub(r"<span[^>]*>|</span>", "", _row(site["rounded_punch.html"], "sub.S0")))
    for name, found in measured.items():
        shown = row.partition(f"{name.replace('_', ' ')}: ")[2].partition(";")[0]
        wanted = [
            f"{part['worst_ulp']:.2g} ulp at {part['points']} points" for part in found.values() if part["points"]
        ]
        assert wanted, name
        assert all(one in shown for one in wanted), (name, shown)
    assert "beside the largest component" in row


def _shown() -> dict[str, Any]:
    return studies_model(studies_of_book.figures(STUDIES, frozenset({"cone.p"})))


def _decade(figure: Picture, upwards: bool) -> tuple[float, float]:
    """Place of 10^0 and length of a decade in SVG units, from the labels of an axis."""
    ticks = {}
    for label in figure.labels:
        power = re.fullmatch(r"\$10\^\{(-?\d+)\}\$", label.text)
        if power and label.kind.startswith("right") == upwards:
            place = (label.top * figure.height if upwards else label.left * figure.width) / 100
            ticks[int(power[1])] = place
    (first, start), (last, end) = min(ticks.items()), max(ticks.items())
    unit = (end - start) / (last - first)
    return start - first * unit, unit


def test_the_points_of_a_panel_are_what_was_measured() -> None:
    """Against the labels of its axes: every method of every formula, in the order of the record."""
    panels = {figure.drawing.anchor: figure for figure in _shown()["error"]["panels"]}
    plots = studies_of_book.plots(STUDIES["error"])
    assert list(panels) == [f"error.{key}" for key in plots]
    for key, methods in plots.items():
        figure = panels[f"error.{key}"]
        lines = [values["points"] for _, look, values in figure.below if look in ("own", "rival")]
        (x0, decade_x), (y0, decade_y) = _decade(figure, upwards=False), _decade(figure, upwards=True)
        assert decade_y < 0 < decade_x
        for text, points in zip(lines, methods.values(), strict=True):
            for pair, (ratio, worst) in zip(text.split(), points, strict=True):
                x, y = map(float, pair.split(","))
                assert abs((x - x0) / decade_x - math.log10(ratio)) < NEAR, key
                assert abs((y - y0) / decade_y - max(math.log10(max(worst, 1e-16)), -16)) < NEAR, key


@pytest.mark.parametrize("side", ["naive", "emitted"])
def test_the_cells_of_a_map_have_the_level_of_their_error(side: str) -> None:
    for figure, one in zip(_shown()["maps"]["figures"], _maps_in_order(), strict=True):
        frames = [values["points"].split() for _, look, values in figure.below if look == "frame"]
        corners = [tuple(map(float, pair.split(","))) for pair in frames[side == "emitted"]]
        (left, bottom), _, (right, top), _ = corners
        width, height = right - left, bottom - top
        squares = [
            (level, tuple(map(float, numbers)))
            for element, level, values in figure.below
            if element == "path"
            for numbers in re.findall(r"M([\d.]+) ([\d.]+)H([\d.]+)V([\d.]+)H[\d.]+z", values["d"])
        ]
        cells = one[side]["worst"]
        for i, row in enumerate(cells):
            for j, worst in enumerate(row):
                x, y = left + width * (j + 0.5) / len(row), top + height * (1 - (i + 0.5) / len(cells))
                here = [level for level, (x1, y1, x2, y2) in squares if x1 < x < x2 and y2 < y < y1]
                assert here == ([] if worst is None else [_level(worst)]), (one["key"], i, j)


def _maps_in_order() -> list[dict[str, Any]]:
    """Those of two ratios come first."""
    return sorted(STUDIES["maps"]["maps"], key=lambda one: -len(one["axes"]))


def _level(ulps: float) -> str:
    return "level6" if ulps < 0 else f"level{sum(ulps > bound for bound in (5, 1e3, 1e6, 1e9, 1e12))}"


def test_the_study_page_is_closed_in_itself(site: dict[str, str]) -> None:
    pages = {path: Page(text) for path, text in site.items() if path.endswith(".html")}
    page = pages["study.html"]
    assert len(site["study.html"].encode()) < LARGEST
    assert len(set(page.ids)) == len(page.ids)
    for address in page.addresses:
        target, _, fragment = address.partition("#")
        if address != "data:,":
            assert (target or "study.html") in site, address
            assert not fragment or fragment in pages[target or "study.html"].ids, address
    assert {"error", "speed", "maps", "extremes"} <= set(page.ids)
    assert {"error.cone.p", "speed.cone.p", "map.rounded_punch.w"} <= set(page.ids)
    assert "rounded_punch.html#p" in page.addresses
    assert "cone.html#p" not in page.addresses
    assert "\\" not in re.sub(r'<span class="tex"[^>]*>[^<]*</span>', "", site["study.html"])
    assert 'href="study.html"' in site["index.html"]


def test_a_page_leads_to_the_errors_of_its_formulas_against_time(site: dict[str, str]) -> None:
    page = Page(site["rounded_punch.html"])
    measured = {row["key"] for row in STUDIES["error"]["rows"] if row["key"].startswith("rounded_punch.")}
    assert {address for address in page.addresses if "#error." in address} == {
        f"study.html#error.{k}" for k in measured
    }
    assert "about.timing" in page.ids
    assert "about.timing" not in Page(site["loads.power.html"]).ids


def test_a_formula_without_a_certificate_says_why(site: dict[str, str]) -> None:
    assert "not certified: rounded_punch.ad is the root of an equation" in _row(site["rounded_punch.html"], "ad")


def test_frames_without_a_body_are_drawn(site: dict[str, str]) -> None:
    assert {"plot.pressure", "plot.displacement"} <= set(Page(site["loads.power.html"]).ids)
    assert {"plot.pressure", "plot.inclination"} <= set(Page(site["plane.eccentric_punch.html"]).ids)


def test_a_study_that_was_not_made_leaves_its_part_out() -> None:
    one = copy.deepcopy(STUDIES)
    del one["maps"]
    shown = studies_model(studies_of_book.figures(one, frozenset()))
    assert shown["maps"] is None
    assert len(shown["extremes"]) == len({(r["limit"], r["key"].rpartition(".")[0]) for r in one["extremes"]["rows"]})


def test_every_extreme_case_has_an_address(site: dict[str, str]) -> None:
    page = Page(site["study.html"])
    rows = {(r["limit"], r["key"].rpartition(".")[0]) for r in STUDIES["extremes"]["rows"]}
    addresses = [name for name in page.ids if name.startswith("extreme.")]
    assert len(addresses) == len(rows)
    assert {f"#{name}" for name in addresses} <= set(page.addresses)
    assert all(re.fullmatch(r"[\w.-]+", name) for name in addresses), addresses


def test_graded_plots_stand_with_the_graded_contact(models: Any) -> None:
    """Of the paraboloid and the cone; what grading does to them it does to the others."""
    assert models["loads.power"]["graded"] == models["power_law"]["graded"] == ()
    drawn = frames(load("paraboloid"), stored("paraboloid"), stored("paraboloid.fgm"))
    shown = figures({"plots": (), "curves": (), "axes": (), "graded": drawn, "stress": (), "first": "normal"})
    assert [figure.drawing.anchor for figure in shown["graded.normal"]] == [
        "plot.graded-pressure",
        "plot.graded-displacement",
    ]
    pressure, _ = drawn
    assert [curve.label for curve in pressure.curves] == ["-0.5", "0", "0.5"]
    # the mean of p over the circle is its mean: the trapezoidal rule in r^2, coarse beside the tip and the edge
    for curve in pressure.curves:
        points = curve.rows
        steps = itertools.pairwise([(0.0, points[0][1]), *points, (1.0, points[-1][1])])
        mean = sum((y0 + y1) / 2 * (x1 * x1 - x0 * x0) for (x0, y0), (x1, y1) in steps)
        assert mean == pytest.approx(1.0, abs=0.02)
