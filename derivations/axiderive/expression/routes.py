"""How the entries of an expression are found: by the engine, by undetermined coefficients, or as regular integrals."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from enum import Enum

from sympy.polys.polyerrors import BasePolynomialError

from ..abel.radicals import SphereAtom
from ..abel.reduce import NotReducibleError, parse
from ..build.pool import Beside
from ..entry import Entry
from ..notation import a
from ..physics import general, normal
from ..physics.medium import HOMOGENEOUS, Medium
from ..profiles.profile import Profile
from ..proof.certificate import Certificate, certify_profile
from . import undetermined
from .names import ExpressionError
from .undetermined import NotSolvableError


class Route(Enum):
    """Where the formulas come from."""

    NORMAL_FORM = "normal form"
    COEFFICIENTS = "undetermined coefficients"
    INTEGRALS = "regular integrals"


@dataclass(frozen=True)
class Derived:
    """The profile, which may have learned where it ends, its entries and their certificates."""

    profile: Profile
    entries: dict[str, Entry]
    route: Route
    proofs: Callable[[], dict[str, Certificate]]
    """The certificates by suffix, once they are there."""


def derived(profile: Profile, medium: Medium) -> Derived:
    """The entries by the first route that applies.

    Raises
    ------
    ExpressionError
        If the half-space is graded and the profile is no sum of atoms.
    """
    try:
        found = _normal_form(profile, medium)
        return Derived(*found, Route.NORMAL_FORM, Beside(certify_profile, *found).result)
    except (NotReducibleError, AssertionError, BasePolynomialError):
        if medium is not HOMOGENEOUS:
            message = "no closed form is known on a graded half-space; use a sum of powers without breaks, or --k 0"
            raise ExpressionError(message, profile.subtitle) from None
    try:
        return _by_coefficients(profile)
    except (NotSolvableError, BasePolynomialError, NotImplementedError):
        return Derived(profile, general.derive(profile), Route.INTEGRALS, dict)


def _normal_form(profile: Profile, medium: Medium) -> tuple[Profile, dict[str, Entry]]:
    """Closed entries where the profile is a sum of atoms; the profile learns where a spherical tip ends."""
    atoms = parse(profile.pieces, medium.k).atoms
    spheres = {atom.R for atom in atoms if isinstance(atom, SphereAtom)}
    if spheres:
        if len(spheres) > 1 or profile.breaks or not (end := spheres.pop()).is_Symbol:
            raise NotReducibleError
        profile = replace(profile, chain=(a, end))
    return profile, normal.derive(profile, medium)


def _by_coefficients(profile: Profile) -> Derived:
    """What was found and is proved; what is not stays an integral.

    Raises
    ------
    NotSolvableError
        If the depth or the force is not found, or not proved.
    """
    profile, entries, single = undetermined.derive(profile)
    certificates = certify_profile(profile, dict(entries))
    if not (certificates["d"].proved and certificates["F"].proved and certificates["pm"].proved):
        raise NotSolvableError
    for suffix in ("p", "w"):
        if not certificates[suffix].proved:
            entries[suffix] = single[suffix]
    return Derived(profile, entries, Route.COEFFICIENTS, lambda: certificates)
