"""One problem, derived and verified: the unit of work that is cached and handed to a process."""

from __future__ import annotations

import time
import traceback
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cache as remember
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..store.cache import Cache, Lent, digest
from ..store.sources import import_digest, kept, modules_of, source_digest

if TYPE_CHECKING:
    from ..entry import Entry
    from ..physics.systems import Problem
    from ..profiles.profile import Profile

FORMAT = 2
DERIVING = (
    *("axiderive.physics.systems.problem", "axiderive.physics.systems.Problem"),
    *("axiderive.store.records.entry_record", "axiderive.store.records.read_entry"),
)
PROVING = ("axiderive.build.verification.verify",)
CHECKING = ("axiderive.checks.checks.check_problem",)
MEASURING = ("axiderive.stable.records.record",)
"""What derives, proves, checks and measures, with all that it uses of the engine; see `_reached`."""
WRITING = (
    *("axiderive.notation", "axiderive.entry", "axiderive.abel", "axiderive.physics", "axiderive.store.records"),
    *("axiderive.profiles", "axiderive.stable", "axiderive.code", "axiderive.runtime", "axiderive.print"),
    *("axiderive.rows", "axiderive.figures", "axiderive.worked", "axiderive.book", "axiderive.web"),
    *("axiderive.readback", "axiderive.oracle.evaluate"),
)
"""Modules and packages, with every file in them, that write modules and pages."""
TEXTS = ("title", "subtitle", "validity", "sources", "sketch", "synonyms", "note", "meanings", "reason")
"""Fields of a profile and its rules that are printed and drawn: no formula and no proof depends on them."""


@dataclass(frozen=True)
class Settings:
    """How hard the definitions are integrated, and where."""

    digits: int = 50
    points: int = 8
    seed: int = 17

    def record(self) -> dict[str, int]:
        """The settings as plain data, as they go into keys and evidence."""
        return {"digits": self.digits, "points": self.points, "seed": self.seed}


@dataclass(frozen=True)
class Outcome:
    """What a task brings back, in plain data so that it crosses processes as it is stored."""

    key: str
    """Key of the problem."""
    entries: dict[str, Any]
    evidence: dict[str, Any]
    seconds: float
    cached: bool = False
    kept: bool = False
    """Whether its checks were taken from the catalogue."""
    error: str = ""
    trace: str = ""
    made: dict[str, Any] = field(default_factory=dict)
    """What was made, by the keys of the cache."""

    @property
    def failures(self) -> list[dict[str, str]]:
        """Key and message of every check that failed; empty where none did or none was made."""
        found: list[dict[str, str]] = self.evidence.get("failures", [])
        return found


def project_root() -> Path:
    """The checkout this engine lives in, or the current folder if it is installed elsewhere."""
    checkout = Path(__file__).resolve().parents[3]
    return checkout if (checkout / "pyproject.toml").is_file() else Path.cwd()


def _reached(problem: Problem, names: tuple[str, ...] = ()) -> str:
    """Digest of the code that derives a problem and does more with it: of its physics, and of normal contact.

    What is named after another physics, in whatever room, is left out: a new physics repeats no check of an old one.
    """
    from ..physics import normal
    from ..physics.systems import SYSTEMS

    own = sorted({physics.derive.__module__ for physics in (problem.system.physics, normal.PHYSICS)})
    names = (*names, *DERIVING, *(f"{module}.PHYSICS" for module in own))
    return import_digest(*names, apart=frozenset(found.physics.derive.__module__ for found in SYSTEMS) - {*own})


def derivation_key(problem: Problem) -> str:
    """SHA-256 of all a derivation depends on: its code, the version of SymPy, the problem and its profile."""
    shape = _shape(problem.profile)
    return digest([FORMAT, "derivation", installed("sympy"), _reached(problem), problem.key, shape])


def _shape(profile: Profile) -> Any:
    """The record of a profile without its texts."""
    from ..store.records import profile_record

    def bare(value: Any) -> Any:
        if isinstance(value, list):
            return [bare(item) for item in value]
        if isinstance(value, dict):
            return {name: bare(item) for name, item in value.items() if name not in TEXTS}
        return value

    return bare(profile_record(profile))


@remember
def _shapes() -> str:
    """Digest of all profiles: a limit is verified with the profile that it leads to."""
    from ..profiles.pools import POOLS

    return digest([[pool.prefix, name, _shape(pool.load(name))] for pool in POOLS for name in pool.names])


def verification_key(problem: Problem, entries: dict[str, Any], settings: Settings) -> str:
    """Of the whole verification: proofs, the second proofs, and the checks."""
    proving = [_reached(problem, PROVING), source_digest("axiderive.verifier")]
    return digest([FORMAT, "verification", proving, checking_key(problem, entries, settings)])


def checking_key(problem: Problem, entries: dict[str, Any], settings: Settings) -> str:
    """Of the numerical comparisons: the code that makes them, the settings, the profiles and the entries."""
    versions = [installed(name) for name in ("sympy", "mpmath", "python-flint")]
    inputs = [versions, _reached(problem, CHECKING), _shapes(), settings.record(), problem.key, entries]
    return digest([FORMAT, "checks", inputs])


def evaluation_key(problem: Problem, entries: dict[str, Any], sources: Mapping[str, str]) -> str:
    """Of the measured errors: the code that measures, the profile, the entries and the texts of the modules."""
    versions = [installed(name) for name in ("numpy", "sympy", "python-flint")]
    inputs = [versions, _reached(problem, MEASURING), _shape(problem.profile), problem.key, entries, dict(sources)]
    return digest([FORMAT, "evaluation", inputs])


