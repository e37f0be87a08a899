"""The whole web edition: a page per profile, an index with search, the front of the book, the studies, the chapter."""

from __future__ import annotations

import base64
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import partial
from importlib.resources import files
from typing import Any

import jinja2
from markupsafe import Markup, escape

from ..book import book
from ..book.back import WORDS
from ..book.evidence import LEFT_OUT, LEGEND
from ..book.guide import TITLE, cited
from ..book.handbook import Model, page_models
from ..book.studies import Panel, Panels, map_drawing, panel_drawing
from ..code.python import package_sources
from ..figures.svg import Picture, svg
from ..physics.systems import PRINTED, SYSTEMS, pool_of
from ..print.words import escaped, prose
from ..profiles.pools import ROUND
from ..worked.cases import CASES
from .calculator import scripts
from .page import BELOW, Derived, page
from .search import PARTS, anchor_of, has_shape, search_index
from .words import formula, plain, slug, words

_FACE = re.compile(r"@font-face\{[^}]*url\(fonts/([\w-]+\.woff2)\)[^}]*\}")
_SOURCE = re.compile(r"src:[^}]*")


def html_sources(
    derived: Derived,
    evidence: Mapping[str, Any] | None = None,
    chapter11: Mapping[str, Any] | None = None,
    models: Mapping[str, Model] | None = None,
    modules: Mapping[str, str] | None = None,
    studies: Mapping[str, Any] | None = None,
    profiles: Iterable[str] = (),
) -> dict[str, str]:
    """All files of the web edition by path below `handbook/html`, from what `handbook_sources` takes.

    The calls are read from generated `modules` by path; links lead to further `profiles` that the edition has pages of.
    """
    evidence = evidence or {}
    models = page_models(derived, evidence) if models is None else models
    modules = package_sources(derived) if modules is None else modules
    ids = list(models)
    keys = frozenset(e.key for entries in derived.values() for e in entries.values())
    equations = frozenset(row["name"] for row in chapter11["rows"]) if chapter11 else frozenset()
    site = Site(frozenset((*ids, *profiles)), keys, equations, bool(studies))
    front = book.model(list(models.values()), chapter11, studies)
    measured = {panel.key for panel in front["studies"]["error"].panels} if front["studies"]["error"] else set()
    calculators = scripts({i: models[i]["rows"] for i in ids}, derived, modules)
    files = {f"assets/{name}.js": text for name, text in calculators.items()}
    for i in ids:
        shown = page(models[i], derived, evidence, modules) | {"calculator": i in calculators}
        timed = [key for key in shown["keys"] if key in measured]
        files[f"{i}.html"] = site.render("page", shown | {"timed": timed, "has_shape": has_shape(shown)}, i)
    kinds = [(title, [_cells(member["name"], models) for member in members]) for title, _, members in front["kinds"]]
    matrix = {"columns": COLUMNS, "rows": kinds, "legend": LEGEND}
    files["index.html"] = site.render("index", front | matrix | home(front, models))
    parts = [(title, address) for title, address, _ in PARTS if address.startswith("reading")]
    files["reading.html"] = site.render("reading", front | {"parts": parts})
    if studies:
        files["study.html"] = site.render("study", studies_model(front["studies"]))
    if chapter11 is not None:
        files["chapter11.html"] = site.render("chapter11", {"chapter11": _with_errata(front["chapter11"])})
    files["assets/keys.js"] = search_index(models, derived, front, bool(studies))
    return files | assets()


FILTERS = {
    "pointed": "pointed", "round": "round", "flat": "flat", "worn": "worn or blunt", "long": "long: plane contact",
    "load": "pressure known",
}  # fmt: skip
"""What the buttons say, by the kind of the bodies."""
SMALL = 20.0
"""SVG units to one unit of the outline that the front of the book draws."""
NONE = "–"
"""Status of a physics that has no meaning for a profile."""
_WORN = re.compile(r"worn|blunt")


def home(front: Mapping[str, Any], models: Mapping[str, Mapping[str, Any]]) -> dict[str, Any]:
    """Groups of pictures, the filters that leave some of them, and the tips that are known by a name."""
    groups = [
        {**group, "cards": [_card(one, group["kind"], models) for line in group["lines"] for one in line]}
        for group in front["chart"]
    ]
    shown = {kind for group in groups for card in group["cards"] for kind in card["kinds"]}
    filters = {kind: words for kind, words in FILTERS.items() if kind in shown}
    return {"groups": groups, "filters": filters, "presets": _presets(front["tips"][0], models)} | {
        "citation": (TITLE, cited(front["version"], front["edition"]))
    }


