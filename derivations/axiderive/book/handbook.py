"""The handbook: one LaTeX file per profile and a main file, from the same entries as everything else.

The page model is plain data for the templates, which hold layout only.  A
profile's file is a pure function of its own problems, so that the files can be
made in any order and in several processes.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

import jinja2

from .. import __version__
from ..entry import Entry
from ..figures.axes import drawn, printed
from ..figures.tikz import tikz
from ..physics.systems import profile_ids
from ..print.box import width
from ..rows import special
from ..rows.row import Row
from . import back, book, spread
from .studies import map_drawing, panel_drawing

Derived = Mapping[str, Mapping[str, Entry]]
Model = Mapping[str, Any]


def handbook_sources(
    derived: Derived,
    evidence: Mapping[str, Any] | None = None,
    chapter11: Mapping[str, Any] | None = None,
    models: Mapping[str, Model] | None = None,
    studies: Mapping[str, Any] | None = None,
) -> dict[str, str]:
    """All LaTeX files of the handbook, as text by path relative to its folder.

    Parameters
    ----------
    derived : mapping
        Entries by suffix, by key of the problem.
    evidence : mapping, optional
        What was checked, by key of the problem; missing records are said to be missing.
    chapter11 : mapping, optional
        Record of the checks of the chapter, as `chapter11.record.record` makes it.
    models : mapping, optional
        What `page_models` gives, where it is at hand.
    studies : mapping, optional
        Records of `axicontact study` by name: error, speed, maps, extremes.
    """
    models = page_models(derived, evidence or {}) if models is None else models
    template = templates().get_template("profile.tex.j2")
    files = {
        f"profiles/{name}.tex": template.render(model, hosted=[models[i] for i in special.hosted(name) if i in models])
        for name, model in models.items()
        if not model["host"]
    }
    return files | book_sources(list(models.values()), chapter11, studies)


def page_models(derived: Derived, evidence: Mapping[str, Any]) -> dict[str, Model]:
    """What the page of every profile shows, in print and on the web, in the order of the handbook.

    A model is a pure function of the problems of its profile.
    """
    ids = [i for i in profile_ids() if any(p.key in derived for p in spread.problems_of(i))]
    return {i: spread.model(i, derived, evidence, number) for i, number in numbered(ids).items()}


def approached(model: Model, system: str) -> list[dict[str, Any]]:
    """What was checked of the limits of a contact: key, formula, digits and points."""
    rows = model["blocks"][system].approached if system in model["blocks"] else []
    return [check for row in rows for check in row.checks]


def book_sources(
    models: Sequence[Model], chapter11: Mapping[str, Any] | None = None, studies: Mapping[str, Any] | None = None
) -> dict[str, str]:
    """The main file and its preamble, from the pages of the profiles in their order."""
    environment = templates()
    model = book.model(models, chapter11, studies)
    preamble = environment.get_template("preamble.tex.j2").render(version=__version__, edition=model["edition"])
    return {"preamble.tex": preamble, "handbook.tex": environment.get_template("handbook.tex.j2").render(model)}


def numbered(ids: Sequence[str]) -> dict[str, str]:
    """Section numbers, in the order of `book.ENTRIES`; a special case has that of its host."""
    hosts = {i: special.HOSTS.get(i, i) for i in ids}
    found = {
        name: f"{chapter}.{section}"
        for chapter, entries in enumerate(book.ENTRIES.values(), 1)
        for section, name in enumerate((name for name in entries if name in hosts.values()), 1)
    }
    return {i: found[host] for i, host in hosts.items()}


def templates() -> jinja2.Environment:
    """The Jinja environment of the LaTeX templates, with their own delimiters; an undefined name is an error."""
    environment = jinja2.Environment(
        loader=jinja2.PackageLoader("axiderive.book"),
        block_start_string=r"\BLOCK{",
        block_end_string="}",
        variable_start_string=r"\VAR{",
        variable_end_string="}",
        comment_start_string=r"\#{",
        comment_end_string="}",
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=False,
        undefined=jinja2.StrictUndefined,
    )
    environment.globals.update(
        remark=remark,
        behind=behind,
        drawn=drawn,
        map_drawing=partial(map_drawing, printed=True),
        panel_drawing=panel_drawing,
        printed=printed,
        tikz=tikz,
        numbers=numbers,
        chapter_source=back.label("Popov, Heß & Willert 2019"),
    )
    return environment


def remark(one: Row) -> str:
    """The words behind a formula with the keys they refer to."""
    key = rf" \own{{{one.refers}}}" if one.refers else ""
    return rf"\remark{{{one.remark}{key}}}" if one.remark else ""


ROOM = 380.0
"""Points for a formula without a key and the words behind it."""


def behind(tex: str, words: str) -> str:
    """A formula with the words behind its last line, or on one more where that is full."""
    if not words:
        return tex
    opening, closing, gap = r"\begin{aligned}[t]&", r"\end{aligned}", r"\\[1.5mm]&"
    lines = tex.removeprefix(opening).removesuffix(closing).split(gap)
    # 8.4 point type, and the spaces, which a formula does not have
    room = ROOM - 12.0 - 0.84 * width(words) - 2.1 * words.count(" ")
    if width(lines[-1]) > room:
        lines.append("")
    lines[-1] += rf"\remark{{{words}}}"
    return lines[0] if len(lines) == 1 else opening + gap.join(lines) + closing


def numbers(equations: Sequence[str]) -> str:
    """(11.16), (11.18), (11.20) as (11.16, 18, 20)."""
    found: list[str] = []
    chapter = ""
    for text in equations:
        before, _, number = text.strip("()").partition(".")
        found.append(number if before == chapter else f"{before}.{number}")
        chapter = before
    return f"({', '.join(found)})"
