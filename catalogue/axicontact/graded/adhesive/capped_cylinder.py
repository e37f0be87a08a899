"""Cylinder with a parabolic cap: no adhesive functions.

Cylinder with a parabolic cap is the adhesive paraboloid until the contact reaches the edge; from that
depth on the edge holds, the force grows with the stiffness of the flat punch, and on unloading the edge
comes loose at the same depth: use axicontact.graded.adhesive.paraboloid for radii below a; its depth and
force at the radius a are those at which the edge comes loose, and where its pull_off has a larger radius
the contact ends there.
"""

from __future__ import annotations

from typing import Any

__all__: list[str] = []

_REASON = (
    "Cylinder with a parabolic cap is the adhesive paraboloid until the contact reaches the edge; from that "
    "depth on the edge holds, the force grows with the stiffness of the flat punch, and on unloading the edge "
    "comes loose at the same depth: use axicontact.graded.adhesive.paraboloid for radii below a; its depth and "
    "force at the radius a are those at which the edge comes loose, and where its pull_off has a larger radius "
    "the contact ends there"
)


def __getattr__(name: str) -> Any:
    if name.startswith("__"):
        raise AttributeError(name)
    message = f"{name} is not defined: {_REASON}"
    raise AttributeError(message)


def __dir__() -> list[str]:
    return __all__
