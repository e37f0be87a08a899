"""The web edition in a browser: every formula set, every button, the search, a telephone."""

from __future__ import annotations

import json
import os
import re
import subprocess
from html import unescape
from pathlib import Path
from typing import Any

import pytest
from chromium import BROWSER, Chromium, needs_browser
from stored_book import HANDBOOK
from web_page import Page

SITE = HANDBOOK / "html"
PAGES = [path.name for path in sorted(SITE.glob("*.html"))]
INDEX = json.loads(
    (SITE / "assets/keys.js").read_text(encoding="utf-8").removeprefix("window.axicontact = ").rstrip(";\n")
)
SAMPLE = (
    "index.html", "reading.html", "study.html", "cone.html", "rounded_punch.html", "plane.wedge.html", "materials.html",
)  # fmt: skip
LARGEST = 1_000_000
"""Bytes of a page."""
PHONES = (360, 390)
"""Width in pixels of a small telephone and of a common one."""
HARNESS = """<!doctype html><meta charset="utf-8"><body>{frames}<pre id="report"></pre><script>
function pressed(frame) {{
  const written = [];
  const clipboard = {{ writeText: (text) => written.push(text) }};
  Object.defineProperty(frame.contentWindow.navigator, "clipboard", {{ value: clipboard }});
  return [...frame.contentDocument.querySelectorAll("button.copy")].map((button) => {{
    button.click();
    return [button.closest(".row").id, button.dataset.kind, ...written.splice(0)];
  }});
}}
addEventListener("load", () => {{
  const report = [...document.querySelectorAll("iframe")].map((frame) => {{
    const page = frame.contentDocument;
    return {{
      page: frame.getAttribute("src"),
      formulas: page.querySelectorAll(".tex").length,
      rendered: page.querySelectorAll(".tex > .katex, .tex > .katex-display").length,
      failed: [...page.querySelectorAll(".failed, .katex-error")].map((place) => place.textContent),
      overflow: page.documentElement.scrollWidth - page.documentElement.clientWidth,
      hits: [...page.querySelectorAll("#found .hit")].map((hit) => hit.getAttribute("href")),
      copied: pressed(frame),
      fonts: page.fonts.check("16px KaTeX_Main"),
    }};
  }});
  document.getElementById("report").textContent = JSON.stringify(report);
}});
</script>"""


def rendered(
    site: dict[str, str], folder: Path, addresses: list[str], width: int = PHONES[0]
) -> tuple[dict[str, dict[str, Any]], list[str]]:
    """What a browser makes of the pages, by their address, and what it says on its console."""
    for path, text in site.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_text(text, encoding="utf-8")
    frames = "".join(f'<iframe width="{width}" height="700" src="{address}"></iframe>' for address in addresses)
    (folder / "harness.html").write_text(HARNESS.format(frames=frames), encoding="utf-8")
    command = [
        str(BROWSER), "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
        "--allow-file-access-from-files", "--enable-logging=stderr", f"--user-data-dir={folder / 'browser'}",
        "--timeout=120000", "--dump-dom", (folder / "harness.html").as_uri(),
    ]  # fmt: skip
    environment = {**os.environ, "HOME": str(folder)}
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True, timeout=300)
    report = re.search(r'<pre id="report">(.*?)</pre>', done.stdout, re.DOTALL)
    assert report is not None and report[1], done.stderr[-2000:]
    found = {one["page"]: one for one in json.loads(unescape(report[1]))}
    return found, [line for line in done.stderr.splitlines() if "CONSOLE" in line]


@pytest.fixture(scope="module")
def site() -> dict[str, str]:
    """The compiled web edition."""
    paths = [path for path in SITE.rglob("*") if path.suffix in (".html", ".js", ".css")]
    return {str(path.relative_to(SITE)): path.read_text(encoding="utf-8") for path in paths}


def _cited(key: str) -> str:
    citation: str = INDEX["citation"]
    return citation.replace("KEY", key).replace("NAME", key.replace("_", r"\_"))


def _expected(page: str, entry: str) -> list[list[str]]:
    """What the buttons of the page of an entry should copy, read off its HTML."""
    found = []
    for row in re.findall(r'<article class="row(?: further)?" id="[^"]+">.*?</article>', page, re.DOTALL):
        name = re.match(r'<article class="row(?: further)?" id="([^"]+)"', row)
        assert name
        lines = re.findall(r'<div class="line"><span class="tex"[^>]*>(.*?)</span></div>', row)
        calls = re.findall(r"<pre>(.*?)</pre>", row, re.DOTALL)
        if lines:  # a sum of other profiles is said in words
            found.append([name[1], "latex", unescape("\n".join(lines))])
        if calls:  # limits and universal curves have no function and no key
            found.append([name[1], "python", unescape("\n\n".join(calls))])
            found.append([name[1], "bibtex", _cited(f"{entry}.{name[1]}")])
    return found


