"""What several files of tests ask for, made once: the emitted plane modules, and pages of the web edition."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Iterator
from importlib import import_module
from pathlib import Path
from types import ModuleType

import pytest
from hypothesis import HealthCheck, settings
from plane_modules import PACKAGE, entries, written
from stored_book import CATALOGUE, KEYS, evidence, kernels, stored

from axiderive.code import python
from axiderive.code.plane import module_sources
from axiderive.profiles import plane
from axiderive.scene.linker import sources
from axiderive.web import html_sources

# a run says the same of the same commit, on a machine that is busy too, which draws slowly;
# --hypothesis-profile=explore draws other numbers every time
PATIENT = settings(deadline=None, suppress_health_check=[HealthCheck.too_slow])
settings.register_profile("repeatable", PATIENT, derandomize=True)
settings.register_profile("explore", PATIENT)
settings.load_profile("repeatable")

WEB = ("cone", "flat_punch", "plane.eccentric_punch", "loads.hertzian", "materials")


@pytest.fixture(scope="session", autouse=True)
def kernels_of_the_catalogue() -> Iterator[None]:
    """To fit them anew takes six seconds; one test compares them, see `test_runtime`."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(python, "kernels_source", kernels)
        patch.setattr(sources, "kernels_source", kernels)
        yield


@pytest.fixture(scope="module")
def plane_folder(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    folder = tmp_path_factory.mktemp("plane")
    written(folder, PACKAGE, module_sources({name: entries(name) for name in plane.NAMES}))
    sys.path.insert(0, str(folder))
    yield folder
    sys.path.remove(str(folder))
    for name in [name for name in sys.modules if name.startswith(PACKAGE)]:
        del sys.modules[name]


@pytest.fixture
def plane_module(plane_folder: Path) -> Callable[[str], ModuleType]:
    return lambda name: import_module(f"{PACKAGE}.plane.{name}")


@pytest.fixture(scope="session")
def site() -> dict[str, str]:
    """The web edition of some profiles of every kind."""
    own = [key for key in KEYS if any(key == name or key.startswith(f"{name}.") for name in WEB)]
    modules = {
        str(path.relative_to(CATALOGUE)): path.read_text(encoding="utf-8")
        for path in (CATALOGUE / "axicontact").rglob("*.py")
    }
    chapter = json.loads((CATALOGUE / "evidence" / "chapter11.json").read_bytes())
    studies = {path.stem: json.loads(path.read_bytes()) for path in (CATALOGUE / "evidence" / "study").glob("*.json")}
    return html_sources(
        {k: stored(k) for k in own}, {k: evidence(k) for k in own}, chapter, modules=modules, studies=studies
    )
