"""The emitted plane modules, written once for every file of tests that asks for them."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from importlib import import_module
from pathlib import Path
from types import ModuleType

import pytest
from plane_modules import PACKAGE, entries, written

from axiderive.emit.plane import module_sources
from axiderive.profiles import plane


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
