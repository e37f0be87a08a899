"""Two more plots of a compact contact: force over depth with adhesion, tangential force over displacement."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import mpmath as mp

from .. import notation as nt
from ..oracle.values import Numbers
from ..profiles.profile import Profile
from .labels import HIGHEST, Curve, coordinates, labelled

PULL, LIGHT_PULL = 0.4, 0.1
"""Force of pull-off over that of the sketch, which fixes the work of separation; the second where a contact has a
largest radius, below which it would come loose under a larger one."""
WIDEST, LARGEST = 2.0, 8
"""Right end of the plot with adhesion, and the largest radius that is drawn to reach it, over that of the sketch."""


@dataclass(frozen=True)
class Adhesion:
    """Coordinates of the branches by stability, and the two points of pull-off."""

    stable: str
    grips: str
    unstable: str
    force: tuple[float, float]
    depth: tuple[float, float]
    without: str
    words: str


@dataclass(frozen=True)
class Curves:
    """Both plots of a contact: the branches with adhesion, and the coordinates of its partial slip."""

    adhesion: Adhesion
    slip: str
    sphere: Curve
    """Partial slip of the sphere, labelled beside that of the profile."""


def curves(profile: Profile, numbers: Numbers) -> Curves:
    """Both plots at the values of the sketch, in units of its depth and force."""
    slip = _slip(profile, numbers)
    return Curves(_adhesion(profile, numbers), coordinates(slip), _sphere(slip))


SLIP_FRAME = 1.25
"""Upper ends of both axes of the plot of partial slip."""


def _sphere(slip: list[tuple[float, float]]) -> Curve:
    """F_x/(mu F_N) = 1 - (1 - u/u_s)^(3/2); its label is placed on the frame of the pressures."""
    rows = [(i / 60, 1 - (1 - i / 60) ** 1.5) for i in range(61)]
    up = HIGHEST / SLIP_FRAME
    family = [[(x / SLIP_FRAME, y * up) for x, y in own] for own in ([*slip, (SLIP_FRAME, 1.0)], rows)]
    placed = labelled(family, 1, "sphere", [])
    return replace(placed, coordinates=coordinates(rows), x=placed.x * SLIP_FRAME, y=placed.y / up)


def _radii(profile: Profile, numbers: Numbers, largest: Any) -> list[Any]:
    """Contact radii from the tip or the first break on, dense at the start."""
    low = numbers[profile.breaks[0].name] * (1 + mp.mpf("1e-9")) if profile.truncated else numbers["a"] / 1000
    high = largest
    if nt.a in profile.chain:
        high = min(high, numbers[profile.chain[-1].name] * mp.mpf("0.999"))
    return [low + (high - low) * (mp.mpf(i) / 60) ** 2 for i in range(61)]


def _states(profile: Profile, numbers: Numbers, largest: Any) -> list[tuple[Any, Any, Any]]:
    """Radius, depth and force of the contact without adhesion."""
    members = [(radius, numbers.at(a=radius)) for radius in _radii(profile, numbers, largest)]
    return [(radius, member("d"), member("F")) for radius, member in members]


def _largest(profile: Profile, numbers: Numbers, scale: Any) -> Any:
    """The radius at which the curve with adhesion leaves the frame, or the largest that is drawn."""
    radius, depth, force = numbers["a"], numbers.depth, numbers("F")
    if profile.largest is not None:
        return radius * mp.mpf("1.3")
    largest = radius * 2
    while nt.a not in profile.chain and largest < LARGEST * radius:
        member, shift = numbers.at(a=largest), scale * mp.sqrt(largest)
        if member("d") - shift >= WIDEST * depth or member("F") - 2 * largest * shift >= HIGHEST * force:
            break
        largest *= mp.mpf("1.1")
    return largest


def _adhesion(profile: Profile, numbers: Numbers) -> Adhesion:
    """The rule of Hess with E_star = 1; stability follows from where force and depth are least."""
    radius, depth, force = numbers["a"], numbers.depth, numbers("F")
    pull = PULL if profile.largest is None else LIGHT_PULL
    scale = _scale(_states(profile, numbers, radius * 2), pull * force)
    rows, plain = [], []
    for a, d, load in _states(profile, numbers, _largest(profile, numbers, scale)):
        shift = scale * mp.sqrt(a)
        rows.append((float((d - shift) / depth), float((load - 2 * a * shift) / force)))
        plain.append((float(d / depth), float(load / force)))
    least_force = min(range(len(rows)), key=lambda i: rows[i][1])
    least_depth = min(range(len(rows)), key=lambda i: rows[i][0])
    first, last = sorted((least_depth, least_force))
    return Adhesion(
        coordinates(rows[last:]),
        coordinates(rows[first : last + 1]),
        coordinates(rows[: first + 1]),
        _point(rows[least_force]),
        _point(rows[least_depth]),
        coordinates(plain),
        rf"$\Delta\gamma$ such that $F_{{\mathrm c}}=-{pull}\,F_1$; in grey without adhesion. Dashed: stable only at a"
        " given depth; dotted: never.",
    )


def _scale(states: list[tuple[Any, Any, Any]], pull: Any) -> Any:
    """Retraction over the root of the radius with which the least force is -pull."""
    low, high = mp.mpf(0), max(d / mp.sqrt(a) for a, d, _ in states)
    for _ in range(40):
        middle = (low + high) / 2
        least = min(load - 2 * a * middle * mp.sqrt(a) for a, _, load in states)
        low, high = (middle, high) if least > -pull else (low, middle)
    return low


def _slip(profile: Profile, numbers: Numbers) -> list[tuple[float, float]]:
    """(11.78), (11.80): F_x/(mu F) over u/u_s, both 0 in full stick."""
    depth, force = numbers.depth, numbers("F")
    rows = [(float(1 - d / depth), float(1 - load / force)) for _, d, load in _states(profile, numbers, numbers["a"])]
    return sorted(rows)


def _point(row: tuple[float, float]) -> tuple[float, float]:
    return float(f"{row[0]:.4g}"), float(f"{row[1]:.4g}")
