"""The web edition as a reader uses it: with the keyboard, with a screen reader, on a telephone, from a copied line."""

from __future__ import annotations

import itertools
import json
import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from chromium import Chromium, needs_browser
from stored_book import CATALOGUE, KEYS, evidence, stored

from axiderive.emit.html import html_sources
from axiderive.emit.html.search import anchor_of, symbol

SAMPLE = ("cone", "flat_punch", "plane.eccentric_punch", "loads.hertzian", "materials")
PHONE = 360
"""Width in pixels of a small telephone."""
READABLE = 4.5
"""Contrast of text with its ground that WCAG 2.2 asks for at level AA."""
HITS = {
    "cone.p": "cone.html#p",
    "cone p": "cone.html#p",
    "CONE.P": "cone.html#p",
    "cone.f": "cone.html#f",
    "cone.F": "cone.html#F",
    "p": "cone.html#p",
    "p(r)": "cone.html#p",
    "F_N": "cone.html#F",
    "E*": "reading.html#symbol.E_star",
    "Δγ": "reading.html#symbol.dgamma",
    "work of adhesion": "reading.html#symbol.dgamma",
    "adhesion cone": "cone.html#adh.Dl",
    "penetration": "cone.html#d",
    "punch flat": "flat_punch.html",
    "hertzian": "loads.hertzian.html",
    "dawson": "reading.html#function.D",
    "maxwell": "reading.html#laws",
    "errata": "chapter11.html#errata",
    "11.66": "chapter11.html#eq.11.66",
    "matrix": "index.html#matrix",
}
"""What is typed, and what shall come first."""
TYPOS = {
    "presure": "pressure",
    "tangental force": "tangential force",
    "conne": "cone",
    "cne": "cone",
    "cone.stifness": "cone stiffness",
    "Hertzain": "hertzian",
    "flat pumch": "flat punch",
    "catteneo": "cattaneo",
    "xyzzy": "",  # near nothing
    "sfere": "",  # two letters off
    "11.999": "11 999",  # numbers are not misspelt
    "cone dawson": "cone dawson",  # nothing is misspelt
}
"""What is typed and found nowhere, and what is searched for instead."""


@pytest.fixture(scope="module")
def site() -> dict[str, str]:
    own = [key for key in KEYS if any(key == name or key.startswith(f"{name}.") for name in SAMPLE)]
    modules = {
        str(path.relative_to(CATALOGUE)): path.read_text(encoding="utf-8")
        for path in (CATALOGUE / "axicontact").rglob("*.py")
    }
    chapter = json.loads((CATALOGUE / "evidence" / "chapter11.json").read_bytes())
    studies = {path.stem: json.loads(path.read_bytes()) for path in (CATALOGUE / "evidence" / "study").glob("*.json")}
    return html_sources(
        {k: stored(k) for k in own}, {k: evidence(k) for k in own}, chapter, modules=modules, studies=studies
    )


@pytest.fixture(scope="module")
def opened(site: dict[str, str], tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[Chromium, str]]:
    folder = tmp_path_factory.mktemp("site")
    for path, text in site.items():
        (folder / path).parent.mkdir(exist_ok=True)
        (folder / path).write_text(text, encoding="utf-8")
    with Chromium(folder) as browser:
        yield browser, Path(folder).as_uri()


SOON_TOLD = """new Promise((done) => {
  const look = () => {
    const text = document.getElementById("told").textContent;
    if (text) done(text); else setTimeout(look, 20);
  };
  look();
})"""


def _told(browser: Chromium) -> str:
    text: str = browser.value("document.getElementById('told').textContent")
    return text


@needs_browser
def test_the_search_puts_first_what_was_meant(opened: tuple[Chromium, str]) -> None:
    browser, root = opened
    browser.open(f"{root}/index.html")
    found = {query: browser.value(f"search({json.dumps(query)})[0]?.address") for query in HITS}
    assert found == HITS
    # P and p are told apart, as in plane contact
    browser.value("window.axicontact.keys.push(['cone.P', 'cone', 0, 'Pressure', 'pressure P']); index = null")
    assert [browser.value(f"search('{letter}')[0].name") for letter in "pP"] == ["cone.p", "cone.P"]


