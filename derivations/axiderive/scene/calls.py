"""The arguments of a call by parameter."""

from __future__ import annotations

import ast
from collections.abc import Sequence


def arguments(call: ast.Call, parameters: Sequence[str]) -> dict[str, ast.expr]:
    """The argument expressions of a call by the name of their parameter."""
    given: dict[str, ast.expr] = dict(zip(parameters, call.args, strict=False))
    return given | {keyword.arg: keyword.value for keyword in call.keywords if keyword.arg}
