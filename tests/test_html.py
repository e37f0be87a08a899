"""The web edition: complete, closed in itself, small, and rendered without an error by a browser."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from html import unescape
from pathlib import Path

import pytest
from conftest import UNCHECKED, WEB
from markupsafe import Markup
from stored_book import CATALOGUE, HANDBOOK, KEYS, on_pages, rows, stored
from web_page import Page

from axiderive.book.guide import TITLE
from axiderive.figures.drawing import Drawing
from axiderive.figures.svg import svg
from axiderive.physics.systems import problem, problems
from axiderive.web.words import words

SAMPLE = ("cone", "rounded_punch", "capped_cylinder", "plane.wedge", "loads.power", "materials")
"""Profiles that bring every kind of row, one of them in complete contact."""
LARGEST = 1_000_000
"""Bytes of a page."""
SHOWN = [key for key in KEYS if problem(key).profile_id in WEB and problem(key).system.physics.printed]
"""Problems with rows on the pages of the composed edition."""


@pytest.fixture(scope="module")
def pages(site: dict[str, str]) -> dict[str, Page]:
    return {path: Page(text) for path, text in site.items() if path.endswith(".html")}


@pytest.mark.parametrize("name", SAMPLE)
def test_every_formula_of_every_entry_is_on_the_page_of_its_profile(name: str) -> None:
    """Of the committed edition, as it is printed and read back, also where the book refers to a rule in front."""
    page = Page((HANDBOOK / "html" / f"{name}.html").read_text(encoding="utf-8"))
    for own in (one for one in problems([name]) if one.system.physics.printed):
        for entry in on_pages(stored(own.key)):
            assert page.ids.count(entry.key.removeprefix(f"{name}.")) == 1, entry.key
        for one in rows(own.key):
            for region in one.regions:
                assert region.tex.replace(r"\begin{aligned}[t]", r"\begin{aligned}") in page.formulas, one.key
                assert not region.condition or region.condition in page.formulas, one.key


def test_links_resolve_and_nothing_is_fetched_from_outside(site: dict[str, str], pages: dict[str, Page]) -> None:
    for path, page in pages.items():
        assert len(set(page.ids)) == len(page.ids), path
        for address in page.addresses:
            if address == "data:," or address.startswith("https://doi.org/"):  # a link to follow, not a file to fetch
                continue
            if address.startswith("../"):  # the printed book beside the web edition
                assert address == f"../handbook.pdf#nameddest={path.removesuffix('.html')}"
                continue
            target, _, fragment = address.partition("#")
            target = target.partition("?")[0]
            assert (target or path) in site, f"{path}: {address}"
            assert not fragment or fragment in pages[target or path].ids, f"{path}: {address}"
    styles = "".join(text for path, text in site.items() if path.endswith(".css"))
    assert {address[:5] for address in re.findall(r"url\(([^)]*)\)", styles)} == {"data:"}
    assert not re.search(r"fetch|XMLHttpRequest|import\(|https?:", site["assets/site.js"])


def test_no_latex_is_left_in_the_words(pages: dict[str, Page], site: dict[str, str]) -> None:
    for path in pages:
        text = re.sub(r'<span class="tex"[^>]*>[^<]*</span>|<pre>[^<]*</pre>', "", site[path])
        assert "\\" not in text, re.findall(r".{30}\\.{30}", text)


def test_pages_are_small(pages: dict[str, Page], site: dict[str, str]) -> None:
    assert max(len(site[path].encode()) for path in pages) < LARGEST


def test_the_search_index_has_every_key(site: dict[str, str]) -> None:
    record = json.loads(site["assets/keys.js"].removeprefix("window.axicontact = ").rstrip(";\n"))
    keys = [row[0] for row in record["keys"]]
    assert sorted(keys) == sorted(entry.key for shown in SHOWN for entry in stored(shown).values())
    assert all(key.startswith(f"{profile}.") and profile in record["profiles"] for key, profile, *_ in record["keys"])


def test_the_first_profiles_come_first_and_the_homogeneous_half_space_before_the_graded_one(
    site: dict[str, str],
) -> None:
    record = json.loads(site["assets/keys.js"].removeprefix("window.axicontact = ").rstrip(";\n"))
    systems = [row[2] for row in record["keys"]]
    assert systems == sorted(systems)
    assert record["keys"][0][1] == "cone"


def test_a_formula_is_cited_in_the_words_of_the_book(site: dict[str, str]) -> None:
    book = (HANDBOOK / "handbook.tex").read_text(encoding="utf-8")
    cited = re.search(r"\\guide\{How to cite\}\{(.*)\}\n", book)
    assert cited
    words = re.sub(r"\\emph\{(.*?)\}|\\eqr\{(.*?)\}", r"\1\2", cited[1])
    words = re.sub(r"edition \w{8}", "edition", words)
    shown = site["index.html"].partition('<section id="imprint">')[2].partition("</section>")[0]
    assert words in re.sub(r"edition \w{8}", "edition", re.sub(r"<.*?>", "", shown))
    citation = json.loads(site["assets/keys.js"].removeprefix("window.axicontact = ").rstrip(";\n"))["citation"]
    assert citation.startswith("@misc{axicontact:KEY,")
    assert TITLE in citation
    assert TITLE in words


def test_every_page_has_a_description_of_its_own(site: dict[str, str], pages: dict[str, Page]) -> None:
    found = [re.findall(r'<meta name="description" content="([^"]+)">', site[path]) for path in pages]
    assert all(len(one) == 1 and len(one[0]) > 40 for one in found)
    assert len({one[0] for one in found}) == len(pages)


def test_the_home_page_has_a_picture_of_every_profile(site: dict[str, str]) -> None:
    """With what it stands for, and the physics there is; the filters hide nothing without JavaScript."""
    cards = re.findall(r'<li data-kinds="([^"]+)"><a href="([\w.]+)\.html"><?.*?</li>', site["index.html"], re.DOTALL)
    assert sorted(cards) == [
        ("flat", "flat_punch"), ("load", "loads.hertzian"), ("long", "plane.eccentric_punch"), ("pointed", "cone"),
    ]  # fmt: skip
    card = site["index.html"].partition('<li data-kinds="pointed">')[2].partition("</li>")[0]
    assert 'class="body"' in card
    assert "sharp Berkovich" in card
    assert 'href="cone.html#about.adhesive"' in card
    assert re.findall(r'data-kind="(\w*)"', site["index.html"]) == ["", "pointed", "flat", "long", "load"]
    assert '<b>Berkovich, Vickers:</b> the <a href="cone.html">cone</a>' in site["index.html"]
    assert '<a href="cone.html?theta=70.3+half">calculate</a>' in site["index.html"]
    assert not re.search(r"<(li|div)[^>]* hidden", site["index.html"])


def test_only_the_first_physics_of_a_page_is_unfolded(site: dict[str, str]) -> None:
    for name in WEB:
        folds = re.findall(r'<details class="physics" id="about\.[\w.]+"( open)?>', site[f"{name}.html"])
        assert folds == [" open", *[""] * (len(folds) - 1)], name
        assert "<details open" not in site[f"{name}.html"]
    assert site["cone.html"].count('<details class="physics"') == 8


def test_the_index_counts_what_it_holds(site: dict[str, str]) -> None:
    """Neither a prescribed pressure nor the elastic constants are a profile."""
    count = len(json.loads(site["assets/keys.js"].removeprefix("window.axicontact = ").rstrip(";\n"))["keys"])
    assert f": 3 profiles, 1 prescribed pressure and the elastic constants; {count} formulas" in site["index.html"]


def test_evidence_is_shown_and_missing_evidence_is_said_to_be_missing(site: dict[str, str]) -> None:
    known = r"<summary>certified; \d+ digits at \d+ points<"
    for name, said in (("cone", known), (UNCHECKED, "not verified in this edition")):
        text = site[f"{name}.html"]
        row = text[text.index('id="w"') : text.index("</article>", text.index('id="w"'))]
        assert re.search(said, row)
        assert ("certified" in row) == (name == "cone")


def test_the_calls_run_as_they_are_copied(site: dict[str, str], tmp_path: Path) -> None:
    """Every block of Python on a page, alone and in the generated package, gives a finite number or a state."""
    blocks = [
        unescape(block)
        for path in (f"{name}.html" for name in WEB)
        for block in re.findall(r"<pre>(.*?)</pre>", site[path], re.DOTALL)
        if "from axicontact.subsurface" not in block  # which have no numbers
    ]
    lines = ["import math"]
    for block in blocks:
        start, given, call = block.split("\n\n")
        # a function each, so that no block lives on the names of another
        lines += ["def block():", *(f"    {line}" for line in f"{start}\n{given}\nreturn {call}".splitlines())]
        lines += ["found = block()", "assert not isinstance(found, float) or math.isfinite(found), found"]
    program = tmp_path / "calls.py"
    program.write_text("\n".join(lines))
    environment = {**os.environ, "PYTHONPATH": str(CATALOGUE)}
    subprocess.run([sys.executable, str(program)], env=environment, check=True, timeout=600)
    assert len(blocks) == sum(len(on_pages(stored(key))) for key in SHOWN)


def test_the_key_says_under_which_control_a_contact_is_pulled_off(site: dict[str, str]) -> None:
    text = unescape(site["cone.html"])
    assert "cone.pull_off('force', " in text[text.index('id="adh.Fc"') : text.index('id="adh.dc"')]
    assert "cone.pull_off('depth', " in text[text.index('id="adh.Fm"') : text.index('id="adh.dm"')]


def _link(label: str, text: str) -> Markup:
    return Markup("[{}|{}]").format(label, text)


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("a < b & c", "a &lt; b &amp; c"),
        (r"Heß \& Willert -- 100 \%", "Heß &amp; Willert – 100 %"),
        (r"for $a<b$, \own{ad}", 'for <span class="kept"><span class="tex">a&lt;b</span>,</span> [own:ad|.ad]'),
        (
            r"($a$) \(b\) $c$",
            '<span class="kept">(<span class="tex">a</span>)</span> '
            '<span class="tex">b</span> <span class="tex">c</span>',
        ),
        (r"$b\to 0$ \hyperref[sec:cone]{cone}", r'<span class="tex">b\to 0</span> [sec:cone|cone]'),
        (r"on page \pageref{part:laws}", "under [part:laws|Viscoelastic laws]"),
        ("by (11.29) and (11.20), (a)", "by [chapter:11.29|(11.29)] and [chapter:11.20|(11.20)], (a)"),
        (r"He\ss\ \textcolor{note}{$\int$3}", r'Heß <span class="note"><span class="tex">\int</span>3</span>'),
        (r"0.270\,723", "0.270\N{THIN SPACE}723"),
        (r"$\displaystyle x$", '<span class="tex" data-display>x</span>'),
        (r"\rule[-2mm]{0pt}{6mm}a,\newline b", "a,<br>b"),
    ],
)
def test_words(text: str, wanted: str) -> None:
    assert words(text, _link) == wanted


def test_equations_and_errata_of_the_chapter_have_an_address(pages: dict[str, Page]) -> None:
    page = pages["chapter11.html"]
    assert {"eq.11.66", "erratum.11.66", "errata"} <= set(page.ids)
    assert {"#eq.11.66", "#erratum.11.66"} <= set(page.addresses)


def test_a_macro_without_words_is_an_error() -> None:
    with pytest.raises(ValueError, match=r"\\hfill in .* has no words in HTML"):
        words(r"left \hfill right", _link)


def test_figures_keep_the_coordinates() -> None:
    """A point of a figure is as far from its upper left corner as its units say, and y points up."""
    figure = Drawing("plot", (-1.0, -2.0), (3.0, 2.0))
    figure.line("axis", (0.0, 0.0), (1.0, 2.0), (3.0, -2.0))
    figure.label("$a$", (1.0, 1.0), "north west")
    shown = svg(figure, 100.0)
    assert (shown.width, shown.height) == (400.0, 400.0)
    assert shown.below == [("polyline", "axis", {"points": "100,200 200,0 400,400"})]
    (label,) = shown.labels
    assert (label.left, label.top, label.kind) == (50.0, 25.0, "below-left")


def test_an_entry_shows_itself_in_a_notebook() -> None:
    """By the method that Jupyter calls, for entries of every kind."""
    keys = ("cone", "rounded_punch", "cone.fgm.tan", "flat_punch.adh", "loads.hertzian", "plane.wedge")
    shown = {entry.key: entry._repr_markdown_() for key in keys for entry in stored(key).values()}
    assert (
        shown["cone.d"] == "`cone.d` Indentation depth\n\n" + r"$\displaystyle d=g(a)=\tfrac{\pi}{2} \, a \tan \theta$"
    )
    assert shown["rounded_punch.Fd"].endswith("with $a$ from `rounded_punch.ad`")
    assert shown["rounded_punch.p"].count(r"$\displaystyle") == 2
    assert all(text.count("$") % 2 == 0 for text in shown.values())