@needs_browser
def test_the_search_forgives_a_letter_where_nothing_is_found(opened: tuple[Chromium, str]) -> None:
    browser, root = opened
    browser.open(f"{root}/index.html")
    found = {
        typed: browser.value(f"[search({json.dumps(typed)}).length, guess({json.dumps(typed)})]") for typed in TYPOS
    }
    assert found == {typed: [0, meant] for typed, meant in TYPOS.items()}
    pairs = [("cone", "coone"), ("cone", "cne"), ("cone", "cane"), ("cone", "ocne"), ("cone", "con"), ("cone", "cones")]
    others = [("cone", "cone"), ("cone", "coones"), ("cone", "caen"), ("cone", "neco"), ("depth", "pthde")]
    near = [browser.value(f"misspelt({json.dumps(a)}, {json.dumps(b)})") for a, b in (*pairs, *others)]
    assert near == [True] * len(pairs) + [False] * len(others)
    browser.press("/", *"cone presure")
    assert _told(browser) == "nothing found for cone presure: did you mean cone pressure?"
    box = "document.getElementById('{}').getBoundingClientRect().{}"
    below, above = browser.value(f"[{box.format('told', 'bottom')}, {box.format('found', 'top')}]")
    assert 0 < below <= above
    browser.events.clear()
    browser.press("Enter")
    browser.loaded()
    assert browser.value("location.href") == f"{root}/cone.html#p"


LABELS = """[...document.querySelectorAll(".canvas")].map((canvas) => {
  const { left, right, top, bottom } = canvas.getBoundingClientRect();
  const labels = [...canvas.querySelectorAll(".label")];
  const boxes = labels.map((label) => label.getBoundingClientRect());
  const outside = (box) => box.left < left - 1 || box.right > right + 1 || box.top < top - 1 || box.bottom > bottom + 1;
  return {
    id: canvas.parentElement.id,
    size: Math.min(...labels.map((label) => parseFloat(getComputedStyle(label).fontSize))),
    outside: labels.filter((_, i) => outside(boxes[i])).map((label) => label.textContent),
    names: labels.filter((label) => /^[a-z]+ [a-z ]+$/.test(label.textContent)).map((label) => label.textContent),
  };
})"""


@needs_browser
@pytest.mark.parametrize("width", [PHONE, 1280])
def test_the_axes_of_the_study_have_names_that_are_legible(opened: tuple[Chromium, str], width: int) -> None:
    """Names, ticks and letters lie on their figure, and none is smaller than the letters of a footnote."""
    browser, root = opened
    browser.open(f"{root}/study.html", width)
    figures = {figure.pop("id"): figure for figure in browser.value(LABELS)}
    panels = [one for name, one in figures.items() if name.startswith("error.")]
    assert len(panels) > 20
    assert {tuple(one["names"]) for one in panels} == {("run time over that of the function", "worst relative error")}
    assert [name for name, one in figures.items() if one["outside"]] == []
    assert min(one["size"] for one in figures.values()) >= 11
    assert browser.value("document.documentElement.scrollWidth") <= width


@needs_browser
def test_a_formula_is_found_by_the_keyboard_alone(opened: tuple[Chromium, str]) -> None:
    browser, root = opened
    browser.open(f"{root}/index.html")
    browser.press("/", *"xyzzy")
    assert _told(browser).startswith("nothing found for xyzzy")
    browser.press("Enter", "Escape")
    assert _told(browser) == ""
    assert browser.value("location.pathname").endswith("index.html")
    browser.value("document.getElementById('q').value = ''")
    browser.press(*"cone.p", "ArrowDown", "ArrowDown", "ArrowUp")
    chosen = "[...document.querySelectorAll('[role=option][aria-selected=true]')].map((one) => one.id)"
    assert browser.value(chosen) == [browser.value("document.activeElement.getAttribute('aria-activedescendant')")]
    browser.events.clear()
    browser.press("Enter")
    browser.loaded()
    assert browser.value("location.href") == f"{root}/cone.html#p"
    row = "document.getElementById('p')"
    top, ground = browser.value(f"[{row}.getBoundingClientRect().top, getComputedStyle({row}).backgroundColor]")
    bar, plain = browser.value(
        "[document.querySelector('.bar').offsetHeight, getComputedStyle(document.getElementById('w')).backgroundColor]"
    )
    assert bar <= top < 400  # below the bar, in the upper half
    assert ground != plain


