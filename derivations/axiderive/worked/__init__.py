"""Worked examples: real materials, a real load, and the key of the formula behind every number."""

from __future__ import annotations

from .given import worked_bodies, worked_given
from .normal import worked

__all__ = ["worked", "worked_bodies", "worked_given"]
