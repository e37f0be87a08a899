"""The web edition as a reader uses it: with the keyboard, with a screen reader, on a telephone, from a copied line."""

from __future__ import annotations

import json
import math
from urllib.parse import unquote

import pytest
from chromium import Chromium, needs_browser

PHONE = 360
"""Width in pixels of a small telephone."""
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
    "work of adhesion": "reading.html#rules",
    "surface energy": "reading.html#symbol.dgamma",
    "adhesion cone": "cone.html#adh.Dl",
    "penetration": "cone.html#d",
    "punch flat": "flat_punch.html",
    "hertzian": "loads.hertzian.html",
    "dawson": "reading.html#function.D",
    "maxwell": "reading.html#laws",
    "errata": "chapter11.html#errata",
    "11.66": "chapter11.html#eq.11.66",
    "matrix": "index.html#matrix",
    "pressure": "cone.html#p",
    "depth": "cone.html#d",
    "pull-off": "cone.html#adh.Fc",
    "berkovich": "cone.html",
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
    for _ in range(40):
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
def test_a_button_leaves_the_pictures_of_its_kind(opened: tuple[Chromium, str]) -> None:
    browser, root = opened
    browser.open(f"{root}/index.html")
    left = "[...document.querySelectorAll('.cards li')].filter((card) => card.offsetHeight).length"
    heads = "[...document.querySelectorAll('.group h3')].filter((head) => head.offsetHeight).length"
    assert browser.value(f"[{left}, {heads}]") == [4, 4]
    browser.value("document.querySelector('.filter [data-kind=long]').focus()")
    browser.press("Enter")
    assert browser.value(f"[{left}, {heads}]") == [1, 1]
    assert browser.value("[...document.querySelectorAll('[aria-pressed=true]')].map((one) => one.dataset.kind)") == [
        "long"
    ]
    browser.value("document.querySelector('.filter [data-kind=\"\"]').click()")
    assert browser.value(f"[{left}, {heads}]") == [4, 4]


@needs_browser
def test_an_address_opens_the_section_it_lies_in(opened: tuple[Chromium, str]) -> None:
    browser, root = opened
    browser.open(f"{root}/cone.html#adh.Fc")
    assert 0 < browser.value("document.getElementById('adh.Fc').getBoundingClientRect().top") < 400
    seen = "document.getElementById('{}').checkVisibility()"
    soon = "new Promise((done) => setTimeout(() => done({}), 200))"
    assert browser.value(seen.format("adh.Fc"))
    assert not browser.value(seen.format("tan.F"))
    address = "document.querySelector('.contents a[href=\"#about.tangential\"]')"
    for _ in range(2):  # again, after it was folded by hand
        browser.value(f"{address}.click()")
        assert browser.value(soon.format(seen.format("tan.F")))
        browser.value("document.getElementById('about.tangential').open = false")
    browser.value("location.hash = '#vis.step_mx'")
    assert browser.value(soon.format(seen.format("vis.step_mx")))


@needs_browser
def test_a_figure_gives_its_curves_in_the_units_of_its_axes(opened: tuple[Chromium, str]) -> None:
    """As a file that is made in the page, with the coordinates that are printed, also those of a logarithmic axis."""
    browser, root = opened
    browser.open(f"{root}/cone.html")
    name, address = browser.value(
        "(({ download, href }) => [download, href])(document.querySelector('#plot\\\\.pressure .table'))"
    )
    assert name == "cone.pressure.csv"
    head, *rows = unquote(address.removeprefix("data:text/csv;charset=utf-8,")).split("\r\n")
    assert head == '"curve","r/a","p/p\N{COMBINING MACRON}"'
    assert '"Hertz",0,1.5' in rows
    middle = [float(row.split(",")[2]) for row in rows if row.startswith('"p/p\N{COMBINING MACRON}",0.5,')]
    assert middle == pytest.approx([math.acosh(2)], rel=1e-4)
    browser.value("document.querySelector('#plot\\\\.pressure').dataset.logy = ''")
    browser.value("document.querySelector('.window polyline').setAttribute('points', '1,2 2,-0.69897')")
    assert browser.value("table(document.querySelector('#plot\\\\.pressure'))").split("\r\n")[1:][:2] == [
        '"Hertz",1,100',
        '"Hertz",2,0.2',
    ]


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
