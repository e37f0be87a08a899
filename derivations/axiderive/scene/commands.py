"""The commands `axicontact derive` and `axicontact emit`."""

from __future__ import annotations

import argparse
import hashlib
import json
import os
import time
from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType

from ..exits import ENVIRONMENT, USAGE, CommandError
from ..writing import write_atomic
from . import interface, text
from .compose import Result, Typesetter, composed, manifest
from .reading import Scene, read
from .request import Request
from .typesetting import Typesetting
from .worker import limited


def derive(arguments: argparse.Namespace) -> int:
    """Print the formulas of an expression; write its module and test where a folder is named."""
    lines, result = limited(_derived, arguments.expression, arguments.k, arguments.out is not None)
    print("\n".join(lines))
    if arguments.out is not None and result is not None:
        _write(result, arguments.out)
    return 0


def _derived(expression: str, k: str, write: bool) -> tuple[list[str], Result | None]:
    """In the worker: the printed lines and the files."""
    from ..expression.show import shown

    return shown(expression, k, write=write)


def emit(arguments: argparse.Namespace) -> int:
    """Write what a scene asks for."""
    started = time.perf_counter()
    path: Path = arguments.scene
    source = text.load(path)
    scene = read(source)
    folder = arguments.out or path.parent / scene.folder
    if arguments.out is None:
        _inside(folder, path.parent)
    if arguments.dry_run:
        print("\n".join(_plan(scene, folder)))
        return 0
    with Typesetting() as typesetting:
        request = _request(scene, source.text)
        if "pdf" in scene.formats:
            result = limited(_composed, request, hear=typesetting.start)
        else:
            result = limited(composed, request)
        for line in result.lines:
            print(line)
        page = typesetting.page()
    _write(result, folder, {"page.pdf": page} if page else {})
    print(f"{time.perf_counter() - started:.1f} s in all")
    return 0


def _composed(request: Request, typeset: Typesetter) -> Result:
    """In the worker: the files, the page of which is handed out before the rest is written."""
    return composed(request, typeset=typeset)


def _request(scene: Scene, source: str) -> Request:
    return Request(
        scene.title, scene.module, scene.profile, scene.own, scene.physics, scene.quantities, scene.values,
        scene.formats, scene.at, source,
    )  # fmt: skip


def _plan(scene: Scene, folder: Path) -> list[str]:
    """What would be written, with the defaults filled in."""
    assert scene.profile is not None
    names = [*interface.parameters(scene.profile), *interface.MATERIAL[scene.physics]]
    frozen = ", ".join(f"{n} = {scene.values[n]!r}" for n in names if n in scene.values) or "none"
    free = ", ".join(n for n in names if n not in scene.values) or "none"
    return [
        f"profile     {scene.profile.name}  {scene.profile.subtitle if scene.own else ''}".rstrip(),
        f"physics     {scene.physics}",
        f"functions   {', '.join(scene.quantities)}",
        f"frozen      {frozen}",
        f"free        {free}",
        *([f"example at  {scene.at[0]} = {scene.at[1]!r}"] if scene.at else []),
        f"formats     {', '.join(scene.formats)}",
        f"would write {folder}/{scene.module}",
    ]


def _inside(folder: Path, root: Path) -> None:
    """A scene writes below its own place only, also through links."""
    if not folder.resolve().is_relative_to(root.resolve()):
        message = f"{folder} leads out of {root}; choose another folder with --out"
        raise CommandError(message, USAGE)


def _spare(folder: Path, files: Mapping[str, bytes]) -> None:
    """What is in the folder already stays, unless it is as the manifest of an earlier run says.

    Raises
    ------
    CommandError
        If a file of another origin, or one that was changed since, would be overwritten.
    """
    above = next((path for path in (folder, *folder.parents) if path.exists()), folder)
    if not above.is_dir():
        message = f"{above} is a file and no folder; choose another folder with --out"
        raise CommandError(message, USAGE)
    written = _written(folder / "MANIFEST.json")
    foreign = []
    for name, content in files.items():
        path = folder / name
        if not path.exists() or (name == "MANIFEST.json" and written):
            continue
        old = path.read_bytes() if path.is_file() else b""
        if not path.is_file() or (old != content and written.get(name) != hashlib.sha256(old).hexdigest()):
            foreign.append(name)
    if foreign:
        message = (
            f"{', '.join(foreign)} in {folder} would be overwritten, and is not as an earlier run left it; "
            "move it away, or choose another folder with --out"
        )
        raise CommandError(message, USAGE)


def _written(path: Path) -> Mapping[str, str]:
    """Hashes by name of an earlier run, none if there was none."""
    try:
        found = json.loads(path.read_bytes())
    except (OSError, ValueError):
        return {}
    return found if isinstance(found, dict) else {}


def _write(result: Result, folder: Path, further: Mapping[str, bytes] = MappingProxyType({})) -> None:
    files = {**result.files, **further}
    files["MANIFEST.json"] = manifest(files)
    _spare(folder, files)
    try:
        for name, content in files.items():
            write_atomic(folder / name, content)
    except OSError as error:
        message = f"cannot write to {folder}: {error.strerror or error}; choose another folder with --out"
        raise CommandError(message, ENVIRONMENT) from error
    print(f"wrote     {os.path.relpath(folder)}: {', '.join(sorted(n for n in files if '/' not in n))}")
