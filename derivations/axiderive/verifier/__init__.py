"""The second prover: it reads stored entries and shares no code with the engine that wrote them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from .problem import Problem
from .theory import THEORY


def reasons(record: Mapping[str, Any], plain: Mapping[str, Any] | None = None) -> dict[str, str]:
    """Why each entry of a problem is not shown; empty where it is.

    Parameters
    ----------
    record : mapping
        `problem`, its key; `profile` and `entries` as the evidence stores them.
    plain : mapping, optional
        The same of the normal contact that an adhesive, tangential or viscoelastic problem rests on.
    """
    problem = Problem(record, Problem(plain) if plain else None)
    return {suffix: problem.prove(suffix) for suffix in problem.records}


def rests_on(key: str) -> str:
    """The key of the normal contact below a problem: cone.fgm of cone.fgm.adh; empty where it rests on none."""
    below, _, group = key.rpartition(".")
    return below if any(needs[-1] == "normal" and needs[0] == group for _, needs in THEORY.kinds) else ""