def _card(one: Mapping[str, Any], kind: str, models: Mapping[str, Mapping[str, Any]]) -> dict[str, Any]:
    status = models[one["name"]]["status"]
    kinds = [kind, "worn"] if _WORN.search(one["words"]) else [kind]
    others = sorted((s for s in SYSTEMS if s.said.button), key=lambda s: s.medium.graded)
    physics = [(s.name, s.said.button) for s in others if status.get(s.name, LEFT_OUT) not in (LEFT_OUT, NONE)]
    return {**one, "picture": svg(one["shape"], SMALL), "kinds": kinds, "physics": physics}


def _presets(tip: tuple[str, str, str, str], models: Mapping[str, Mapping[str, Any]]) -> list[tuple[str, str, str]]:
    """Name of a tip, the entries for it, and the address of a calculator with its numbers; empty if there is none."""
    name, half, inclination, _ = tip
    blunted = [i for i in WORDS["Berkovich indenter, blunted"].split() if i in models]
    cone = rf"the \hyperref[sec:cone]{{cone}} of the same area, half-angle {half}°, $\theta={inclination}$°"
    others = ", ".join(rf"\hyperref[sec:{i}]{{{models[i]['title']}}}" for i in blunted)
    tipped = f"sphere_tipped_cone.html?theta={half}+half&R={_TIP:g}+nm" if "sphere_tipped_cone" in models else ""
    return [(name, cone, f"cone.html?theta={half}+half"), ("Berkovich, blunted", others, tipped)]


_TIP = 1e9 * float(str(CASES["sphere_tipped_cone"].parameters["R"]))
"""Radius of a usual tip in nm."""
UNIT = 8.0
"""SVG units to a millimetre."""


def _panel(panel: Panel, whole: Panels) -> Picture:
    return svg(panel_drawing(panel, whole), UNIT)


def studies_model(figures: Mapping[str, Any]) -> dict[str, Any]:
    """What the page of the studies shows, from `book.studies`; each part may be missing."""
    shown: dict[str, Any] = {"error": None, "speed": figures["speed"], "maps": None, "extremes": None}
    if figures["error"]:
        whole = figures["error"]
        shown["error"] = {"panels": [_panel(one, whole) for one in whole.panels], "methods": whole.methods}
    if figures["maps"]:
        found = figures["maps"]
        shown["maps"] = {
            "figures": [svg(map_drawing(one, printed=False), UNIT) for one in (*found.square, *found.plain)],
            "legend": found.legend,
        }
    if figures["extremes"]:
        shown["extremes"] = [row | {"problem": _linked(row), "anchor": _address(row)} for row in figures["extremes"]]
    return shown


def _address(row: Mapping[str, Any]) -> str:
    """extreme.b-to-0.cone: of the limit and the problem, which no other row has both."""
    # the sign tells k to -1 and k to 1 apart
    limit = slug(row["limit"].replace(r"\to", "to").replace("-", "minus ").translate(PLAIN))
    return f"extreme.{limit}.{row['problem']}"


PLAIN = str.maketrans({"$": None, "\\": None, "{": None, "}": None})
"""What LaTeX puts around the letters of a limit."""


def _linked(row: Mapping[str, Any]) -> str:
    """The problem, linked to the first of its formulas in the row."""
    problem, first = row["problem"], row["keys"].partition(",")[0]
    return rf"\hyperref[eq:{problem}.{first}]{{{escaped(problem)}}}"


COLUMNS = tuple(system.name for system in PRINTED if system.pool is ROUND)
"""Systems of the matrix; the other profiles have one system each."""


