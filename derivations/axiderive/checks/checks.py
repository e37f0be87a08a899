"""Every check of a problem that does not trust its derivation: quadrature, enclosures, identities, units."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

from ..entry import Entry
from ..physics import layer as layered
from ..physics import materials, normal, plane
from ..physics import subsurface as deep
from ..physics.medium import HOMOGENEOUS
from ..physics.systems import Problem, System, on
from ..profiles.loads import Load
from ..proof.certificate import homogeneous_statements
from . import enclosure, identities, layer, quadrature, strips, subsurface, superposed, units
from . import materials as constants
from .comparison import Comparison, Evidence

BALL_DIGITS = 10
"""Digits by which enclosures may be wider than the quadrature is exact."""
FEWER = 4
"""Points of an entry of a system without checks of its own."""


def check_problem(
    problem: Problem, entries: Mapping[str, Entry], *, digits: int, points: int, seed: int
) -> list[Evidence]:
    """The evidence for every entry, several pieces for most of them, each under the key of its entry."""
    own = Comparison(problem.profile, entries, problem.system.physics, digits, points, seed)
    checks = list(units.check_profile(own.profile, own.entries).values())
    if problem.system in OWN:
        return checks + OWN[problem.system](own)
    own = replace(own, points=FEWER)
    return checks + [quadrature.check(own, suffix) for suffix in entries] + _identities(problem.system, own)


def _normal(own: Comparison) -> list[Evidence]:
    compared = [quadrature.check(own, suffix) for suffix in own.entries]
    balls = enclosure.check_profile(replace(own, digits=own.digits - BALL_DIGITS))
    return [*compared, *balls, *identities.check_profile(own)]


def _constants(own: Comparison) -> list[Evidence]:
    return [constants.check(replace(own, digits=40, points=6), suffix) for suffix in own.entries]


OWN: dict[System | None, Callable[[Comparison], list[Evidence]]] = {
    on(normal.PHYSICS, HOMOGENEOUS): _normal,
    on(plane.PHYSICS, HOMOGENEOUS): strips.check_profile,
    on(materials.PHYSICS, HOMOGENEOUS): _constants,
    on(deep.PHYSICS, HOMOGENEOUS): subsurface.check_profile,
    on(layered.PHYSICS, HOMOGENEOUS): layer.check_profile,
}
"""The checks of a system, where they are others than of most."""


def _identities(system: System, own: Comparison) -> list[Evidence]:
    """What ties the entries to each other, to the contact they rest on and to the homogeneous half-space."""
    profile = own.profile
    if isinstance(profile, Load):
        return [superposed.reciprocity(own, profile)]
    if system.base is None:
        found = [identities.stiffness(own)]
    else:
        found = superposed.check_profile(own, system.base.derive(profile))
    if not system.medium.graded:
        return found
    if "p" in own.entries:
        found.append(identities.pressure_carried(own))
    simple, below = system.physics.derive(profile, HOMOGENEOUS), homogeneous_statements(profile)
    return found + identities.homogeneous(own, simple, below)
