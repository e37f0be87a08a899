"""Cylinder with a parabolic cap: no adhesive functions.

Cylinder with a parabolic cap keeps its edge until it peels off and is then the unbounded profile with a
smaller contact radius: use axicontact.adhesive.paraboloid.
"""

from __future__ import annotations

from typing import Any

_REASON = (
    "Cylinder with a parabolic cap keeps its edge until it peels off and is then the unbounded profile with a "
    "smaller contact radius: use axicontact.adhesive.paraboloid"
)


def __getattr__(name: str) -> Any:
    if name.startswith("__"):
        raise AttributeError(name)
    message = f"{name} is not defined: {_REASON}"
    raise AttributeError(message)
