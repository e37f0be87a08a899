"""Two more plots of a compact contact: force over depth with adhesion, tangential force over displacement."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import mpmath as mp

from .. import notation as nt
from ..profiles.profile import Profile
from .axes import HIGHEST, Axes, Curve, Mark, labelled, rounded, short
from .drawing import Rows
from .values import Numbers

PULL, LIGHT_PULL = 0.4, 0.1
"""Force of pull-off over that of the sketch, which fixes the work of separation; the second where a contact has a
largest radius, below which it would come loose under a larger one."""
WIDEST, LARGEST = 2.0, 8
"""Right end of the plot with adhesion, and the largest radius that is drawn to reach it, over that of the sketch."""


def curves(profile: Profile, numbers: Numbers) -> tuple[Axes, Axes]:
    """Both plots at the values of the sketch, in units of its depth and force."""
    return _adhesion(profile, numbers), _slip(profile, numbers)


SLIP_FRAME = 1.25
"""Upper ends of both axes of the plot of partial slip."""


def _hertz(slip: Rows) -> Curve:
    """F_x/(mu F_N) = 1 - (1 - u/u_s)^(3/2); its label is placed on the frame of the pressures."""
    rows = [(i / 60, 1 - (1 - i / 60) ** 1.5) for i in range(61)]
    up = HIGHEST / SLIP_FRAME
    family = [[(x / SLIP_FRAME, y * up) for x, y in own] for own in ([*slip, (SLIP_FRAME, 1.0)], rows)]
    placed = labelled(family, 1, "Hertz", [])
    return replace(placed, rows=rounded(rows), x=placed.x * SLIP_FRAME, y=placed.y / up)


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


def _adhesion(profile: Profile, numbers: Numbers) -> Axes:
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
    force_at, depth_at = short(*rows[least_force]), short(*rows[least_depth])
    branches = (
        ("stable", "load", rows[last:]),
        ("stable under given depth only", "load dashed", rows[first : last + 1]),
        ("unstable", "load dotted", rows[: first + 1]),
    )
    ends = (-0.9, WIDEST), (-1.0, HIGHEST)
    return Axes(
        ("$d/d_1$", r"$F_{\mathrm N}/F_1$"),
        *ends,
        ((0.0, 1.0, 2.0), (-1.0, 0.0, 1.0, 2.0, 3.0)),
        tuple(Curve(rounded(own), "", 0.0, 0.0, name=name, look=look) for name, look, own in branches),
        "Adhesion",
        rf"$\Delta\gamma$ such that $F_{{\mathrm c}}=-{pull}\,F_1$; in grey without adhesion. Dashed: stable only at a"
        " given depth; dotted: never.",
        (
            Curve([(ends[0][0], 0.0), (ends[0][1], 0.0)], "", 0.0, 0.0, name="no force"),
            Curve(rounded(plain), "", 0.0, 0.0, name="without adhesion"),
        ),
        (Mark(*force_at, r"F_{\mathrm c}", look="accent"), Mark(*depth_at, r"d_{\mathrm m}", "east", "accent")),
    )


def _scale(states: list[tuple[Any, Any, Any]], pull: Any) -> Any:
    """Retraction over the root of the radius with which the least force is -pull."""
    low, high = mp.mpf(0), max(d / mp.sqrt(a) for a, d, _ in states)
    for _ in range(40):
        middle = (low + high) / 2
        least = min(load - 2 * a * middle * mp.sqrt(a) for a, _, load in states)
        low, high = (middle, high) if least > -pull else (low, middle)
    return low


def _slip(profile: Profile, numbers: Numbers) -> Axes:
    """(11.78), (11.80): F_x/(mu F) over u/u_s, both 0 in full stick, and full slip beyond."""
    depth, force = numbers.depth, numbers("F")
    states = _states(profile, numbers, numbers["a"])
    rows = sorted((float(1 - d / depth), float(1 - load / force)) for _, d, load in states)
    full = [(1.0, 1.0), (SLIP_FRAME, 1.0)]
    ticks = (0.0, 0.5, 1.0)
    return Axes(
        (r"$u/u_{\mathrm s}$", r"$F_x/(\mu F_{\mathrm N})$"),
        (0.0, SLIP_FRAME),
        (0.0, SLIP_FRAME),
        (ticks, ticks),
        tuple(
            Curve(rounded(own), "", 0.0, 0.0, name=name, look="curve")
            for name, own in (("partial slip", rows), ("full slip", full))
        ),
        "Partial slip",
        r"the contact sticks in its middle until it slides as a whole at $u_{\mathrm s}$.",
        (_hertz(rows),),
    )
