"""Where a contact with adhesion breaks, by the definitions: the reference for `pull_off`."""

from __future__ import annotations

from typing import Any

import mpmath as mp

from .. import notation as nt
from ..proof.integrals import GUARD
from .contact import DIGITS, Contact
from .edged import Edged

State = tuple[float, float, float]
"""Radius, force and depth."""


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

        start = mp.mpf(1)
        scale = mp.findroot(missing, (start, start * (1 + mp.mpf(10) ** -6)), solver="secant", tol=1e-30, verify=False)
        a = radius * scale
        return float(a), float(here.adhesive("F", a)), float(here.adhesive("d", a))
