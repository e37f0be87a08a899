"""The catalogue as a pure function: names of profiles in, `{relative path: bytes}` out."""

from __future__ import annotations

import difflib
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from . import pool, work
from .cache import Cache, digest, source_digest
from .work import Outcome, Settings

if TYPE_CHECKING:
    from pathlib import Path

    from .entry import Entry
    from .profiles.profile import Profile

EMITTING = (*work.VERIFYING, "axiderive.emit", "axiderive.build")
SHARED = "shared"

Pairs = list[tuple["Profile", dict[str, "Entry"]]]


@dataclass(frozen=True)
class Failure:
    """Something that keeps a profile out of the catalogue: a formula that failed a check, or a defect."""

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
    names: Sequence[str],
    *,
    cache: Cache,
    settings: Settings | None = None,
    jobs: int = 1,
    report: Callable[[Outcome], None] = lambda outcome: None,
) -> Catalogue:
    """Derive, verify and emit the named profiles.

    Parameters
    ----------
    names : sequence of str
        Names of profiles, see `profiles.NAMES`; the catalogue keeps that order.
    cache : Cache
        Where finished profiles are kept and looked for; it does not change the result.
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
    from . import profiles

    settings = settings or Settings()
    wanted = [name for name in profiles.NAMES if name in set(names)]
    found: dict[str, Outcome] = {}
    for name in wanted:
        outcome = work.stored(profiles.load(name), cache, settings)
        if outcome is not None:
            found[name] = outcome
            report(outcome)
    open_names = sorted((name for name in wanted if name not in found), key=_expected_effort, reverse=True)
    for outcome in pool.run(work.task, [(name, str(cache.folder), cache.fresh, settings) for name in open_names], jobs):
        found[outcome.name] = outcome
        report(outcome)
    outcomes = tuple(found[name] for name in wanted)
    published, failures = _publishable(outcomes)
    files = _emitted(published, cache, settings)
    return Catalogue(files, outcomes, tuple(failures))


def _expected_effort(name: str) -> tuple[int, int]:
    """Longest first, so that no process is left alone with a long task at the end."""
    from . import profiles

    profile = profiles.load(name)
    return len(profile.pieces) + len(profile.abbreviations), len(profile.parameters)


def _publishable(outcomes: Sequence[Outcome]) -> tuple[list[Outcome], list[Failure]]:
    """What may be published: a profile with a failed check is left out: its formulas rest on each other."""
    published, failures = [], []
    for outcome in outcomes:
        if outcome.error:
            failures.append(Failure(outcome.name, outcome.error, outcome.trace))
        elif outcome.failures:
            failures += [Failure(failure["key"], failure["message"]) for failure in outcome.failures]
        else:
            published.append(outcome)
    return published, failures


def _emitted(outcomes: Sequence[Outcome], cache: Cache, settings: Settings) -> dict[str, bytes]:
    results = [[outcome.name, outcome.entries, outcome.evidence] for outcome in outcomes]
    key = digest([work.FORMAT, "emission", source_digest(*EMITTING), settings.record(), results])
    texts = cache.get(key)
    if texts is None:
        texts = {path: content.decode() for path, content in _emit(outcomes).items()}
        cache.put(key, texts)
    return {path: text.encode() for path, text in sorted(texts.items())}


def _emit(outcomes: Sequence[Outcome]) -> dict[str, bytes]:
    from . import profiles
    from .emit import handbook, index, python

    pairs: Pairs = []
    for outcome in outcomes:
        profile = profiles.load(outcome.name)
        pairs.append((profile, work.read_entries(profile, outcome.entries)))
    derived = {profile.name: entries for profile, entries in pairs}
    evidence = {outcome.name: outcome.evidence for outcome in outcomes}
    files = {path: text.encode() for path, text in python.module_sources(derived).items()}
    files |= {f"handbook/{path}": text.encode() for path, text in handbook.handbook_sources(pairs, evidence).items()}
    files["axicontact/index.json"] = index.to_bytes(index.index_record(pairs, evidence))
    for outcome, (profile, _) in zip(outcomes, pairs, strict=True):
        record = index.evidence_record(profile, outcome.entries, outcome.evidence)
        files[f"evidence/{outcome.name}.json"] = index.to_bytes(record)
    return files


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


def only_profiles(files: dict[str, bytes], names: Sequence[str], root: Path) -> dict[str, bytes]:
    """The files a partial build may write into a full catalogue.

    Files that belong to one of the profiles are replaced and the index is
    merged; what the profiles share is written only where it does not exist yet.
    """
    import json
    from pathlib import PurePosixPath

    from .emit.index import to_bytes
    from .profiles import NAMES

    index_path = "axicontact/index.json"
    own = {path: text for path, text in files.items() if PurePosixPath(path).stem in names}
    shared = {p: t for p, t in files.items() if p not in own and p != index_path and not (root / p).exists()}
    new = json.loads(files[index_path])
    try:
        old = json.loads((root / index_path).read_bytes())
    except (OSError, ValueError):
        old = {"profiles": [], "entries": []}
    for part, name in (("profiles", "name"), ("entries", "profile")):
        rows = [row for row in old[part] if row[name] not in names and row[name] in NAMES] + new[part]
        new[part] = sorted(rows, key=lambda row: NAMES.index(row[name]))  # noqa: B023
    return own | shared | {index_path: to_bytes(new)}
