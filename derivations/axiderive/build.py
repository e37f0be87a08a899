"""The catalogue as a pure function: profiles in, `{relative path: bytes}` out."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import TYPE_CHECKING

from . import emission, pool, work
from .cache import Cache, digest, source_digest
from .emission import Book, Published, Record
from .work import Outcome, Settings

if TYPE_CHECKING:
    from .contact.systems import Problem


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


def build(
    ids: Sequence[str],
    *,
    cache: Cache,
    settings: Settings | None = None,
    standing: Mapping[str, Record] = MappingProxyType({}),
    book: Book | None = None,
    jobs: int = 1,
    report: Callable[[Outcome], None] = lambda outcome: None,
) -> Catalogue:
    """Derive, verify and emit every problem of the named profiles.

    Parameters
    ----------
    ids : sequence of str
        Profiles as `contact.systems.profile_ids` lists them; the catalogue keeps that order.
    cache : Cache
        Where finished problems are kept and looked for; it does not change the result.
    settings : Settings, optional
        Digits, number of points and seed of the numerical checks.
    standing : mapping of str to dict
        Measured errors as they are published, by key of the problem; they stay where those of this machine agree.
    book : Book, optional
        The book that the pages of these profiles belong to; one of their own otherwise.
    jobs : int
        Number of processes.
    report : callable
        Called with each outcome as it is ready.

    Returns
    -------
    Catalogue
        The files do not depend on `jobs`, on the cache or on the hash seed.
    """
    from .contact.systems import problems

    settings = settings or Settings()
    wanted = list(problems(ids))
    found: dict[str, Outcome] = {}
    for problem in wanted:
        outcome = work.stored(problem, cache, settings)
        if outcome is not None:
            found[problem.key] = outcome
            report(outcome)
    missing = sorted((problem for problem in wanted if problem.key not in found), key=_expected_effort, reverse=True)
    tasks = [(problem.key, str(cache.folder), cache.fresh, settings) for problem in missing]
    for outcome in pool.run(work.task, tasks, jobs):
        found[outcome.key] = outcome
        report(outcome)
    outcomes = tuple(found[problem.key] for problem in wanted)
    published, failures = _publishable(wanted, found)
    chapter = _chapter(cache, jobs) if len(wanted) == len(list(problems())) else None
    failures += [Failure("chapter", sentence) for sentence in _wrong_equations(chapter)]
    package = emission.package(published, cache)
    published = _measured(published, package, standing, cache, jobs)
    book = book or Book(tuple(dict.fromkeys(problem.profile_id for problem, _ in published)), chapter)
    files = emission.emitted(published, package, book, cache, settings, jobs)
    return Catalogue(files, outcomes, tuple(failures))


def _chapter(cache: Cache, jobs: int) -> Record:
    """What the equations of chapter 11 come to; their checks compare with entries of the engine too."""
    from .chapter11.record import record
    from .chapter11.runner import run

    sources = source_digest("axiderive.chapter11", "axiderive.profiles", *work.DERIVING)
    key = digest([work.FORMAT, "chapter", work.installed("sympy"), work.installed("mpmath"), sources])
    found = cache.get(key)
    if found is None:
        found = record(run(jobs=jobs))
        cache.put(key, found)
    return dict(found)


def _wrong_equations(chapter: Record | None) -> list[str]:
    from .chapter11.record import failures

    return [] if chapter is None else failures(chapter)


def _expected_effort(problem: Problem) -> tuple[int, int, int]:
    """Longest first, so that no process is left alone with a long task at the end."""
    profile = problem.profile
    graded = problem.system.name.startswith("graded")
    return int(graded), len(profile.pieces) + len(profile.abbreviations), len(profile.parameters)


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
        elif problem.base_keys() & lost:
            failures.append(Failure(problem.key, f"rests on {', '.join(sorted(problem.base_keys() & lost))}"))
            lost.add(problem.key)
        else:
            published.append((problem, outcome))
    return published, failures


def _measured(
    published: Published, package: Mapping[str, str], standing: Mapping[str, Record], cache: Cache, jobs: int
) -> Published:
    """The same with the errors of the emitted functions among the evidence."""
    from .stable.closure import closure
    from .stable.drift import settled
    from .stable.records import SYSTEMS

    tasks = [
        (problem.key, outcome.entries, closure(package, problem.module), str(cache.folder), cache.fresh)
        for problem, outcome in sorted(published, key=lambda pair: _expected_effort(pair[0]), reverse=True)
        if problem.system.name in SYSTEMS
    ]
    found = {key: settled(standing.get(key, {}), errors) for key, errors in pool.run(work.evaluation, tasks, jobs)}
    return [
        (problem, replace(outcome, evidence=outcome.evidence | {"evaluation": found[problem.key]}))
        if problem.key in found
        else (problem, outcome)
        for problem, outcome in published
    ]
