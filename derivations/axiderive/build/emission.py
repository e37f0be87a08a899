"""What is written of checked problems: modules, handbook, web edition, index and evidence."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from ..store.cache import Cache, digest
from ..store.sources import import_digest, source_digest
from ..store.writing import STUDIES
from . import pool, work
from .work import Outcome, Settings

if TYPE_CHECKING:
    from ..entry import Entry
    from ..physics.systems import Problem

EMITTING = (*work.WRITING, "axiderive.build.emission", "axiderive.store.index")

Published = list[tuple["Problem", Outcome]]
Record = dict[str, Any]


@dataclass(frozen=True)
class Book:
    """What pages need of the book they belong to: its profiles, which number them, and the checks of chapter 11."""

    ids: tuple[str, ...]
    chapter: Record | None


def package(published: Published, cache: Cache) -> dict[str, str]:
    """The modules by path."""
    from ..code.python import package_sources

    records = {problem.key: outcome.entries for problem, outcome in published}
    key = digest([work.FORMAT, "package", source_digest(*work.WRITING), records])
    return dict(cache.made(key, lambda: package_sources(_derived(published), kernels(cache))))


def kernels(cache: Cache) -> str:
    """The text of `kernels.py`, which no profile changes: to fit them anew is a fourth of a small build."""
    from ..code import tables

    versions = [work.installed(name) for name in ("mpmath", "python-flint")]
    key = digest([work.FORMAT, "kernels", versions, import_digest("axiderive.code.tables.kernels_source")])
    return str(cache.made(key, tables.kernels_source))


def _derived(published: Published) -> dict[str, dict[str, Entry]]:
    return {problem.key: work.read_entries(problem, outcome.entries) for problem, outcome in published}


def emitted(
    published: Published,
    modules: Mapping[str, str],
    book: Book,
    cache: Cache,
    settings: Settings,
    jobs: pool.Jobs,
    printed: Callable[[Mapping[str, bytes]], None],
) -> dict[str, bytes]:
    """Every file of the catalogue as bytes by path, in order of path; from the cache where nothing has changed.

    `printed` is called with the sources of the handbook as soon as they are there, if they are made anew.
    """
    results = [[problem.key, outcome.entries, outcome.evidence] for problem, outcome in published]
    studies = study_records()
    sources = [source_digest(*EMITTING), import_digest("axiderive.build.emission")]
    key = digest([work.FORMAT, "emission", sources, settings.record(), results, book.ids, book.chapter, studies])
    texts = cache.made(key, lambda: _emit(published, modules, book, studies, jobs, printed))
    return {path: text.encode() for path, text in sorted(texts.items())}


def study_records() -> dict[str, Record]:
    """The records of `axicontact study` beside the evidence, by name; the book draws them."""
    folder = work.project_root() / "catalogue" / STUDIES
    return {path.stem: json.loads(path.read_bytes()) for path in sorted(folder.glob("*.json"))}


def _emit(
    published: Published,
    modules: Mapping[str, str],
    book: Book,
    studies: Mapping[str, Record],
    jobs: pool.Jobs,
    printed: Callable[[Mapping[str, bytes]], None],
) -> dict[str, str]:
    from .. import web
    from ..book import handbook, index
    from ..store.index import dumps

    derived = _derived(published)
    evidence = {problem.key: outcome.evidence for problem, outcome in published}
    texts = dict(modules)
    models = _page_models(published, book.ids, jobs)
    pages = handbook.handbook_sources(derived, evidence, book.chapter, models, studies)
    printed({path: text.encode() for path, text in pages.items()})
    texts |= {f"handbook/{path}": text for path, text in pages.items()}
    site = web.html_sources(derived, evidence, book.chapter, models, texts, studies)
    texts |= {f"handbook/html/{path}": text for path, text in site.items()}
    files = texts | {"axicontact/index.json": dumps(index.index_record(derived, evidence, texts))}
    for problem, outcome in published:
        checks = handbook.approached(models[problem.profile_id], problem.system.name)
        found = outcome.evidence | ({"approaches": checks} if checks else {})
        record = index.evidence_record(problem, outcome.entries, found)
        files[f"evidence/{problem.key}.json"] = index.to_text(record)
    if book.chapter is not None:
        files["evidence/chapter11.json"] = index.to_text(book.chapter)
    return files


def _page_models(published: Published, ids: Sequence[str], jobs: pool.Jobs) -> dict[str, Record]:
    """What the page of every profile shows, in the order of the handbook; made side by side."""
    from ..book import handbook

    own: dict[str, dict[str, tuple[Record, Record]]] = {}
    for problem, outcome in published:
        own.setdefault(problem.profile_id, {})[problem.key] = (outcome.entries, outcome.evidence)
    numbers = handbook.numbered(ids)
    made = dict(pool.run(_page_model, [(name, found, numbers[name]) for name, found in own.items()], jobs))
    return {name: made[name] for name in own}


def _page_model(profile_id: str, found: dict[str, tuple[Record, Record]], number: str) -> tuple[str, Record]:
    """The page of one profile, from what is stored of its problems."""
    from ..book import spread
    from ..physics.systems import problem

    derived = {key: work.read_entries(problem(key), entries) for key, (entries, _) in found.items()}
    evidence = {key: record for key, (_, record) in found.items()}
    return profile_id, spread.model(profile_id, derived, evidence, number)
