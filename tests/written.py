"""Programs of single functions, as the build writes them, ready to be called."""

from __future__ import annotations

import inspect
import math
from collections.abc import Callable, Sequence
from functools import cache
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np

import axicontact
from axicontact._runtime.arrays.blocks import Program
from axicontact._runtime.interface import largest, ordinary
from axicontact._runtime.plain import rule
from axiderive.code.programs.blocks import Blocks
from axiderive.code.programs.bodies import Twins
from axiderive.code.programs.graph import Lengths, needed, trace
from axiderive.code.programs.plain import LARGE, SMALL, Lines, function, is_sum

NAMES = {name: value for name, value in vars(math).items() if not name.startswith("_")}


def arguments(formula: Callable[..., Any]) -> tuple[str, ...]:
    return formula.__code__.co_varnames[: formula.__code__.co_argcount]


def plain(formula: Callable[..., Any]) -> Callable[..., float | None] | None:
    """The flat function of `math`, or None if the formula has no graph."""
    names = arguments(formula)
    result = trace(formula, names, ())
    if result is None:
        return None
    rules: dict[Lengths, str] = {}
    ranges = dict.fromkeys(names, (SMALL, LARGE))
    text = function("written", ranges, [], Lines(result, ranges, rules).text())
    space = NAMES | {"ordinary": ordinary} | {name: rule(lengths) for lengths, name in rules.items()}
    exec(text, space)
    return space["written"]


def program(formula: Callable[..., Any], count: int, arrays: Sequence[bool]) -> Program | None:
    """The program for `count` fields, by which of all arguments are arrays; None if the formula has none."""
    names = arguments(formula)
    result = trace(formula, names, ())
    if result is None or any(map(is_sum, needed(result))):
        return None
    constants: dict[str, str] = {}
    given = [name for name, more in zip(names, arrays, strict=True) if more]
    writer = Blocks(result, names, given, names[:count], constants)
    space: dict[str, Any] = {"np": np, "largest": largest}
    exec(writer.written("one"), space)
    space |= {name: np.array(eval(value, {"np": np})) for value, name in constants.items()}
    return Program(*eval(writer.record("one"), space))


def needs_arrays(formula: Callable[..., Any]) -> bool:
    """Whether its body cannot run over plain numbers."""
    own = inspect.getsource(import_module(formula.__module__))
    return Twins("axicontact", package_texts() | {formula.__module__: own}).needs_arrays(formula)


@cache
def package_texts() -> dict[str, str]:
    """The modules of the package by dotted name."""
    root = Path(axicontact.__file__).parent
    return {".".join(path.relative_to(root).with_suffix("").parts): path.read_text() for path in root.rglob("*.py")}
