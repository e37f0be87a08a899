"""Where a contact with adhesion breaks, by the definitions: the reference for `pull_off`."""

from __future__ import annotations

from typing import Any

import mpmath as mp

from .. import notation as nt
from ..proof.integrals import GUARD
from ..proof.shape import number
from .contact import DIGITS, Contact
from .edged import Edged

NEAR = 1e-9
"""Of a break, relative: a radius that is found at it."""
State = tuple[float, float, float]
"""Radius, force and depth."""


def _corners(contact: Contact) -> list[Any]:
    known = contact.given()
    return [number(known[b]) for b in contact.profile.breaks]


def detached(contact: Contact, control: str, radius: float) -> State | None:
    """The state of which the module says the radius: the root of dgamma nearby, None for waves, which take minutes."""
    if nt.wavelength in contact.profile.parameters:
        return None
    edged = Edged(contact)
    with mp.workdps(DIGITS + GUARD):
        if not contact.compact:
            force, depth = edged.pulled()
            return float(edged.a), float(force), float(depth)
        here, wanted = edged.half_space(), mp.mpf(contact.all["dgamma"])

        def missing(scale: Any) -> Any:
            return mp.log(here.separation(control, radius * scale) / wanted)

        corner = next((b for b in _corners(contact) if abs(radius / b - 1) < NEAR), None)
        if corner is not None and missing(corner * (1 + NEAR) / radius) > 0:
            # At a break the load may turn without being stationary. Beyond it the depth grows as the root of the
            # distance, 1e-6 of it within two units of the last place: the loads are those of the radius itself.
            at = mp.mpf(radius)
            return float(corner), float(here.adhesive("F", at)), float(here.adhesive("d", at))
        start = mp.mpf(1)
        scale = mp.findroot(missing, (start, start * (1 + mp.mpf(10) ** -6)), solver="secant", tol=1e-30, verify=False)
        a = radius * scale
        return float(a), float(here.adhesive("F", a)), float(here.adhesive("d", a))
