"""What the search of the web edition knows: formulas, profiles, symbols, functions, equations, works, parts."""

from __future__ import annotations

import json
import re
import unicodedata
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from markupsafe import Markup

from ...contact.systems import SYSTEMS
from ...entry import Entry
from .. import spread
from .page import Derived
from .words import words

Place = tuple[str, str, str, int]
"""What is found, where it stands, further words by which it is looked for, and how far behind a formula it comes."""


def search_index(
    models: Mapping[str, Mapping[str, Any]], derived: Derived, front: Mapping[str, Any], studied: bool
) -> str:
    """The index behind the search, as a script, because a page opened from a folder may load nothing else."""
    profiles = {i: [plain(model["title"]), _other_names(i)] for i, model in models.items()}
    numbers = {system.name: number for number, system in enumerate(SYSTEMS)}
    rows = [
        [entry.key, i, numbers[problem.system.name], entry.quantity.label, _names(entry)]
        for i in models
        for problem in spread.problems_of(i)
        for entry in derived.get(problem.key, {}).values()
    ]
    record = {
        "profiles": profiles,
        "systems": [[_short(system.title), SEARCHED.get(system.name, "")] for system in SYSTEMS],
        "keys": rows,
        "places": [
            *_of_profiles(models),
            *_of_front(front),
            *_of_words(front["word_index"], models),
            *_of_chapter(front["chapter11"]),
            *_of_studies(studied),
        ],
    }
    return f"window.axicontact = {json.dumps(record, ensure_ascii=False, separators=(',', ':'))};\n"


def _names(entry: Entry) -> str:
    own = entry.quantity
    return " ".join([own.function, str(own.symbol), *(ALSO[word] for word in own.function.split("_") if word in ALSO)])


ALSO = {
    "depth": "penetration approach", "force": "load F_N FN", "pressure": "stress",
    "dgamma": "work of adhesion surface energy",
}  # fmt: skip
"""Other words for what a function gives or a symbol means."""

SEARCHED = {
    "normal": "indentation",
    "adhesive": "adhesion JKR Johnson Kendall Roberts Hess pull-off",
    "tangential": "friction partial slip Cattaneo Mindlin Ciavarella Jäger traction",
    "viscoelastic": "creep relaxation Lee Radok rheology",
    "graded.normal": "FGM functionally graded gradient",
    "graded.adhesive": "FGM functionally graded gradient adhesion JKR pull-off",
    "graded.tangential": "FGM functionally graded gradient friction partial slip Cattaneo Mindlin",
    "plane": "two-dimensional line contact roller strip",
    "loads": "prescribed pressure loaded circle",
    "materials": "effective modulus Young Poisson",
}
"""Words by which a physics is looked for and that its title does not have."""


def _short(title: str) -> str:
    """Without what a contact is not, by which nobody looks for it."""
    return title.partition(" without ")[0]


def _other_names(profile_id: str) -> str:
    """What else a profile is called, and whose work it is."""
    pool, name = spread.pool_of(profile_id), profile_id.rpartition(".")[2]
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
    """The index and the page on reading."""
    yield "All profiles", "index.html#profiles", "table contents", 0
    yield "Profile and physics", "index.html#matrix", "matrix certified status", 0
    for title, anchor, also in PARTS:
        yield title, f"reading.html#{anchor}", also, 0
    for law in front["laws"]:
        yield plain(law.name), "reading.html#laws", f"{law.suffix} viscoelastic law creep relaxation", 0
    for one in (row for _, rows in front["notation"] for row in rows):
        names = f"{one['name']} {symbol(one['latex'])} {ALSO.get(one['name'], '')}"
        yield plain(one["meaning"]), f"reading.html#symbol.{one['name']}", names, 3
    for one in front["masters"]:
        yield plain(one["remark"]), f"reading.html#{anchor_of(one)}", f"{symbol(one['name'])} special function", 3
    for label, work, _ in front["works"]:
        yield plain(work), f"reading.html#{label}", "reference", 6


PARTS: Sequence[tuple[str, str, str]] = (
    ("Reading an entry", "howto", "certificate help"),
    ("Conventions", "conventions", "signs units modulus half-angle Berkovich Vickers reduced modulus"),
    ("When does it hold?", "validity", "limits slope layer thickness Tabor yield Dundurs DMT"),
    ("Which profile?", "chart", "choose choice"),
    ("Ends of the keys", "suffixes", "suffix"),
    ("Notation", "notation", "symbols units"),
    ("Definitions", "definitions", "Abel integral dimensionality reduction"),
    ("Special functions as used", "functions", "elliptic integral"),
    ("Rules for every profile", "rules", "graded"),
    ("Viscoelastic laws", "laws", "Maxwell Kelvin Voigt standard solid power-law creep relaxation"),
    ("References", "references", "literature sources works"),
)
"""Title, anchor and further words of the parts of the page on reading."""


def _of_words(index: Sequence[tuple[str, Sequence[str]]], models: Mapping[str, Any]) -> Iterator[Place]:
    """The words of the index of the book, each with the profiles and the parts on reading that it leads to."""
    parts = {anchor: title for title, anchor, _ in PARTS}
    for word, labels in index:
        for kind, _, target in (label.partition(":") for label in labels):
            if kind == "sec" and target in models:
                yield f"{plain(word)}: {plain(models[target]['title'])}", f"{target}.html", "", 12
            elif kind == "part" and target in parts:
                yield f"{plain(word)}: {parts[target]}", f"reading.html#{target}", "", 12


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


def plain(text: str) -> str:
    """Running text without links and the marks of LaTeX; its formulas in letters."""
    return symbol(str(words(text, lambda label, shown: Markup("{}").format(shown)).striptags()))


def anchor_of(function: Mapping[str, str]) -> str:
    """function.chi_2 of what the front names chi_2(x)."""
    return "function." + re.sub(r"\\(?:mathrm|mathbf)|[^\w]", "", function["name"].partition("(")[0]).strip("_")


def symbol(latex: str) -> str:
    r"""A symbol in letters of Unicode: E^{*} is E*, \Delta\gamma is Δγ."""
    text = re.sub(r"\\([A-Za-z]+) ?", lambda match: _letter(match[1]), latex)
    return re.sub(r"[\\{}$^]", "", text)


def _letter(name: str) -> str:
    if name in LEFT_OUT:
        return ""
    small = name.removeprefix("var").replace("lambda", "lamda")
    size = "CAPITAL" if name[0].isupper() else "SMALL"
    try:
        return unicodedata.lookup(f"GREEK {size} LETTER {small.upper()}")
    except KeyError:
        return f"{name} "


LEFT_OUT = {"mathrm", "mathbf", "bar", "operatorname", "tfrac", "frac", "displaystyle", "left", "right"}