def chapter_key() -> str:
    """Of the checks of chapter 11, which compare with entries of the engine too."""
    physics = (f"{module}.PHYSICS" for module in modules_of("axiderive.physics"))
    sources = [import_digest(*DERIVING, *physics, *modules_of("axiderive.chapter11")), _shapes()]
    return digest([FORMAT, "chapter", installed("sympy"), installed("mpmath"), sources])


def receipt(key: str, found: object) -> str:
    """What stands in the catalogue for the inputs of a result: another input or another result has another one."""
    return digest([key, found])[:32]


def taken_over(standing: Mapping[str, Any], name: str, made_of: str) -> Any | None:
    """What the catalogue holds under a name, if it was made of these inputs; None otherwise."""
    found, known = standing.get(name), standing.get("receipts", {}).get(name)
    return found if found is not None and known == receipt(made_of, found) else None


def stored(problem: Problem, cache: Cache, settings: Settings) -> Outcome | None:
    """The outcome if both its halves are in the cache."""
    derivation = cache.get(derivation_key(problem))
    if derivation is None:
        return None
    verification = cache.get(verification_key(problem, derivation["entries"], settings))
    if verification is None:
        return None
    seconds = derivation["seconds"] + verification["seconds"]
    return Outcome(problem.key, derivation["entries"], verification["evidence"], seconds, cached=True)


def task(key: str, folder: str, fresh: bool, settings: Settings, standing: Mapping[str, Any]) -> Outcome:
    """Derive and verify one problem; what is made goes back to the process that keeps the cache in the folder.

    `standing` is what the catalogue holds of it: checks made from the same inputs are not made again.
    """
    from ..physics import systems

    start = time.perf_counter()
    entries: dict[str, Any] = {}
    evidence: dict[str, Any] = {}
    checks, cache = None, Lent(Path(folder), fresh)
    said = trace = ""
    try:
        problem = systems.problem(key)
        with kept(Lent(Path(folder))):
            entries = _derived(problem, cache)
            checks = None if fresh else kept_checks(problem, entries, settings, standing)
            evidence = _verified(problem, entries, cache, settings, checks)
    except OSError:
        raise
    except Exception as error:  # a defect in one problem must not take the others with it
        said, trace = f"{type(error).__name__}: {error}", traceback.format_exc()
    seconds = time.perf_counter() - start
    return Outcome(key, entries, evidence, seconds, False, checks is not None, said, trace, cache.made_here)


def kept_checks(
    problem: Problem, entries: dict[str, Any], settings: Settings, standing: Mapping[str, Any]
) -> list[dict[str, Any]] | None:
    """The checks of the catalogue if they were made from these inputs; None otherwise."""
    checks = taken_over(standing, "checks", checking_key(problem, entries, settings))
    return None if checks is None else list(checks)


def measured(made_of: str, cache: Cache, standing: Mapping[str, Any]) -> tuple[dict[str, Any] | None, bool]:
    """The errors that were measured of the same inputs, or None, and whether the catalogue holds them.

    `made_of` is their `evaluation_key`, `standing` what the catalogue holds of the problem.
    """
    errors = None if cache.fresh else taken_over(standing, "evaluation", made_of)
    return (cache.get(made_of), False) if errors is None else (dict(errors), True)


def evaluation(key: str, entries: dict[str, Any], sources: dict[str, str]) -> tuple[str, dict[str, Any]]:
    """The key of a problem and the measured errors of its emitted functions.

    `sources` are those of the package that the module of the problem rests on.
    """
    from ..physics import systems
    from ..stable.records import record

    return key, record(key, sources, read_entries(systems.problem(key), entries))


def read_entries(problem: Problem, records: dict[str, Any]) -> dict[str, Entry]:
    """The entries of a problem by suffix, from their stored records."""
    from ..store.records import read_entry

    profile = problem.profile
    return {suffix: read_entry(record, profile) for suffix, record in records.items()}


def _derived(problem: Problem, cache: Cache) -> dict[str, Any]:
    from ..store.records import entry_record

    def derive() -> Any:
        return {suffix: entry_record(entry) for suffix, entry in problem.derive().items()}

    return dict(cache.made(derivation_key(problem), lambda: _timed("entries", derive))["entries"])


def _timed(name: str, make: Callable[[], Any]) -> dict[str, Any]:
    """What is made, under a name, and the seconds that took."""
    start = time.perf_counter()
    return {name: make(), "seconds": round(time.perf_counter() - start, 3)}


def _verified(
    problem: Problem,
    entries: dict[str, Any],
    cache: Cache,
    settings: Settings,
    checks: list[dict[str, Any]] | None,
) -> dict[str, Any]:
    from .verification import verify

    def prove() -> Any:
        # what is verified is what was stored, not what was in memory
        return verify(problem, read_entries(problem, entries), settings, checks)

    key = verification_key(problem, entries, settings)
    return dict(cache.made(key, lambda: _timed("evidence", prove))["evidence"])


@remember
def installed(package: str) -> str:
    """The version of a package but for its last number, for the keys of the cache: a mended one gives the same."""
    try:
        return ".".join(version(package).split(".")[:2])
    except PackageNotFoundError:
        return "missing"
