"""The docstring of a scene's module."""

from __future__ import annotations

import textwrap
from typing import TYPE_CHECKING

from .. import __version__
from ..emit.physics.viscoelastic import MATERIAL
from ..profiles.profile import Profile
from . import interface
from .contact import Contact, worked
from .request import Request

if TYPE_CHECKING:
    from ..expression.answer import Answer


def head(request: Request, profile: Profile, answer: Answer | None, contact: Contact) -> str:
    """Title, what the profile is, and the worked example."""
    physics = request.physics
    own = MATERIAL.get(interface.law_of(physics), "")
    kind = {"normal": "without adhesion", "adhesive": "with adhesion", "tangential": "under a tangential load",
            "loads": "under a prescribed pressure",
            "plane": "of a strip without adhesion, per length",
            "viscoelastic": f"on {own}, while it grows"}[interface.kind_of(physics)]  # fmt: skip
    if physics.startswith("graded"):
        kind += " on a half-space whose modulus grows as a power of depth"
    title = _plain(request.title)
    what = f"{profile.title}: {_plain(profile.subtitle)}" if answer is None else _plain(
        profile.subtitle)  # fmt: skip
    lines = [
        f"{title}.",
        "",
        *_wrapped(f"{what}. Contact {kind}, SI units, angles in radians. Written by axicontact {__version__}."),
    ]
    if answer is not None:
        lines += _wrapped(f"Valid: {answer.validity.sentence}.")
    if request.at is not None:
        lines += _wrapped(worked(contact))
    return "\n".join(lines) + "\n"


def _plain(text: str) -> str:
    """Text that is safe within a docstring."""
    kept = "".join(c if c.isprintable() else " " for c in text).replace("\\", "/").replace('"', "'")
    return kept.rstrip(".").strip() or "Scene"


def _wrapped(text: str) -> list[str]:
    return textwrap.wrap(text, 110)
