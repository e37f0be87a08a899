"""What several files of tests ask for, made once: the emitted plane modules, and pages of the web edition."""

from __future__ import annotations

import gc
import json
import os
from collections.abc import Callable, Iterator
from contextlib import nullcontext
from importlib import import_module
from pathlib import Path
from types import ModuleType

import pytest
from chromium import Chromium
from hypothesis import HealthCheck, settings
from hypothesis.internal.conjecture import providers

# SymPy keeps all its results, as in a build; it asks for this when it is imported
os.environ.setdefault("SYMPY_CACHE_SIZE", "None")
# the workers share the cores: with threads of its own a rule of 240 points took twenty times as long
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

from stored_book import CATALOGUE, KEYS, evidence, kernels, receipts, record, stored

from axiderive.build.verification import checks_of
from axiderive.build.work import Settings, kept_checks
from axiderive.code import python, tables
from axiderive.commands import build
from axiderive.entry import Entry
from axiderive.physics import complete, normal, plane
from axiderive.physics.medium import GRADED, HOMOGENEOUS, Medium
from axiderive.physics.systems import Problem, problem
from axiderive.profiles.pools import POOLS
from axiderive.profiles.profile import Profile
from axiderive.scene.linker import library
from axiderive.store import sources
from axiderive.store.cache import Cache
from axiderive.web import html_sources

# a run says the same of the same commit, on a machine that is busy too, which draws slowly;
# --hypothesis-profile=explore draws other numbers every time
PATIENT = settings(deadline=None, suppress_health_check=[HealthCheck.too_slow])
settings.register_profile("repeatable", PATIENT, derandomize=True)
settings.register_profile("explore", PATIENT)
settings.load_profile("repeatable")

# it draws from the numbers in all sources that are imported: to read them took 16 s, and what was drawn depended
# on the tests that a worker had run before
providers._get_local_constants = lambda: providers._local_constants

# what lies in circles is a tenth of all objects: to look for it more often took 4 % of a run, in the end a second each
# time; never, and a long run of slow tests would keep it all
gc.set_threshold(1_000_000, 50, 50)


