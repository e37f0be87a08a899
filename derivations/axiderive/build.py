"""The catalogue as a pure function: profiles in, `{relative path: bytes}` out."""

from __future__ import annotations

import difflib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from . import pool, work
from .cache import Cache, digest, source_digest
from .work import Outcome, Settings
from .writing import STUDIES

if TYPE_CHECKING:
    from pathlib import Path

    from .contact.systems import Problem

EMITTING = (*work.VERIFYING, "axiderive.emit", "axiderive.build")

Published = list[tuple["Problem", Outcome]]
Record = dict[str, Any]


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
    files = _emitted(published, chapter, cache, settings, jobs)
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


def _emitted(
    published: Published, chapter: Record | None, cache: Cache, settings: Settings, jobs: int
) -> dict[str, bytes]:
    results = [[problem.key, outcome.entries, outcome.evidence] for problem, outcome in published]
    studies = _studies()
    key = digest([work.FORMAT, "emission", source_digest(*EMITTING), settings.record(), results, chapter, studies])
    texts = cache.get(key)
    if texts is None:
        texts = {path: content.decode() for path, content in _emit(published, chapter, studies, jobs).items()}
        cache.put(key, texts)
    return {path: text.encode() for path, text in sorted(texts.items())}


def _studies() -> dict[str, Record]:
    """The records of `axicontact study` beside the evidence, by name; the book draws them."""
    import json

    folder = work.project_root() / "catalogue" / STUDIES
    return {path.stem: json.loads(path.read_bytes()) for path in sorted(folder.glob("*.json"))}


def _emit(published: Published, chapter: Record | None, studies: dict[str, Record], jobs: int) -> dict[str, bytes]:
    from .emit import handbook, html, index, modules

    derived = {problem.key: work.read_entries(problem, outcome.entries) for problem, outcome in published}
    evidence = {problem.key: outcome.evidence for problem, outcome in published}
    texts = modules.package_sources(derived)
    models = _page_models(published, jobs)
    book = handbook.handbook_sources(derived, evidence, chapter, models, studies)
    texts |= {f"handbook/{path}": text for path, text in book.items()}
    site = html.html_sources(derived, evidence, chapter, models, texts)
    texts |= {f"handbook/html/{path}": text for path, text in site.items()}
    files = {path: text.encode() for path, text in texts.items()}
    files["axicontact/index.json"] = index.to_bytes(index.index_record(derived, evidence, texts))
    for problem, outcome in published:
        record = index.evidence_record(problem, outcome.entries, outcome.evidence)
        files[f"evidence/{problem.key}.json"] = index.to_bytes(record)
    if chapter is not None:
        files["evidence/chapter11.json"] = index.to_bytes(chapter)
    return files


def _page_models(published: Published, jobs: int) -> dict[str, Record]:
    """What the page of every profile shows, in the order of the handbook; made side by side."""
    from .emit import handbook, spread

    own: dict[str, dict[str, tuple[Record, Record]]] = {}
    for problem, outcome in published:
        own.setdefault(problem.profile_id, {})[problem.key] = (outcome.entries, outcome.evidence)
    numbers = handbook.numbered(list(own))
    every = {problem.key: (outcome.entries, outcome.evidence) for problem, outcome in published}
    tasks = [
        (name, found | {key: every[key] for key in sorted(spread.needed(name) & set(every))}, numbers[name])
        for name, found in own.items()
    ]
    made = dict(pool.run(_page_model, tasks, jobs))
    return {name: made[name] for name in own}


def _page_model(profile_id: str, found: dict[str, tuple[Record, Record]], number: str) -> tuple[str, Record]:
    """The page of one profile, from what is stored of its problems."""
    from .contact.systems import problem
    from .emit import spread

    derived = {key: work.read_entries(problem(key), entries) for key, (entries, _) in found.items()}
    evidence = {key: record for key, (_, record) in found.items()}
    return profile_id, spread.model(profile_id, derived, evidence, number)


def differences(files: dict[str, bytes], root: Path, stale: Sequence[str] = ()) -> list[str]:
    """Unified diff, line by line, from the catalogue on the disk to the one just built."""
    lines: list[str] = []
    for path, content in sorted(files.items()):
        target = root / path
        old = target.read_bytes() if target.is_file() else None
        if old == content:
            continue
        before = [] if old is None else old.decode(errors="replace").splitlines()
        origin = "/dev/null" if old is None else f"committed/{path}"
        lines += difflib.unified_diff(before, content.decode().splitlines(), origin, f"built/{path}", lineterm="")
    for path in stale:
        lines += [f"--- committed/{path}", "+++ /dev/null", "no longer generated"]
    return lines


def only_profiles(files: dict[str, bytes], ids: Sequence[str], root: Path) -> dict[str, bytes]:
    """The files a partial build may write into a full catalogue.

    Files that belong to one of the profiles are replaced and the index is
    merged; what the profiles share is written only where it does not exist yet.
    """
    import json

    from .contact.systems import profile_ids
    from .emit.index import to_bytes

    order = profile_ids()
    index_path = "axicontact/index.json"
    own = {path: text for path, text in files.items() if _owner(path) in ids}
    shared = {p: t for p, t in files.items() if p not in own and p != index_path and not (root / p).exists()}
    new = json.loads(files[index_path])
    try:
        old = json.loads((root / index_path).read_bytes())
    except (OSError, ValueError):
        old = {"profiles": [], "entries": []}
    for part, name in (("profiles", "name"), ("entries", "profile")):
        rows = [row for row in old[part] if row[name] not in ids and row[name] in order] + new[part]
        new[part] = sorted(rows, key=lambda row: order.index(row[name]))  # noqa: B023
    new["matrix"] = _merged_matrix(old.get("matrix", {}), new["matrix"], order)
    return own | shared | {index_path: to_bytes(new)}


def _merged_matrix(old: Record, new: Record, order: Sequence[str]) -> Record:
    profiles = {**old.get("profiles", {}), **new["profiles"]}
    return {**new, "profiles": {name: profiles[name] for name in order if name in profiles}}


def _owner(path: str) -> str:
    """The profile that a generated file belongs to; empty if it is shared."""
    from .contact.systems import problems

    folder, _, rest = path.partition("/")
    for problem in problems():
        if path in (problem.module, f"evidence/{problem.key}.json"):
            return problem.profile_id
        if folder == "handbook" and rest in (f"profiles/{problem.profile_id}.tex", f"html/{problem.profile_id}.html"):
            return problem.profile_id
    return ""