@needs_browser
def test_the_focus_is_seen_wherever_tab_leads(opened: tuple[Chromium, str]) -> None:
    browser, root = opened
    browser.open(f"{root}/loads.hertzian.html")
    look = "[document.activeElement.tagName, getComputedStyle(document.activeElement).outlineStyle]"
    seen = []
    for _ in range(20):
        browser.press("Tab")
        seen.append(browser.value(look))
    assert {"A", "INPUT", "BUTTON", "SUMMARY"} <= {tag for tag, _ in seen}
    assert {outline for _, outline in seen} == {"solid"}


@needs_browser
@pytest.mark.parametrize(
    "page",
    ["index", "loads.hertzian", *(pytest.param(name, marks=pytest.mark.slow) for name in ("reading", "chapter11"))],
)
def test_a_screen_reader_meets_nothing_without_a_name(opened: tuple[Chromium, str], page: str) -> None:
    browser, root = opened
    browser.open(f"{root}/{page}.html")
    tree = browser.tree()
    named = [(role, name) for role, name in tree if role in ("button", "link", "heading", "image", "combobox")]
    assert [role for role, name in named if not name.strip()] == []
    buttons = [name for role, name in named if role == "button"]
    assert len(set(buttons)) == len(buttons)
    assert browser.said() == []
    assert browser.asked() <= {"file", "data"}


@needs_browser
def test_a_copy_is_told(opened: tuple[Chromium, str]) -> None:
    browser, root = opened
    browser.open(f"{root}/cone.html")
    browser.value("document.querySelector('#p button[data-kind=python]').focus()")
    browser.press("Enter")
    assert browser.value(SOON_TOLD) == "copied: Python of p"
    assert browser.value("document.activeElement.dataset.kind") == "python"


@needs_browser
def test_numbers_keep_their_line_on_a_telephone(opened: tuple[Chromium, str]) -> None:
    browser, root = opened
    browser.open(f"{root}/cone.html", PHONE)
    heights = browser.value("[...document.querySelectorAll('.values td')].map((cell) => cell.clientHeight)")
    assert len(heights) == 24
    assert max(heights) < 40
    assert browser.value("document.documentElement.scrollWidth") <= PHONE
    wider = "[...document.querySelectorAll('td')].filter((cell) => cell.scrollWidth > cell.clientWidth)"
    assert browser.value(f"{wider}.map((cell) => cell.textContent)") == []  # none runs into the next one
    sizes = browser.value("[...document.querySelectorAll('button')].map((button) => button.offsetHeight)")
    assert min(sizes) >= 24


def test_headings_go_down_one_level_at_a_time(site: dict[str, str]) -> None:
    for path in (path for path in site if path.endswith(".html")):
        levels = [int(level) for level in re.findall(r"<h([1-6])[ >]", site[path])]
        assert levels[0] == 1, path
        assert levels.count(1) == 1, path
        assert all(after <= before + 1 for before, after in itertools.pairwise(levels)), path


def test_every_picture_is_described_by_its_caption(site: dict[str, str]) -> None:
    captions = 0
    for path in (path for path in site if path.endswith(".html")):
        for label in re.findall(r'<div class="canvas" role="img" aria-labelledby="([^"]+)">', site[path]):
            assert f'<figcaption id="{label}">' in site[path], path
            captions += 1
        assert site[path].count('class="canvas"') == site[path].count('role="img"'), path
    assert captions > 12


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
    [("E^{*}", "E*"), (r"\Delta\gamma", "Δγ"), (r"\lambda", "λ"), (r"\varphi_0", "φ_0"), (r"F_{\mathrm N}", "F_N")],
)
def test_symbols_in_letters(latex: str, wanted: str) -> None:
    assert symbol(latex) == wanted


def test_functions_have_their_letter_as_address() -> None:
    assert anchor_of({"name": r"{}_{2}\mathrm{F}_{1}(p,q;c;z)"}) == "function.2F_1"
    assert anchor_of({"name": r"\mathbf{H}_{\nu}(z)"}) == "function.H_nu"
