"""What the pages of the web edition say without a browser: headings, captions, references, colours, names."""

from __future__ import annotations

import itertools
import json
import re
from functools import cache

import pytest
from stored_book import stored
from web_page import Page

from axiderive.profiles import load
from axiderive.readback import fields
from axiderive.rows import fields as numbers
from axiderive.web.search import anchor_of
from axiderive.web.words import symbol

READABLE = 4.5
"""Contrast of text with its ground that WCAG 2.2 asks for at level AA."""


def test_headings_go_down_one_level_at_a_time(site: dict[str, str]) -> None:
    for path in (path for path in site if path.endswith(".html")):
        levels = [int(level) for level in re.findall(r"<h([1-6])[ >]", site[path])]
        assert levels[0] == 1, path
        assert levels.count(1) == 1, path
        assert all(after <= before + 1 for before, after in itertools.pairwise(levels)), path


def test_every_picture_says_what_is_seen(site: dict[str, str]) -> None:
    found: list[str] = []
    for path in (path for path in site if path.endswith(".html")):
        seen = re.findall(r'<div class="canvas" role="img" aria-label="([^"]+)">', site[path])
        assert site[path].count("<figure ") == len(seen), path
        assert site[path].count('<svg viewBox="') == site[path].count('aria-hidden="true"'), path
        found += seen
    assert len(found) > 12
    assert "Plot of p/p\N{COMBINING MACRON} over r/a; curves: Hertz, flat punch, p/p\N{COMBINING MACRON}" in found
    assert any(one.startswith("Section through the contact:") and "marked are d, a, θ, w" in one for one in found)


def test_equations_lead_to_the_chapter_and_misprints_to_their_errata(site: dict[str, str]) -> None:
    assert '<a href="chapter11.html#eq.11.29">(11.29)</a>' in site["cone.html"].partition("about.derivation")[2]
    row = site["chapter11.html"].partition('id="eq.11.66"')[2].partition("</tr>")[0]
    assert '<a class="misprint" href="#erratum.11.66">misprint</a>' in row
    assert 'id="f"' in site["cone.html"]
    assert 'id="f"' not in site["loads.hertzian.html"]


def test_the_matrix_is_ordered_by_chapter(site: dict[str, str]) -> None:
    """Two profiles of one name are told apart by their chapter, and 2 √50 is no product."""
    table = site["index.html"].partition('<table class="matrix">')[2].partition("</table>")[0]
    heads = re.findall(r'<th scope="rowgroup">([^<]+)</th>', table)
    assert heads == ["Compact contact", "Complete contact", "Plane contact", "Prescribed pressure", "Elastic constants"]
    assert "√<sub>50</sub>" in table
    assert not re.search(r"[○∫√]\d", table)


@cache
def read_back() -> frozenset[str]:
    """The formulas of the numbers below the surface that are compared with their entries."""
    return frozenset(one.tex.replace(r"\begin{aligned}[t]", r"\begin{aligned}") for one in fields.numbers(stored))


@pytest.mark.parametrize("name", ["cone", "flat_punch"])
def test_the_numbers_below_the_surface_are_those_that_were_read_back(site: dict[str, str], name: str) -> None:
    """The keys of all nine stand there, and every formula of the section is one of those that are compared."""
    page = Page(site[f"{name}.html"])
    own = Page(site[f"{name}.html"].partition('id="about.subsurface"')[2].partition("<section")[0])
    assert len(set(page.ids)) == len(page.ids)
    assert {f"sub.{suffix}" for suffix in stored(f"{name}.sub")} <= set(own.ids)
    shown = set(own.formulas) & read_back()
    parts = numbers.parts(load(name))
    assert {numbers.total(parts), *(tex for _, tex in numbers.shorthands())} <= shown
    assert {numbers.beside(line) for n in parts for line in numbers.lines(n)} <= shown
    assert {tex for tex in own.formulas if "=" in tex} - shown <= {"n=0", "n=1", "g'=1", "g'=t^{n-1}"}


def test_negative_places_have_a_minus(site: dict[str, str]) -> None:
    table = site["plane.eccentric_punch.html"].partition('<table class="values">')[2].partition("</table>")[0]
    assert "<td>−0.1</td>" in table
    assert "<td>-" not in table


def _contrast(one: str, other: str) -> float:
    """Of two colours, as WCAG 2.2 defines it."""

    def luminance(colour: str) -> float:
        digits = colour.lstrip("#")
        digits = digits if len(digits) == 6 else "".join(2 * digit for digit in digits)
        parts = [int(digits[i : i + 2], 16) / 255 for i in (0, 2, 4)]
        linear = [x / 12.92 if x <= 0.03928 else ((x + 0.055) / 1.055) ** 2.4 for x in parts]
        return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]

    low, high = sorted((luminance(one), luminance(other)))
    return (high + 0.05) / (low + 0.05)


def test_text_stands_out_from_its_ground_by_day_and_by_night(site: dict[str, str]) -> None:
    style = site["assets/site.css"]
    roots = re.findall(r":root \{(.*?)\}", style, re.DOTALL)
    by_day, by_night, in_print = (dict(re.findall(r"--(\w+): (#\w+);", part)) for part in roots)
    assert by_day["paper"] != by_night["paper"]
    for colours in (by_day, by_night, {"code": by_day["code"]} | in_print):
        for text in ("ink", "text", "note", "accent", "ok"):
            for ground in ("paper", "code"):
                assert _contrast(colours[text], colours[ground]) >= READABLE, (text, ground)
    # a label fainter than its colour would not be
    assert not re.search(r"\.label[^{]*\{[^}]*opacity", style)
    assert not re.search(r"^\.tone\d", style, re.MULTILINE)


@pytest.mark.parametrize(
    ("latex", "wanted"),
    [
        ("E^{*}", "E*"),
        (r"F/\bar p b^{3}", "F/p\N{COMBINING MACRON} b³"),
        (r"\Delta\gamma", "Δγ"),
        (r"\lambda", "λ"),
        (r"\varphi_0", "φ_0"),
        (r"F_{\mathrm N}", "F_N"),
    ],
)
def test_symbols_in_letters(latex: str, wanted: str) -> None:
    assert symbol(latex) == wanted


def test_functions_have_their_letter_as_address() -> None:
    assert anchor_of({"name": r"{}_{2}\mathrm{F}_{1}(p,q;c;z)"}) == "function.2F_1"
    assert anchor_of({"name": r"\mathbf{H}_{\nu}(z)"}) == "function.H_nu"


def test_the_search_knows_the_words_of_the_index(site: dict[str, str]) -> None:
    places = [tuple(place) for place in json.loads(site["assets/keys.js"][20:].rstrip(";\n"))["places"]]
    assert ("Berkovich indenter", "cone.html", "Cone", 3) in places
    assert ("Tabor's number", "reading.html#validity", "When does it hold?", 3) in places
    assert ("pull-off force", "cone.html#adh.Fc", "cone.adh.Fc", 3) in places
    assert "run time" not in {word for word, *_ in places}  # a page of its own, found by its own words
