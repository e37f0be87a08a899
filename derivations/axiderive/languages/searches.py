"""What goes over arrays in the run time and has a form of its own in other languages: searches, and springs.

The radii on which a search for branches reads the sign are numbers times a length, so they are a table; what has been
sampled on them for all calls of a geometry is asked for radius by radius.
"""

from __future__ import annotations
import __future__

import ast
from functools import cache
from typing import Any

import numpy as np

Name = tuple[str, str]
"""A module below the package, and what it calls the thing."""
BRANCHES, SINGLE, RELAXATION = (f"_runtime.physics.{name}" for name in ("branches", "single", "relaxation"))
RADII = ("decades", "radii_below", "radii_to", "radii_beyond", "radii_around")
"""Those of a length, and of none."""
OWN: dict[Name, str] = {
    **{(BRANCHES, name): name for name in (*RADII, "radii_of_waves", "halfway")},
    **{(SINGLE, name): name for name in ("branches", "lowest", "springs")},
}
"""What these functions are called there."""
SAMPLES = "Samples"
"""The class of what was sampled, of which the radii and their end are kept."""


@cache
def _bound(text: str) -> dict[str, Any]:
    """What a module of arrays binds by numbers alone, and its functions."""
    space: dict[str, Any] = {"np": np, "float": float}
    for node in ast.parse(text).body:
        read = {one.id for one in ast.walk(node) if isinstance(one, ast.Name) and isinstance(one.ctx, ast.Load)}
        if isinstance(node, ast.FunctionDef) or (isinstance(node, ast.Assign | ast.AugAssign) and read <= space.keys()):
            flag = __future__.annotations.compiler_flag
            exec(compile(ast.Module([node], []), "<run time>", "exec", flag, dont_inherit=True), space)
    return space


def radii(text: str, name: str) -> list[float]:
    """The radii of a form of the module of that text, in units of its length."""
    form = _bound(text)[name]
    found: list[float] = np.ravel(form() if name == RADII[0] else form(1.0)).tolist()
    return found


def springs(text: str) -> tuple[list[tuple[float, float]], float]:
    """Nodes and weights of the rule over springs from the text of RELAXATION, and the weight below the first."""
    space = _bound(text)
    return list(zip(space["SHARES"].tolist(), space["WEIGHTS"].tolist(), strict=True)), space["UNDER"]
