"""Which kinds of contact are at hand on which medium for which profile, and the nearest one where one is not."""

from __future__ import annotations

from ..contact import detachment, tangential
from ..contact.medium import GRADED, HOMOGENEOUS
from ..profiles.profile import Profile
from .sources import graded_refusal

ALONE = ("plane", "loads")
"""Kinds of contact with profiles of their own."""


def refusal(kind: str, profile: Profile, *, graded: bool, own: bool) -> str:
    """Why nothing is emitted for a kind of contact; empty if something is, else a sentence that names the nearest."""
    reason = _reason(kind, profile, graded=graded, own=own)
    if not reason:
        return ""
    elsewhere = 'normal = true with kind = "homogeneous"' if graded else "normal = true"
    forms = {("normal", False): elsewhere, ("normal", True): "normal = true"}
    forms = {(kind, False): 'kind = "homogeneous"', **({} if kind == "normal" else dict(reversed(forms.items())))}
    nearest = next(
        (form for (other, medium), form in forms.items()
         if (graded or not medium) and (other, medium) != (kind, graded)
         and not _reason(other, profile, graded=medium, own=own)), "another profile",
    )  # fmt: skip
    return f"{reason}; the nearest is {nearest}"


def _reason(kind: str, profile: Profile, *, graded: bool, own: bool) -> str:
    """What stands against it."""
    if kind in ALONE:
        if own:
            return f"{kind} is emitted for what the catalogue holds"
        return f"{kind} on a graded half-space is not derived" if graded else ""
    if kind == "viscoelastic":
        return "viscoelastic on a graded half-space is not derived" if graded else ""
    if kind == "adhesive" and (found := detachment.refusal(profile, GRADED if graded else HOMOGENEOUS)):
        return found.partition(": use")[0]
    if kind == "tangential" and (found := tangential.refusal(profile)):
        return found
    return graded_refusal(profile) if graded and own else ""
