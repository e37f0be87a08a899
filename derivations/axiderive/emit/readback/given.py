"""What the numbers in print have to be where there is no profile: prescribed pressures, and an eccentric load."""

from __future__ import annotations

from typing import Any

import mpmath as mp
import sympy as sp

from ...profiles.loads import Load
from .numbers import BESIDE, Columns, Contact, Wanted

SHARES = {"0": BESIDE, "a/2": "0.5", "-a/2": "-0.5", "2a": "2", "10a": "10"}
"""Places of a worked example over the contact radius; at zero a formula may be a quotient of zeros."""


def prescribed(contact: Contact) -> tuple[Wanted, Columns]:
    """Numbers by name and columns of the table of a prescribed pressure."""
    scale = contact.given["p_0"] * contact.given["a"] / contact.given["E*"]
    wanted = _at_places("w", "r", contact) | {name: lambda: _force(contact) for name in ("F", r"F_{\mathrm N}")}
    return wanted, {"w": lambda place: contact.at("w", r=place) / scale}


def eccentric(contact: Contact) -> tuple[Wanted, Columns]:
    """The same of a punch that its load tilts."""
    wanted = _at_places("p", "x", contact)
    wanted |= {r"\varphi": lambda: contact.at("phi"), r"\ell": lambda: contact.at("cw"), r"\bar p": contact.mean}
    return wanted, {"p": lambda place: contact.at("p", x=place) / contact.mean()}


def _at_places(suffix: str, axis: str, contact: Contact) -> Wanted:
    def at(share: str) -> Any:
        return contact.at(suffix, **{axis: mp.mpf(share) * contact.given["a"]})

    return {f"{suffix}({place})": lambda share=share: at(share) for place, share in SHARES.items()}  # type: ignore[misc]


def _force(contact: Contact) -> Any:
    """The force of a prescribed pressure, as the integral of p_0 (1 - r**2/a**2)**s."""
    load = next(iter(contact.entries.values())).profile
    assert isinstance(load, Load)
    power = mp.mpf(str(sp.sympify(load.exponent).xreplace(contact.values)))
    inside = mp.quad(lambda u: (1 - u) ** power, [0, 1])
    return mp.pi * contact.given["a"] ** 2 * contact.given["p_0"] * inside
