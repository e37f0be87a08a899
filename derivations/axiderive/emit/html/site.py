"""The whole web edition: a page per profile, an index with search, the front of the book, the studies, the chapter."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import jinja2
from markupsafe import Markup

from ...contact.systems import ROUND, SYSTEMS
from ...entry import Entry
from .. import book, spread
from ..handbook import Model, page_models, ruled, summary
from ..matrix import LEFT_OUT, LEGEND
from ..modules import package_sources
from . import study
from .assets import assets
from .page import Derived, page
from .words import formula, slug, words


def html_sources(
    derived: Derived,
    evidence: Mapping[str, Any] | None = None,
    chapter11: Mapping[str, Any] | None = None,
    models: Mapping[str, Model] | None = None,
    modules: Mapping[str, str] | None = None,
    studies: Mapping[str, Any] | None = None,
) -> dict[str, str]:
    """All files of the web edition.

    Parameters
    ----------
    derived : mapping
        Entries by suffix, by key of the problem.
    evidence : mapping, optional
        What was checked, by key of the problem; missing records are said to be missing.
    chapter11 : mapping, optional
        Record of the checks of the chapter.
    models : mapping, optional
        What `handbook.page_models` gives, where it is at hand.
    modules : mapping, optional
        Generated modules by path, from which the calls are read, where they are at hand.
    studies : mapping, optional
        Records of `axicontact study` by name: error, speed, maps, extremes.

    Returns
    -------
    dict of str to str
        Text by path below `handbook/html`.
    """
    evidence = evidence or {}
    models = page_models(derived, evidence) if models is None else models
    modules = package_sources(derived) if modules is None else modules
    ids = list(models)
    keys = frozenset(e.key for entries in derived.values() for e in entries.values())
    site = Site(frozenset(ids), keys, bool(studies))
    front = book.model([summary(model) for model in models.values()], chapter11, studies)
    measured = (studies or {}).get("error")
    files = {}
    for i in ids:
        timing = study.timing(measured, ruled(models[i])) if measured else None
        files[f"{i}.html"] = site.render("page", page(models[i], derived, evidence, modules) | {"timing": timing}, i)
    files["index.html"] = site.render(
        "index", front | {"columns": COLUMNS, "rows": _matrix(ids, models), "legend": LEGEND}
    )
    files["reading.html"] = site.render("reading", front)
    if studies:
        files["study.html"] = site.render("study", study.model(front["studies"]))
    if chapter11 is not None:
        files["chapter11.html"] = site.render("chapter11", front)
    files["assets/keys.js"] = search_index(ids, models, derived)
    return files | assets()


COLUMNS = tuple(system.name for system in SYSTEMS if system.pool is ROUND)
"""Systems of the matrix; the other profiles have one system each."""


def _matrix(ids: Sequence[str], models: Mapping[str, Model]) -> list[dict[str, Any]]:
    """Profile by physics: the cells of `emit.matrix`, or that of the only system a profile has."""
    rows = []
    for i in ids:
        status = models[i]["status"]
        own = COLUMNS if spread.pool_of(i) is ROUND else list(status)
        cells = [(name, status.get(name, LEFT_OUT)) for name in own]
        rows.append({"name": i, "title": models[i]["title"], "cells": cells, "span": len(COLUMNS) // len(cells)})
    return rows


def search_index(ids: Sequence[str], models: Mapping[str, Model], derived: Derived) -> str:
    """The index behind the search, as a script, because a page opened from a folder may load nothing else."""
    profiles = {i: [_plain(models[i]["title"]), _other_names(i)] for i in ids}
    numbers = {system.name: number for number, system in enumerate(SYSTEMS)}
    rows = [
        [entry.key, i, numbers[problem.system.name], entry.quantity.label, _names(entry)]
        for i in ids
        for problem in spread.problems_of(i)
        for entry in derived.get(problem.key, {}).values()
    ]
    record = {
        "profiles": profiles,
        "systems": [[system.title, SEARCHED.get(system.name, "")] for system in SYSTEMS],
        "keys": rows,
    }
    return f"window.axicontact = {json.dumps(record, ensure_ascii=False, separators=(',', ':'))};\n"


def _names(entry: Entry) -> str:
    return f"{entry.quantity.function} {entry.quantity.symbol}"


def _plain(text: str) -> str:
    return text.replace("$", "").replace("\\", "")


def _other_names(profile_id: str) -> str:
    """What else a profile is called, and whose work it is."""
    pool, name = spread.pool_of(profile_id), profile_id.rpartition(".")[2]
    profile = pool.load(name)
    return ", ".join([*profile.synonyms, *profile.sources])


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


@dataclass(frozen=True)
class Site:
    """The profiles and keys there are pages for; a reference to another one stays plain text."""

    profiles: frozenset[str]
    keys: frozenset[str]
    studied: bool = False

    def render(self, name: str, model: Model, profile_id: str = "") -> str:
        environment = _environment()

        def link(label: str, text: str) -> Markup:
            return self.link(label, words(text, link), profile_id)

        environment.globals["studied"] = self.studied
        environment.filters.update(words=partial(words, link=link), tex=formula, slug=slug)
        return environment.get_template(f"{name}.html.j2").render(model)

    def link(self, label: str, text: Markup, profile_id: str) -> Markup:
        """Words as a link, where the site has its target."""
        kind, _, target = label.partition(":")
        if kind == "own":
            kind, target = "eq", f"{profile_id}.{target}"
        known = {"eq": self.keys, "sec": self.profiles}.get(kind)
        if known is not None and target not in known:
            return text
        places = {"ref": f"reading.html#ref:{target}", "part": f"reading.html#{target}"}
        place = places.get(kind) or self.place(target)
        name = Markup(' class="key"') if kind == "eq" else ""
        return Markup('<a{} href="{}">{}</a>').format(name, place, text)

    def place(self, key: str) -> str:
        """Address of a profile or of a key: plane.wedge.html, cone.html#adh.Fc."""
        if key in self.profiles:
            return f"{key}.html"
        owner = max((i for i in self.profiles if key.startswith(f"{i}.")), key=len)
        return f"{owner}.html#{key[len(owner) + 1 :]}"


def _environment() -> jinja2.Environment:
    return jinja2.Environment(
        loader=jinja2.PackageLoader("axiderive.emit"),
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=True,
        undefined=jinja2.StrictUndefined,
    )
