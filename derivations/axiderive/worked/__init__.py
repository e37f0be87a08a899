"""Worked examples: real materials, a real load, and the key of the formula behind every number."""

from __future__ import annotations

from .normal import worked, worked_bodies, worked_given

__all__ = ["worked", "worked_bodies", "worked_given"]
