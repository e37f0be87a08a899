"""What the search of the web edition knows: formulas, profiles, symbols, functions, equations, works, parts."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from ..book import spread
from ..book.back import WORDS
from ..book.guide import bibtex
from ..entry import Entry
from ..physics.systems import SYSTEMS, pool_of
from .page import Derived
from .words import plain, symbol

Place = tuple[str, str, str, int]
"""What is found, where it stands, further words by which it is looked for, and how far behind a formula it comes."""


def search_index(
    models: Mapping[str, Mapping[str, Any]], derived: Derived, front: Mapping[str, Any], studied: bool
) -> str:
    """The index behind the search, as a script, because a page opened from a folder may load nothing else."""
    profiles = {i: [plain(model["title"]), _other_names(i)] for i, model in models.items()}
    numbers = {system.name: number for number, system in enumerate(SYSTEMS)}
    known = [problem for i in (*FIRST, *models) if i in models for problem in spread.problems_of(i)]
    rows = [
        [entry.key, problem.profile_id, numbers[problem.system.name], entry.quantity.label, _names(entry)]
        for problem in sorted(dict.fromkeys(known), key=lambda problem: numbers[problem.system.name])
        for entry in derived.get(problem.key, {}).values()
    ]
    record = {
        "citation": bibtex(front["version"], front["edition"]),
        "first": FIRST,
        "profiles": profiles,
        "systems": [[_short(system.said.title), system.said.searched] for system in SYSTEMS],
        "keys": rows,
        "places": [
            *_of_profiles(models),
            *_of_front(front),
            *_of_words(models, derived),
            *_of_chapter(front["chapter11"]),
            *_of_studies(studied),
        ],
    }
    return f"window.axicontact = {json.dumps(record, ensure_ascii=False, separators=(',', ':'))};\n"


FIRST = ("cone", "paraboloid")
"""Whose formulas come first where no profile is named."""


def _names(entry: Entry) -> str:
    own = entry.quantity
    return " ".join([own.function, str(own.symbol), *(ALSO[word] for word in own.function.split("_") if word in ALSO)])


ALSO = {
    "depth": "penetration approach", "force": "load F_N FN", "pressure": "stress",
    "dgamma": "work of adhesion surface energy",
}  # fmt: skip
"""Other words for what a function gives or a symbol means."""


def _short(title: str) -> str:
    """Without what a contact is not, by which nobody looks for it."""
    return title.partition(" without ")[0]


def _other_names(profile_id: str) -> str:
    """What else a profile is called, and whose work it is."""
    pool, name = pool_of(profile_id), profile_id.rpartition(".")[2]
    profile = pool.load(name)
    return ", ".join([*profile.synonyms, *profile.sources])


def _of_profiles(models: Mapping[str, Mapping[str, Any]]) -> Iterator[Place]:
    for i, model in models.items():
        yield plain(model["title"]), f"{i}.html", f"{i} {_other_names(i)}", 0
        if has_shape(model):
            yield f"{i}.f", f"{i}.html#f", f"{plain(model['title'])} profile shape definition", 2


def has_shape(model: Mapping[str, Any]) -> bool:
    """Whether the panel of a page gives the profile f, whose key ends in .f."""
    return any(label == "Profile" for label, _ in model["panel"])


def _of_front(front: Mapping[str, Any]) -> Iterator[Place]:
    """The home page and the page on reading."""
    for title, address, also in PARTS:
        yield title, address, also, 0
    for law in front["laws"]:
        yield plain(law.name), "reading.html#laws", f"{law.suffix} viscoelastic law creep relaxation retraction Ting", 0
    for one in (row for _, rows in front["notation"] for row in rows):
        names = f"{one['name']} {symbol(one['latex'])} {ALSO.get(one['name'], '')}"
        yield plain(one["meaning"]), f"reading.html#symbol.{one['name']}", names, 2
    for one in front["masters"]:
        yield plain(one["remark"]), f"reading.html#{anchor_of(one)}", f"{symbol(one['name'])} special function", 2
    for label, work, _ in front["works"]:
        yield plain(work), f"reading.html#{label}", "reference", 6


PARTS: Sequence[tuple[str, str, str]] = (
    ("Which profile?", "index.html#chart", "choose choice pictures"),
    ("All profiles", "index.html#profiles", "table contents"),
    ("Profile and physics", "index.html#matrix", "matrix certified status"),
    ("How to cite", "index.html#imprint", "citation BibTeX edition licence"),
    ("Reading an entry", "reading.html#howto", "certificate help"),
    ("Conventions", "reading.html#conventions", "signs"),
    ("When does it hold?", "reading.html#validity", "limits slope"),
    ("Ends of the keys", "reading.html#suffixes", "suffix"),
    ("Notation", "reading.html#notation", "symbols"),
    ("Definitions", "reading.html#definitions", "integral"),
    ("Special functions as used", "reading.html#functions", "elliptic integral"),
    ("Rules for every profile", "reading.html#rules", "graded"),
    ("Viscoelastic laws", "reading.html#laws", "Maxwell Kelvin Voigt standard solid power-law creep relaxation"),
    ("References", "reading.html#references", "literature sources works"),
)
"""Title, address and further words of the parts of the book on the home page and the page on reading."""


def _of_words(models: Mapping[str, Any], derived: Derived) -> Iterator[Place]:
    """The words of the index of the book, each with the places that it leads to in their order."""
    parts = {f"part:{address.partition('#')[2]}": (title, address) for title, address, _ in PARTS}
    profiles = {i: (plain(model["title"]), f"{i}.html") for i, model in models.items()}
    formulas = {
        entry.key: (entry.key, f"{i}.html#{entry.key[len(i) + 1 :]}")
        for i in models
        for problem in spread.problems_of(i)
        for entry in derived.get(problem.key, {}).values()
    }
    known = parts | profiles | formulas
    for word, names in WORDS.items():
        for place, name in enumerate(name for name in names.split() if name in known):
            title, address = known[name]
            if title.lower() != word.lower():
                yield plain(word), address, title, 3 + place


def _of_chapter(chapter: Mapping[str, Any] | None) -> Iterator[Place]:
    if chapter is None:
        return
    yield "Chapter 11, equation by equation", "chapter11.html", "Popov Heß Willert book", 0
    yield "Errata of chapter 11", "chapter11.html#errata", "erratum misprint", 0
    for row in chapter["rows"]:
        yield f"({row['name']})", f"chapter11.html#eq.{row['name']}", f"{row['verdict']} {plain(row['title'])}", 6


def _of_studies(studied: bool) -> Iterator[Place]:
    if studied:
        yield "Error against run time", "study.html#error", "study accuracy benchmark", 0
        yield "What a call costs", "study.html#speed", "speed timing benchmark", 0
        yield "Stability maps", "study.html#maps", "cancellation ulp", 0
        yield "Stiff and extreme cases", "study.html#extremes", "overflow limits", 0


def anchor_of(function: Mapping[str, str]) -> str:
    """function.chi_2 of what the front names chi_2(x)."""
    return "function." + re.sub(r"\\(?:mathrm|mathbf)|[^\w]", "", function["name"].partition("(")[0]).strip("_")
