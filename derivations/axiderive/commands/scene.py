"""The commands `axicontact derive` and `axicontact emit`.

The first prints f, g, F, p and w with their status, and what was checked.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import os
import re
import sys
import textwrap
import time
from collections.abc import Mapping
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from types import MappingProxyType
from typing import Any

import sympy as sp

from .. import notation as nt
from ..build import pdf
from ..build.pool import engine, limited, run, workers
from ..build.work import project_root
from ..entry import FOUR
from ..exits import ENVIRONMENT, FAILED, USAGE, CommandError
from ..expression.answer import DIGITS, Answer, answered
from ..expression.names import ExpressionError
from ..expression.profile import OwnProfile, own_profile
from ..scene import interface, text
from ..scene.compose import Result, composed, manifest
from ..scene.linker.library import graded_refusal
from ..scene.page import typeset
from ..scene.reading import Scene, read
from ..store.cache import Cache, digest
from ..store.writing import write_atomic


def derive(arguments: argparse.Namespace) -> int:
    """Print the formulas of an expression, or of each in a file; write module and test where a folder is named."""
    if arguments.source is not None:
        return _derive_each(arguments)
    lines, result = limited(shown, arguments.expression, arguments.k, arguments.out is not None)
    print("\n".join(lines))
    if arguments.out is not None and result is not None:
        _write(result, arguments.out)
    return 0


def _derive_each(arguments: argparse.Namespace) -> int:
    """The same of every line of a file; one that cannot be derived is said and takes no other with it."""
    asked = _lines_of(arguments.source)
    cache, write = Cache(project_root() / ".cache"), arguments.out is not None
    keys = [digest(["own profile", engine(), text, arguments.k, write]) for text in asked.values()]
    known = [cache.get(key) for key in keys]
    tasks = [(text, arguments.k, write) for text, own in zip(asked.values(), known, strict=True) if own is None]
    failed = 0
    with workers(arguments.executor, arguments.jobs) as jobs:
        made = run(_own_record, tasks, jobs, ordered=True)
        for (number, text), key, own in zip(asked.items(), keys, known, strict=True):
            found = own or next(made)
            if "error" in found:
                failed += 1
                print(f"axicontact: line {number}: {text}: {found['error']}", file=sys.stderr)
                continue
            if own is None:
                cache.put(key, found)
            print(f"line {number}", *found["lines"], "", sep="\n", flush=True)
            if write and found["files"]:
                files = {name: content.encode() for name, content in found["files"].items()}
                _write(Result(files, ()), arguments.out / f"line-{number}")
    return FAILED if failed else 0


def _lines_of(path: Path) -> dict[int, str]:
    """The expressions of a file by the number of their line."""
    lines = path.read_text(encoding="utf-8", errors="replace").splitlines()
    bare = {number: line.partition("#")[0].strip() for number, line in enumerate(lines, 1)}
    found = {number: text for number, text in bare.items() if text}
    if not found:
        message = f"{path} has no expression; write one on a line, as r**2/(2*R) + c*r**4"
        raise CommandError(message, USAGE)
    return found


def _own_record(text: str, k: str, write: bool) -> dict[str, Any]:
    """What `derive` says and writes of an expression, as plain data."""
    try:
        lines, result = limited(shown, text, k, write)
    except CommandError as error:
        return {"error": str(error)}
    files = result and {name: content.decode() for name, content in result.files.items()}
    return {"lines": lines, "files": files}


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
    made: list[Future[bytes]] = []
    with ThreadPoolExecutor(1) as pool:

        def begin(sources: Mapping[str, bytes]) -> None:
            made.append(pool.submit(pdf.compile_page, sources))

        result = limited(composed, scene, None, hear=begin if "pdf" in scene.formats else None)
        for line in result.lines:
            print(line)
    page = typeset(made[0]) if made else b""
    _write(result, folder, {"page.pdf": page} if page else {})
    print(f"{time.perf_counter() - started:.1f} s in all")
    return 0


def _plan(scene: Scene, folder: Path) -> list[str]:
    """What would be written, with the defaults filled in."""
    frozen = ", ".join(f"{name} = {value!r}" for name, value in scene.frozen.items()) or "none"
    free = ", ".join(scene.free) or "none"
    return [
        f"profile     {scene.subject.name}  {scene.subject.subtitle if scene.own else ''}".rstrip(),
        f"physics     {scene.kind.name}",
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


WIDTH = 110


def shown(text: str, k: str = "0", write: bool = False) -> tuple[list[str], Result | None]:
    """The lines, and the files of a module with all functions if they are wanted."""
    own = own_profile(text)
    exponent = exponent_of(k)
    with nt.extended(own.notation):
        answer = answered(own, k=exponent)
        lines = _head(own) + [line for suffix in FOUR for line in _entry(answer, suffix)] + _tail(answer)
    if not write and all(answer.entries[suffix].status == "closed" for suffix in FOUR):
        return lines, None  # else the rules of the module give the values, and their error is measured
    kind = interface.KINDS["graded" if exponent else "normal"]
    values = {"k": float(exponent)} if exponent else {}
    if exponent != 0 and (reason := graded_refusal(answer.profile)):
        return [*lines, *([f"written   nothing: {reason}"] if write else [])], None
    names = list(interface.functions(kind))
    if answer.bounded:
        names = [name for name in names if name not in interface.INVERSES]
        reason = "how far the contact is compact depends on the values; freeze them in a scene"
        lines += [f"left out  {', '.join(sorted(interface.INVERSES))}: {reason}"] if write else []
    scene = Scene(
        own.profile.name, "Contact of a profile of one's own", own=own, kind=kind, quantities=names, values=values,
        module=f"{own.profile.name}.py",
    )  # fmt: skip
    result = composed(scene, answer)
    return [*lines, *(line for line in result.lines if line not in lines)], result if write else None


def exponent_of(text: str) -> sp.Rational:
    """The exponent of grading, a fraction between -1 and 1."""
    match = re.fullmatch(r"\s*([-+]?(?:\d{1,6}\.?\d{0,6}|\.\d{1,6}))\s*(?:/\s*(\d{1,6}))?\s*", text)
    below = int(match[2] or 1) if match else 0
    value = Fraction(match[1]) / below if match and below else Fraction(1)
    if not -1 < value < 1:
        message = f"k = {text[:40]!r} is outside -1 < k < 1; give the exponent of grading as a fraction, as 1/3"
        raise ExpressionError(message)
    return sp.Rational(value.numerator, value.denominator)


def _head(own: OwnProfile) -> list[str]:
    lines = [f"f(r) = {own.expression.text}"]
    lines += [f"          {record.name} [{record.unit}], {record.domain}" for record in own.notation]
    if not own.homogeneous:
        lines.append("          numbers in f carry units: all lengths in the same unit")
    return lines


def _entry(answer: Answer, suffix: str) -> list[str]:
    entry = answer.entries[suffix]
    if answer.k != 0:
        entry = replace(entry, cases=tuple(replace(c, expr=c.expr.subs(nt.k, answer.k)) for c in entry.cases))
    lines = ["", f"{entry.quantity.label}: {answer.status(suffix)}"]
    for pairs, expr in entry.regions():
        where = " and ".join(f"{sp.sstr(low)} < {sp.sstr(high)}" for low, high in pairs)
        text = f"{entry.quantity.symbol} = {sp.sstr(expr)}" + (f"   for {where}" if where else "")
        lines += textwrap.wrap(
            text, WIDTH, initial_indent="  ", subsequent_indent="    ", break_long_words=False, break_on_hyphens=False
        )
    return lines


def _tail(answer: Answer) -> list[str]:
    examined = "" if answer.k == 0 or answer.validity.exact else " (on the homogeneous half-space, k = 0)"
    lines = ["", f"contact   {answer.validity.sentence}{examined}"]
    if answer.comparisons:
        count = len(answer.comparisons)
        lines.append(
            f"checked   {count} values against the defining integrals, {DIGITS} digits, worst {answer.worst:.1e}"
        )
    if answer.told:
        lines.append(f"form      {answer.told}")
    return lines
