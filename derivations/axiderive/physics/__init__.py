"""Contact problems as entries: one file for each physics, which ends with the `Physics` that others ask."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import sympy as sp

if TYPE_CHECKING:
    from ..entry import Entry
    from ..profiles.profile import Profile
    from .medium import Medium
    from .viscoelastic import Law


@dataclass(frozen=True, eq=False)
class Physics:
    """One kind of contact, on whatever medium, and what others need to know of it; compared by identity."""

    name: str
    """What scenes call it, and its package on the homogeneous half-space."""
    derive: Callable[..., dict[str, Entry]]
    """The entries of a profile on a medium, by suffix; those of the contact it superposes go along if known."""
    group: str = ""
    """Part of the keys behind that of the medium: cone.fgm.adh.F."""
    over: Physics | None = None
    """The contact that it superposes, and on whose modules its own rest."""
    beside: bool = False
    """Whether it leaves that contact as it is, so that the functions of both are asked for together."""
    refusal: Callable[[Profile, Medium], str] = lambda profile, medium: ""
    """Why there are no entries of a profile; empty if there are."""
    shear: bool = False
    """Whether it loads the surface along itself too, and takes the modulus of the medium for that."""
    material: tuple[sp.Symbol, ...] = ()
    """What it takes beside the moduli of the medium."""
    tension: bool = False
    """Whether the contact holds under tension: depth and force may be negative, down to a pull-off."""
    laws: tuple[Law, ...] = ()
    """Material laws in place of the modulus: all functions are of the time, and one set of each law."""

    def parameters(self, medium: Medium) -> tuple[sp.Symbol, ...]:
        """What its functions take of the material on a medium."""
        return (*medium.moduli, *((medium.shear,) if self.shear else ()), *self.material)
