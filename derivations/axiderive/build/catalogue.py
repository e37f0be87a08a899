"""The catalogue as a pure function: profiles in, `{relative path: bytes}` out."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, TypeVar

from ..store.cache import Cache, digest
from ..store.sources import import_digest, source_digest
from ..store.writing import RECEIPTS, STUDIES
from . import pool, work
from .comparison import CHAPTER, Book, Record, receipts_bytes
from .work import Outcome, Settings

if TYPE_CHECKING:
    from ..entry import Entry
    from ..physics.systems import Problem

EMITTING = (*work.WRITING, "axiderive.build.catalogue", "axiderive.store.index")

Published = list[tuple["Problem", Outcome]]
Taken = TypeVar("Taken")


@dataclass(frozen=True)
class Failure:
    """Something that keeps a problem out of the catalogue: a formula that failed a check, or a defect."""

    key: str
    message: str
    trace: str = ""


@dataclass(frozen=True)
class Catalogue:
    """The files of the catalogue, and what there is to tell about them."""

    files: dict[str, bytes]
    outcomes: tuple[Outcome, ...]
    failures: tuple[Failure, ...]
    kept: tuple[int, int]
    """Problems whose checks, and whose measured errors, were taken over from what is published."""
    worse: tuple[tuple[str, str], ...] = ()
    """Functions whose measured errors have jumped beyond those published, as key and sentence."""


def build(
    ids: Sequence[str],
    *,
    cache: Cache,
    settings: Settings | None = None,
    standing: Mapping[str, Record] = MappingProxyType({}),
    book: Book | None = None,
    jobs: pool.Jobs = 1,
    report: Callable[[Outcome], None] = lambda outcome: None,
    printed: Callable[[Mapping[str, bytes]], None] = lambda sources: None,
) -> Catalogue:
    """Derive, verify and emit every problem of the named profiles.

    Parameters
    ----------
    ids : sequence of str
        Profiles as `physics.systems.profile_ids` lists them; the catalogue keeps that order.
    cache : Cache
        Where finished problems are kept and looked for; it does not change the result.
    settings : Settings, optional
        Digits, number of points and seed of the numerical checks.
    standing : mapping of str to dict
        What is published, by key of the problem, as `comparison.standing` reads it: checks and measured errors are
        taken over where their inputs are the same, and errors measured anew stay as published where they agree.
    book : Book, optional
        The book that the pages of these profiles belong to; one of their own otherwise.
    jobs : int or concurrent.futures.Executor
        Number of processes, or what runs the tasks; this process alone writes what they bring.
    report : callable
        Called with each outcome as it is ready.
    printed : callable
        Called with the sources of the handbook, by path, before the web edition is made of the same pages.

    Returns
    -------
    Catalogue
        The files do not depend on `jobs`, on the cache or on the hash seed.
    """
    from ..chapter11.errata import failures as wrong_equations
    from ..physics.systems import problems

    settings = settings or Settings()
    wanted = list(problems(ids))
    found: dict[str, Outcome] = {}
    for problem in wanted:
        outcome = work.stored(problem, cache, settings)
        if outcome is not None:
            found[problem.key] = outcome
            report(outcome)
    missing = sorted((problem for problem in wanted if problem.key not in found), key=_expected_effort, reverse=True)
    tasks = [(own.key, str(cache.folder), cache.fresh, settings, standing.get(own.key, {})) for own in missing]
    for outcome in pool.run(work.task, tasks, jobs):
        for key, value in outcome.made.items():
            cache.put(key, value)
        found[outcome.key] = outcome
        report(outcome)
    outcomes = tuple(found[problem.key] for problem in wanted)
    published, failures = _publishable(wanted, found)
    chapter = _chapter(cache, jobs, standing.get(CHAPTER, {})) if len(wanted) == len(list(problems())) else None
    failures += [Failure("chapter", sentence) for sentence in (wrong_equations(chapter) if chapter else ())]
    modules = package(published, cache, jobs)
    published, kept, measured = _measured(published, modules, standing, cache, jobs)
    book = book or Book(tuple(dict.fromkeys(problem.profile_id for problem, _ in published)), chapter)
    files = emitted(published, modules, book, cache, settings, jobs, printed)
    if published:
        files[RECEIPTS] = receipts_bytes(_receipts(published, settings, measured, chapter))
    taken_over = sum(outcome.kept for outcome in outcomes), kept
    return Catalogue(files, outcomes, tuple(failures), taken_over, _worse(published, standing))


def _chapter(cache: Cache, jobs: pool.Jobs, standing: Mapping[str, Any]) -> Record:
    """What the equations of chapter 11 come to; their checks compare with entries of the engine too."""
    from ..chapter11.equation import run
    from ..chapter11.errata import record

    key = work.chapter_key()
    kept = None if cache.fresh else work.taken_over(standing, "record", key)
    runner = partial(pool.run, jobs=jobs, ordered=True)
    return dict(cache.made(key, lambda: record(tuple(run(runner=runner)))) if kept is None else kept)


def _expected_effort(problem: Problem) -> tuple[int, int, int]:
    """Longest first, so that no process is left alone with a long task at the end."""
    profile = problem.profile
    return int(problem.system.medium.graded), len(profile.pieces) + len(profile.abbreviations), len(profile.parameters)


def _publishable(wanted: Sequence[Problem], found: Mapping[str, Outcome]) -> tuple[Published, list[Failure]]:
    """What may be published: a problem with a failed check is left out, and so is what rests on it."""
    published: Published = []
    failures: list[Failure] = []
    lost: set[str] = set()
    for problem in wanted:
        outcome = found[problem.key]
        if outcome.error:
            failures.append(Failure(problem.key, outcome.error, outcome.trace))
        failures += [Failure(failure["key"], failure["message"]) for failure in outcome.failures]
        if outcome.error or outcome.failures:
            lost.add(problem.key)
        elif problem.base and problem.base.key in lost:
            failures.append(Failure(problem.key, f"rests on {problem.base.key}"))
            lost.add(problem.key)
        else:
            published.append((problem, outcome))
    return published, failures


def _measured(
    published: Published, package: Mapping[str, str], standing: Mapping[str, Record], cache: Cache, jobs: pool.Jobs
) -> tuple[Published, int, dict[str, str]]:
    """The same with the errors of the emitted functions among the evidence.

    Also of how many problems they were taken over, and the keys of their inputs.
    """
    from ..stable.measure import closure
    from ..stable.records import MEASURED, settled

    errors, inputs, kept, tasks = {}, {}, 0, []
    for own, outcome in sorted(published, key=lambda pair: _expected_effort(pair[0]), reverse=True):
        if own.system in MEASURED:
            sources = closure(package, own.module)
            inputs[own.key] = work.evaluation_key(own, outcome.entries, sources)
            found, taken = work.measured(inputs[own.key], cache, standing.get(own.key, {}))
            kept += taken
            if found is None:
                tasks.append((own.key, outcome.entries, sources))
            else:
                errors[own.key] = found
    for key, measured in pool.run(work.evaluation, tasks, jobs):
        cache.put(inputs[key], measured)
        errors[key] = measured
    errors = {key: settled(standing.get(key, {}).get("evaluation") or {}, found) for key, found in errors.items()}
    whole = [
        (problem, replace(outcome, evidence=outcome.evidence | {"evaluation": errors[problem.key]}))
        if problem.key in errors
        else (problem, outcome)
        for problem, outcome in published
    ]
    return whole, kept, inputs


def _worse(published: Published, standing: Mapping[str, Record]) -> tuple[tuple[str, str], ...]:
    """The functions whose errors have jumped since they were published."""
    from ..stable.records import jumps

    found = []
    for own, outcome in published:
        kept = standing.get(own.key, {}).get("evaluation") or {}
        lines = jumps(kept, outcome.evidence.get("evaluation", {}))
        found += [(f"{own.key}.{suffix}", line) for suffix, line in lines]
    return tuple(found)


def _receipts(published: Published, settings: Settings, measured: Mapping[str, str], chapter: Record | None) -> Record:
    """What the checks and the measured errors of each problem, and the record of the chapter, were made of."""
    from .verification import checks_of

    found = {}
    for problem, outcome in published:
        made_of = work.checking_key(problem, outcome.entries, settings)
        found[problem.key] = {"checks": work.receipt(made_of, checks_of(outcome.evidence))}
        if problem.key in measured:
            found[problem.key]["evaluation"] = work.receipt(measured[problem.key], outcome.evidence["evaluation"])
    if chapter is not None:
        found[CHAPTER] = {"record": work.receipt(work.chapter_key(), chapter)}
    return found


def package(published: Published, cache: Cache, jobs: pool.Jobs) -> dict[str, str]:
    """The modules by path; those of the profiles are written side by side."""
    from ..code.python import package_sources

    records = {problem.key: outcome.entries for problem, outcome in published}
    key = digest([work.FORMAT, "package", source_digest(*work.WRITING), records])

    def write() -> dict[str, str]:
        tasks = [(own,) for own in _by_profile(published, lambda outcome: outcome.entries).values()]
        written = {path: text for texts in pool.run(_modules, tasks, jobs) for path, text in texts.items()}
        return package_sources(_derived(published), kernels(cache), written)

    return dict(cache.made(key, write))


def _modules(records: dict[str, Record]) -> dict[str, str]:
    """The modules of one profile, from the stored entries of its problems."""
    from ..code.python import module_sources
    from ..physics.systems import problem

    return module_sources({key: work.read_entries(problem(key), entries) for key, entries in records.items()})


def _by_profile(published: Published, taken: Callable[[Outcome], Taken]) -> dict[str, dict[str, Taken]]:
    """What is taken of the outcomes, by profile and problem."""
    found: dict[str, dict[str, Taken]] = {}
    for problem, outcome in published:
        found.setdefault(problem.profile_id, {})[problem.key] = taken(outcome)
    return found


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
    sources = [source_digest(*EMITTING), import_digest("axiderive.build.catalogue._emit")]
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
    models, formulas = _pages(published, book.ids, jobs)
    pages = handbook.handbook_sources(derived, evidence, book.chapter, models, studies)
    printed({path: text.encode() for path, text in pages.items()})
    texts |= {f"handbook/{path}": text for path, text in pages.items()}
    site = web.html_sources(derived, evidence, book.chapter, models, texts, studies, book.ids)
    texts |= {f"handbook/html/{path}": text for path, text in site.items()}
    files = texts | {"axicontact/index.json": dumps(index.index_record(derived, evidence, texts, formulas))}
    for problem, outcome in published:
        checks = handbook.approached(models[problem.profile_id], problem.system.name)
        found = outcome.evidence | ({"approaches": checks} if checks else {})
        record = index.evidence_record(problem, outcome.entries, found)
        files[f"evidence/{problem.key}.json"] = index.to_text(record)
    if book.chapter is not None:
        files["evidence/chapter11.json"] = index.to_text(book.chapter)
    return files


def _pages(published: Published, ids: Sequence[str], jobs: pool.Jobs) -> tuple[dict[str, Record], Record]:
    """What the page of every profile shows, in the order of the handbook, and the formulas as the index has them."""
    from ..book import handbook

    own = _by_profile(published, lambda outcome: (outcome.entries, outcome.evidence))
    numbers = handbook.numbered(ids)
    made, formulas = dict[str, Record](), Record()
    for name, model, texts in pool.run(_page, [(name, found, numbers[name]) for name, found in own.items()], jobs):
        made[name] = model
        formulas |= texts
    return {name: made[name] for name in own}, formulas


def _page(profile_id: str, found: dict[str, tuple[Record, Record]], number: str) -> tuple[str, Record, Record]:
    """The page of one profile and its formulas, which are set once for both, from what is stored of its problems."""
    from ..book import index, spread
    from ..physics.systems import problem

    derived = {key: work.read_entries(problem(key), entries) for key, (entries, _) in found.items()}
    evidence = {key: record for key, (_, record) in found.items()}
    return profile_id, spread.model(profile_id, derived, evidence, number), index.formulas_of(derived)