def _cells(profile_id: str, models: Mapping[str, Model]) -> dict[str, Any]:
    """A row of the matrix: the cells of `book.evidence`, or that of the only system a profile has."""
    title, status = models[profile_id]["title"], models[profile_id]["status"]
    own = COLUMNS if pool_of(profile_id) is ROUND else list(status)
    told = {*models[profile_id]["blocks"], BELOW.name}
    cells = [(name, _digits_below(status.get(name, LEFT_OUT)), name in told) for name in own]
    return {"name": profile_id, "title": title, "cells": cells, "span": len(COLUMNS) // len(cells)}


def _with_errata(chapter: Mapping[str, Any]) -> dict[str, Any]:
    """The chapter, each misprinted equation with the address of its erratum."""
    known = {erratum["place"] for erratum in chapter["errata"]}
    rows = []
    for row in chapter["rows"]:
        wrong = row["verdict"] == "misprint" and f"({row['name']})" in known
        rows.append({**row, "misprint": f"erratum.{row['name']}" if wrong else ""})
    return {**chapter, "rows": rows}


def _digits_below(cell: str) -> Markup:
    """2 √50 reads like a product; the digits stand lower, as in the book."""
    return Markup(re.sub(r"([○∫√=≈])(\d+)", r"\1<sub>\2</sub>", str(escape(cell))))


@dataclass(frozen=True)
class Site:
    """The profiles and keys there are pages for; a reference to another one stays plain text."""

    profiles: frozenset[str]
    keys: frozenset[str]
    equations: frozenset[str] = frozenset()
    """Of chapter 11, by number."""
    studied: bool = False

    def render(self, name: str, model: Model, profile_id: str = "") -> str:
        """The HTML of a page from the template of this name; links follow what the site has pages for."""
        environment = _environment()

        def link(label: str, text: str) -> Markup:
            # the words of the number of an equation are that number again
            shown = escape(text) if label.startswith("chapter:") else words(text, link)
            return self.link(label, shown, profile_id)

        environment.globals["studied"] = self.studied
        environment.filters.update(
            words=partial(words, link=link), tex=formula, prose=prose, slug=slug, anchor_of=anchor_of, plain=plain
        )
        return environment.get_template(f"{name}.html.j2").render(model)

    def link(self, label: str, text: Markup, profile_id: str) -> Markup:
        """Words as a link, where the site has its target."""
        kind, _, target = label.partition(":")
        if kind == "own":
            kind, target = "eq", f"{profile_id}.{target}"
        known = {"eq": self.keys, "sec": self.profiles, "chapter": self.equations}.get(kind)
        if known is not None and target not in known:
            return text
        page = "index" if target == "chart" else "reading"
        places = {"ref": f"reading.html#ref:{target}", "part": f"{page}.html#{target}"}
        places["chapter"] = f"chapter11.html#eq.{target}"
        place = places.get(kind) or self.place(target)
        name = Markup(' class="key"') if kind == "eq" and target.endswith(text.lstrip(".")) else ""
        return Markup('<a{} href="{}">{}</a>').format(name, place, text)

    def place(self, key: str) -> str:
        """Address of a profile or of a key: plane.wedge.html, cone.html#adh.Fc."""
        if key in self.profiles:
            return f"{key}.html"
        owner = max((i for i in self.profiles if key.startswith(f"{i}.")), key=len)
        return f"{owner}.html#{key[len(owner) + 1 :]}"


def _environment() -> jinja2.Environment:
    return jinja2.Environment(
        loader=jinja2.PackageLoader("axiderive.web"),
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=True,
        undefined=jinja2.StrictUndefined,
    )


def assets() -> dict[str, str]:
    """What every page loads: KaTeX with its fonts in the style sheet, the sheet and the script of the site."""
    folder = files("axiderive.web")
    vendored, own = folder / "katex", folder / "static"
    return {
        "assets/katex.js": (vendored / "katex.min.js").read_text(encoding="utf-8"),
        "assets/katex.css": _with_fonts((vendored / "katex.min.css").read_text(encoding="utf-8")),
        "assets/katex-license.txt": (vendored / "LICENSE").read_text(encoding="utf-8"),
        "assets/site.css": (own / "site.css").read_text(encoding="utf-8"),
        "assets/site.js": (own / "site.js").read_text(encoding="utf-8"),
        "assets/calculator.js": (own / "calculator.js").read_text(encoding="utf-8"),
    }


def _with_fonts(css: str) -> str:
    """The style sheet with its fonts inside, so that a page opened from a folder needs no second origin.

    Faces that no formula of the book uses are not vendored and left out.
    """

    def face(match: re.Match[str]) -> str:
        font = files("axiderive.web") / "katex" / "fonts" / match[1]
        if not font.is_file():
            return ""
        data = base64.b64encode(font.read_bytes()).decode()
        return _SOURCE.sub(f'src:url(data:font/woff2;base64,{data}) format("woff2")', match[0])

    return _FACE.sub(face, css)
