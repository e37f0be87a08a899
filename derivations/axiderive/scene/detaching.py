"""Where a contact with adhesion breaks, by the definitions: the reference for `pull_off`."""

from __future__ import annotations

import math
from typing import Any

import mpmath as mp

from .. import notation as nt
from ..proof.integrals import GUARD
from ..proof.shape import number
from .contact import DIGITS, Contact
from .edged import Edged

NEAR = 1e-9
"""Of a break, relative: a radius that is found at it."""
STEP = 1e-6
"""Relative; the loads differ by its square, which 20 digits show."""
NOTHING = 1e-14
"""Of the retraction: a depth that is none."""
State = tuple[float, float, float]
"""Radius, force and depth."""


def _corners(contact: Contact) -> list[Any]:
    known = contact.given()
    return [number(known[b]) for b in contact.profile.breaks]


def _least(contact: Contact, control: str, radius: float, corner: Any) -> State:
    """The loads at a radius on both sides of which the one that is held is larger; NaN where it is not."""
    load = {"force": contact.force, "depth": contact.depth}[control]
    place = radius if corner is None else float(corner)
    here = load(place)
    # a flat tip carries nothing at a smaller radius
    turns = here < load(place * (1 + STEP)) and (contact.profile.truncated or here < load(place * (1 - STEP)))
    return place if turns else math.nan, float(contact.force(radius)), _depth(contact, radius, contact.depth(radius))


def _depth(contact: Contact, radius: float, depth: Any) -> float:
    """The depth; where nothing but the rounding of the radius is left of it, as under r**(3/2), it is none."""
    return float(depth) if abs(depth) > NOTHING * contact.moved(radius) else 0.0


def detached(contact: Contact, control: str, radius: float) -> State | None:
    """The state of which the module says the radius: the root of dgamma nearby, None for waves, which take minutes."""
    if nt.wavelength in contact.profile.parameters:
        return None
    edged = Edged(contact)
    with mp.workdps(DIGITS + GUARD):
        if not contact.compact:
            force, depth = edged.pulled()
            return float(edged.a), float(force), float(depth)
        corner = next((b for b in _corners(contact) if abs(radius / b - 1) < NEAR), None)
        if contact.request.own is not None and not edged.graded:
            return _least(contact, control, radius, corner)
        here, wanted = edged.half_space(), mp.mpf(contact.all["dgamma"])

        def missing(scale: Any) -> Any:
            return mp.log(here.separation(control, radius * scale) / wanted)

        if corner is not None and missing(corner * (1 + NEAR) / radius) > 0:
            # At a break the load may turn without being stationary. Beyond it the depth grows as the root of the
            # distance, 1e-6 of it within two units of the last place: the loads are those of the radius itself.
            at = mp.mpf(radius)
            return float(corner), float(here.adhesive("F", at)), float(here.adhesive("d", at))
        start = mp.mpf(1)
        scale = mp.findroot(missing, (start, start * (1 + mp.mpf(10) ** -6)), solver="secant", tol=1e-30, verify=False)
        a = radius * scale
        return float(a), float(here.adhesive("F", a)), _depth(contact, float(a), here.adhesive("d", a))
