"""Exact certificates for the formulas of the catalogue: no sampling, no limits, no simplification."""

from __future__ import annotations

from dataclasses import dataclass

from ..entry import Entry
from ..notation import F, d
from ..profiles.profile import Profile
from .compact import Compact


@dataclass(frozen=True)
class Certificate:
    """Whether a formula is proved, the statements that were shown, or why it is not proved."""

    key: str
    proved: bool
    steps: tuple[str, ...] = ()
    reason: str = ""
