"""Every check of a problem that does not trust its derivation: quadrature, enclosures, identities, units."""

from __future__ import annotations

from collections.abc import Mapping

from ..entry import Entry
from ..oracle.evidence import Evidence
from ..physics import normal
from ..physics.medium import GRADED, HOMOGENEOUS
from ..physics.systems import BY_NAME, Problem
from ..profiles.profile import Profile
from ..proof.certificate import homogeneous_statements
from ..proof.rules import materials
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
PHYSICS = {
    "adhesive": "adhesive",
    "tangential": "tangential",
    "graded.normal": "graded",
    "graded.adhesive": "adhesive",
    "graded.tangential": "tangential",
    "viscoelastic": "viscoelastic",
    "loads": "load",
}


def check_problem(
    problem: Problem, entries: Mapping[str, Entry], *, digits: int, points: int, seed: int
) -> list[Evidence]:
    """The evidence for every entry, several pieces for most of them, each under the key of its entry."""
    profile, kept = problem.profile, dict(entries)
    checks = list(units.check_profile(profile, kept).values())
    if problem.system.name == "normal":
        balls = enclosure.check_profile(profile, kept, digits=digits - BALL_DIGITS, seed=seed)
        checks += quadrature.check_profile(profile, kept, digits=digits, points=points, seed=seed).values()
        checks += balls.values()
        checks += identities.check_profile(profile, kept, digits=digits, points=points, seed=seed)
    elif problem.system.name == "plane":
        checks += plane_quadrature.check_profile(profile, kept, digits=digits, points=points, seed=seed).values()
        checks += plane_closure.check_profile(profile, kept, seed=seed)
    elif problem.system.name == "materials":
        checks += [materials.check(kept, suffix, seed=seed) for suffix in kept]
    else:
        physics = PHYSICS[problem.system.name]
        checks += physics_quadrature.check_profile(profile, kept, physics, digits=digits, seed=seed).values()
        checks += _identities(problem, profile, kept, digits, seed)
    return checks


def _identities(
    problem: Problem, profile: Profile, entries: dict[str, Entry], digits: int, seed: int
) -> list[Evidence]:
    """What ties the entries to each other, to the contact they rest on and to the homogeneous half-space."""
    kind, graded = problem.system.name.removeprefix("graded."), problem.system.name.startswith("graded.")
    physics = PHYSICS[problem.system.name]
    if kind == "loads":
        return [physics_identities.reciprocity(profile, entries, digits=digits, seed=seed)]
    found: list[Evidence] = []
    if kind == "normal":
        found.append(physics_identities.stiffness(profile, entries, digits=digits, seed=seed))
    else:
        plain = normal.derive(profile, GRADED if graded else HOMOGENEOUS)
        rule = {
            "adhesive": adhesive_identities.check_profile,
            "tangential": physics_identities.slip,
            "viscoelastic": physics_identities.elastic,
        }[kind]
        found += rule(profile, entries, plain, digits=digits, seed=seed)
    if graded and "p" in entries:
        found.append(resultants.pressure(profile, entries["F"], entries["p"], physics, digits=digits, seed=seed))
    if graded:
        simple, below = BY_NAME[kind].rule(profile), homogeneous_statements(profile)
        found += homogeneous.check_profile(profile, entries, simple, below, physics, digits=digits, seed=seed)
    return found