SLOW = (Path(__file__).parent / "slow.txt").read_text(encoding="utf-8").splitlines()
"""What moves behind `-m slow`; its head says by which rule."""
OF_THE_BOOK = (
    "browser", "build_command", "calculator", "front", "handbook", "html", "html_text", "html_use", "readback",
    "readback_words", "robustness",
)  # fmt: skip
"""Files that come first, and so to one worker: the front of the book and one edition of the web serve them all."""


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Marks what `slow.txt` names; a line that names no test of a file that is collected whole is an error."""
    profiles = set(next(line for line in SLOW if line.startswith("spread: ")).split())
    listed = dict.fromkeys(SLOW, False)
    for item in items:
        case = f"{item.path.name}::{item.name}"
        function, _, parameters = case.partition("[")
        rest = f"{function} but for the spread"
        if own := [line for line in (function, case, rest) if line in listed]:
            listed |= dict.fromkeys(own, True)
            if own != [rest] or profiles.isdisjoint(parameters.rstrip("]").split("-")):
                item.add_marker(pytest.mark.slow)
    whole = {item.path.name for item in items} if not any("::" in one for one in config.args) else set()
    if stale := [line for line, found in listed.items() if not found and line.partition("::")[0] in whole]:
        message = f"slow.txt: no test is {stale[0]!r}; leave out the line or give it the new name"
        raise pytest.UsageError(message)
    items.sort(key=lambda item: item.path.stem.removeprefix("test_") not in OF_THE_BOOK)


def pytest_unconfigure() -> None:
    """It is looked for once, and not six times while the interpreter ends: 6 s of a worker."""
    gc.collect()
    gc.freeze()


WEB = ("cone", "flat_punch", "plane.eccentric_punch", "loads.hertzian", "materials")
UNCHECKED = "loads.hertzian"
"""A profile whose checks are not on record in the composed edition."""


@pytest.fixture(scope="session", autouse=True)
def kernels_of_the_catalogue() -> Iterator[None]:
    """To fit them anew takes six seconds; one test compares them, see `test_runtime`."""
    with pytest.MonkeyPatch.context() as patch:
        for module in (tables, python, library):
            patch.setattr(module, "kernels_source", kernels)
        yield


def as_built(problem: Problem) -> dict[str, Entry] | None:
    """The entries of the catalogue if its receipt says that a build derived and checked them by these very sources."""
    evidence = record(problem.key)["evidence"]
    standing = {"checks": checks_of(evidence), "receipts": receipts()[problem.key]}
    known = kept_checks(problem, record(problem.key)["entries"], Settings(), standing)
    return None if known is None else stored(problem.key)


@pytest.fixture(scope="session", autouse=True)
def profiles_of_the_catalogue_are_derived_once() -> Iterator[None]:
    """A problem or a profile of the catalogue as it stands: fifty tests ask for those of the cone.

    What a build has derived by the same sources is read; a profile that a test has changed is another object, and is
    derived anew, as all are where the engine has changed since.
    """
    found: dict[tuple[int, Medium | None], dict[str, Entry]] = {}

    def once(profile: Profile, medium: Medium | None, genuine: Callable[[], dict[str, Entry]]) -> dict[str, Entry]:
        own = [pool for pool in POOLS if profile.name in pool.names and profile is pool.load(profile.name)]
        if not own:
            return genuine()
        key = id(profile), medium  # which is loaded once, and stays
        if key not in found:
            group = {None: "", HOMOGENEOUS: "", GRADED: ".fgm"}.get(medium)
            name = f"{own[0].id(profile.name)}{group}"
            found[key] = (as_built(problem(name)) if group is not None and name in KEYS else None) or genuine()
        return dict(found[key])

    def of_problem(own: Problem) -> dict[str, Entry]:
        if own.key not in problems:
            problems[own.key] = as_built(own) or own.system.derive(own.profile)
        return dict(problems[own.key])

    problems: dict[str, dict[str, Entry]] = {}
    compact, face, strip, plane_face = (
        normal._Compact.entries, complete.derive, plane._Compact.entries, plane._Complete.entries
    )  # fmt: skip
    # what each file of the engine says is kept by its contents: every worker took two seconds to read them all
    with sources.kept(Cache(CATALOGUE.parent / ".cache")), pytest.MonkeyPatch.context() as patch:
        patch.setattr(build, "kept", nullcontext)  # so that builds elsewhere read none of them again
        patch.setattr(Problem, "derive", of_problem)
        patch.setattr(normal._Compact, "entries", lambda own: once(own.profile, own.medium, lambda: compact(own)))
        patch.setattr(
            complete, "derive",
            lambda profile, medium=HOMOGENEOUS: once(profile, medium, lambda: face(profile, medium)),
        )  # fmt: skip
        patch.setattr(plane._Compact, "entries", lambda own: once(own.profile, None, lambda: strip(own)))
        patch.setattr(plane._Complete, "entries", lambda own: once(own.profile, None, lambda: plane_face(own)))
        yield


@pytest.fixture
def plane_module() -> Callable[[str], ModuleType]:
    return lambda name: import_module(f"axicontact.plane.{name}")


@pytest.fixture(scope="session")
def site() -> dict[str, str]:
    """The web edition of some profiles of every kind, one of them without evidence."""
    own = [key for key in KEYS if any(key == name or key.startswith(f"{name}.") for name in WEB)]
    modules = {
        str(path.relative_to(CATALOGUE)): path.read_text(encoding="utf-8")
        for path in (CATALOGUE / "axicontact").rglob("*.py")
    }
    chapter = json.loads((CATALOGUE / "evidence" / "chapter11.json").read_bytes())
    studies = {path.stem: json.loads(path.read_bytes()) for path in (CATALOGUE / "evidence" / "study").glob("*.json")}
    return html_sources(
        {k: stored(k) for k in own},
        {k: evidence(k) for k in own if k != UNCHECKED},
        chapter,
        modules=modules,
        studies=studies,
    )


@pytest.fixture(scope="module")
def opened(site: dict[str, str], tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[Chromium, str]]:
    """A browser, and the address of the folder with that edition."""
    folder = tmp_path_factory.mktemp("site")
    for path, text in site.items():
        (folder / path).parent.mkdir(exist_ok=True)
        (folder / path).write_text(text, encoding="utf-8")
    with Chromium(folder) as browser:
        yield browser, folder.as_uri()
