"""Answers to expressions and their modules, for the tests."""

from __future__ import annotations

import json
from functools import cache

from axiderive import notation as nt
from axiderive.expression import own_profile
from axiderive.expression.answer import Answer, answered
from axiderive.scene import interface
from axiderive.scene.compose import Result, composed
from axiderive.scene.reading import Scene

ALL = list(interface.functions(interface.NORMAL))
AGREEMENT = 1e-20
ROUNDING = 1e-12
"""Measured: 4e-15 for the rules, 1e-13 for inverses near a break."""
RULES = 1e-14


@cache
def answer_to(text: str) -> Answer:
    """What the engine says, derived and compared once for all that ask."""
    own = own_profile(text)
    with nt.extended(own.notation):
        return answered(own)


def module_of(text: str, values: dict[str, float] | None = None, names: list[str] = ALL) -> Result:
    request = Scene("own", "Own", own=own_profile(text), quantities=names, values=values or {}, module="own.py")
    return composed(request, None if values else answer_to(text))


def errors_of(result: Result) -> list[float]:
    """How far the functions of a module are from the definition."""
    return [float(x) for x in json.loads(result.files["evidence.json"])["module against 20-digit quadrature"].values()]
