"""Every check of a problem that does not trust its derivation: quadrature, enclosures, identities, units."""

from __future__ import annotations

from collections.abc import Mapping

from ..contact.systems import Problem
from ..entry import Entry
from . import enclosure, identities, materials, physics_quadrature, plane_closure, plane_quadrature, quadrature, units
from .evidence import Evidence

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
    return checks
