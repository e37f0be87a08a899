"""Every check of a problem that does not trust its derivation: quadrature, enclosures, identities, units."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from ..entry import Entry
from ..oracle.evidence import Evidence
from ..physics import adhesive, materials, normal, plane, tangential, viscoelastic
from ..physics.medium import HOMOGENEOUS
from ..physics.systems import Problem, System, on
from ..profiles.loads import Load
from ..profiles.profile import Profile
from ..proof.certificate import homogeneous_statements
from ..proof.rules import materials as constants
from . import (
    adhesive_identities,
    enclosure,
    homogeneous,
    identities,
    physics_identities,
    physics_quadrature,
    plane_closure,
    plane_quadrature,
    quadrature,
    resultants,
    units,
)

BALL_DIGITS = 10
"""Digits by which enclosures may be wider than the quadrature is exact."""
Entries = dict[str, Entry]
IDENTITIES = {
    adhesive.PHYSICS: adhesive_identities.check_profile,
    tangential.PHYSICS: physics_identities.slip,
    viscoelastic.PHYSICS: physics_identities.elastic,
}
"""What ties the entries of a physics to those of the contact it superposes."""


def check_problem(
    problem: Problem, entries: Mapping[str, Entry], *, digits: int, points: int, seed: int
) -> list[Evidence]:
    """The evidence for every entry, several pieces for most of them, each under the key of its entry."""
    profile, kept, system = problem.profile, dict(entries), problem.system
    checks = list(units.check_profile(profile, kept).values())
    if system in OWN:
        return checks + OWN[system](profile, kept, digits, points, seed)
    checks += physics_quadrature.check_profile(profile, kept, system.physics, digits=digits, seed=seed).values()
    return checks + _identities(system, profile, kept, digits, seed)


def _normal(profile: Profile, entries: Entries, digits: int, points: int, seed: int) -> list[Evidence]:
    balls = enclosure.check_profile(profile, entries, digits=digits - BALL_DIGITS, seed=seed)
    compared = quadrature.check_profile(profile, entries, digits=digits, points=points, seed=seed)
    found = identities.check_profile(profile, entries, digits=digits, points=points, seed=seed)
    return [*compared.values(), *balls.values(), *found]


def _plane(profile: Profile, entries: Entries, digits: int, points: int, seed: int) -> list[Evidence]:
    compared = plane_quadrature.check_profile(profile, entries, digits=digits, points=points, seed=seed)
    return [*compared.values(), *plane_closure.check_profile(profile, entries, seed=seed)]


def _constants(profile: Profile, entries: Entries, digits: int, points: int, seed: int) -> list[Evidence]:
    return [constants.check(entries, suffix, seed=seed) for suffix in entries]


OWN: dict[System | None, Callable[[Profile, Entries, int, int, int], list[Evidence]]] = {
    on(normal.PHYSICS, HOMOGENEOUS): _normal,
    on(plane.PHYSICS, HOMOGENEOUS): _plane,
    on(materials.PHYSICS, HOMOGENEOUS): _constants,
}
"""The checks of a system, where they are others than of most."""


def _identities(system: System, profile: Profile, entries: Entries, digits: int, seed: int) -> list[Evidence]:
    """What ties the entries to each other, to the contact they rest on and to the homogeneous half-space."""
    if isinstance(profile, Load):
        return [physics_identities.reciprocity(profile, entries, digits=digits, seed=seed)]
    found: list[Evidence] = []
    if system.base is None:
        found.append(physics_identities.stiffness(profile, entries, digits=digits, seed=seed))
    else:
        found += IDENTITIES[system.physics](profile, entries, system.base.derive(profile), digits=digits, seed=seed)
    if not system.medium.graded:
        return found
    if "p" in entries:
        found.append(resultants.pressure(profile, entries["F"], entries["p"], system.physics, digits=digits, seed=seed))
    simple, below = system.physics.derive(profile, HOMOGENEOUS), homogeneous_statements(profile)
    return found + homogeneous.check_profile(profile, entries, simple, below, system.physics, digits=digits, seed=seed)