def _check(found: dict[str, dict[str, Any]], console: list[str], site: dict[str, str]) -> int:
    """Every formula set, every button right, no scrolling sideways; how many formulas there were."""
    assert console == []
    for address, report in found.items():
        path = address.partition("?")[0]
        assert report["failed"] == [], address
        assert report["rendered"] == report["formulas"] > 0, address
        assert report["overflow"] <= 0, address
        assert report["copied"] == _expected(site[path], path.removesuffix(".html")), address
        assert report["fonts"], address
    return sum(report["formulas"] for report in found.values())


@needs_browser
def test_a_browser_renders_every_formula(site: dict[str, str], tmp_path: Path) -> None:
    searched = {"index.html?q=cone.adh.Fc": "cone.html#adh.Fc", "cone.html?q=pressure+wedge": "plane.wedge.html#p"}
    found, console = rendered(site, tmp_path, [*SAMPLE, *searched])
    _check(found, console, site)
    for address, hit in searched.items():
        assert found[address]["hits"][0] == hit
    assert found["index.html"]["hits"] == []
    latex, python, bibtex, *_ = found["cone.html"]["copied"]
    assert latex == ["d", "latex", r"d=g(a)=\tfrac{\pi}{2} \, a \tan \theta"]
    assert python[:2] == ["d", "python"]
    assert bibtex[2].startswith("@misc{axicontact:cone.d,")
    assert bibtex[2].endswith(", formula cone.d}\n}")
    assert python[2].split("\n\n") == [
        "from axicontact.normal import cone", "a = 1.0\ntheta = 0.35", "cone.depth(a, theta=theta)",
    ]  # fmt: skip


FOUND = {
    "berkovich": "cone.html",
    "vickers": "cone.html",
    "nanoindentation": "cone.html",
    "wear": "rounded_punch.html",
    "blunt": "rounded_cone.html",
    "berkovich blunted": "sphere_tipped_cone.html",
    "roller": "plane.parabola.html",
    "o-ring": "plane.parabola.html",
    "ball": "paraboloid.html",
    "afm": "paraboloid.html",
    "hertz": "paraboloid.html",
    "sneddon": "cone.html",
    "jkr": "paraboloid.html#adh.Fc",
    "pull-off": "cone.html#adh.Fc",
    "mindlin": "paraboloid.html#tan.F",
    "cattaneo": "paraboloid.html#tan.F",
    "partial slip": "paraboloid.html#tan.F",
    "creep": "reading.html#laws",
    "pressure": "cone.html#p",
    "depth": "cone.html#d",
    "stiffness": "cone.html#k",
}
"""Words that people use, and the page that comes first."""


@needs_browser
def test_the_search_knows_the_words_people_use(tmp_path: Path) -> None:
    with Chromium(tmp_path) as browser:
        browser.open((SITE / "index.html").as_uri())
        found = {word: browser.value(f"search({json.dumps(word)})[0]?.address") for word in FOUND}
        assert found == FOUND
        # the key of a largest pressure, where there is one, comes before the profiles that are known for theirs
        assert browser.value("search('peak pressure')[0].address") == "rounded_punch.html#pp"
        # homogeneous cone and paraboloid before all others
        assert browser.value("search('pressure').slice(0, 2).map((hit) => hit.name)") == ["cone.p", "paraboloid.p"]


@pytest.mark.slow
@needs_browser
@pytest.mark.parametrize("width", [PHONES[0], *(pytest.param(width, marks=pytest.mark.sweep) for width in PHONES[1:])])
def test_a_browser_renders_every_formula_of_every_page(site: dict[str, str], tmp_path: Path, width: int) -> None:
    found, console = rendered(site, tmp_path, PAGES, width)
    assert _check(found, console, site) > 3000
    assert len(found) == len(PAGES)


@needs_browser
def test_the_browser_sees_a_broken_formula(site: dict[str, str], tmp_path: Path) -> None:
    """What the tests above rely on: a macro KaTeX does not know is shown as failed and said on the console."""
    broken = site["loads.power.html"].replace(r"\frac", r"\fracc", 1)
    assets = {path: text for path, text in site.items() if path.startswith("assets/")}
    found, console = rendered(assets | {"page.html": broken}, tmp_path, ["page.html"])
    report = found["page.html"]
    assert len(report["failed"]) == 1
    assert report["rendered"] == report["formulas"] - 1
    assert any("fracc" in line for line in console)


def test_links_of_the_whole_edition_resolve_and_its_pages_are_small(site: dict[str, str]) -> None:
    pages = {path: Page((SITE / path).read_text(encoding="utf-8")) for path in PAGES}
    for path, page in pages.items():
        assert len(site[path].encode()) < LARGEST, path
        assert len(set(page.ids)) == len(page.ids), path
        for address in page.addresses:
            target, _, fragment = address.partition("#")
            target = target.partition("?")[0]
            if address.startswith(("https://doi.org/10.", "../handbook.pdf#nameddest=")):
                continue  # a work that is cited, the printed book
            if address != "data:,":
                assert (target or path) in site, f"{path}: {address}"
                assert not fragment or fragment in pages[target or path].ids, f"{path}: {address}"
