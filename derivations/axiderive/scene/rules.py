"""The rules between the parameters of a scene, which on the graded half-space depend on its exponent."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import mpmath as mp

from .. import notation as nt
from ..contact.adhesive import pull_off_rule
from ..contact.medium import GRADED, HOMOGENEOUS
from ..profiles.profile import Profile, Rule
from ..proof.half_space import HalfSpace
from . import interface

NEEDS_PULL_OFF = frozenset([interface.PULL_OFF, *interface.SIGNED])
"""Functions that rest on a pull-off."""
DIGITS = 8
PHASES = tuple(0.5 * i for i in range(4, 16))
"""Values of 2 pi a/wavelength around the least g'/a of waves: from 4.49 at k = -1, where g' ~ f', to pi at k = 1."""


def between(profile: Profile, physics: str) -> list[Rule]:
    """The rules of the profile on its medium."""
    if not physics.startswith("graded"):
        return list(profile.rules)
    return [_graded(profile, rule) for rule in profile.rules]


def _graded(profile: Profile, rule: Rule) -> Rule:
    if profile.contact == "complete" and rule.right == nt.n:
        return replace(rule, left=1 - nt.k, reason=rule.reason.replace("n > 1", "n > 1 - k"))
    return rule


def of_pull_off(profile: Profile, physics: str) -> list[Rule]:
    """What the exponent of a power law must be for a contact that is stable under tension."""
    if interface.kind_of(physics) != "adhesive" or profile.contact != "compact":
        return []
    rule = pull_off_rule(profile, GRADED if physics.startswith("graded") else HOMOGENEOUS)
    return [rule] if rule else []


def depend_on_waves(profile: Profile, physics: str) -> bool:
    """Whether the rule between height and length of the waves is another one for every exponent of the grading."""
    return physics.startswith("graded") and nt.wavelength in profile.parameters


def open_between_waves(profile: Profile, values: Mapping[str, float]) -> float | None:
    """A radius at which g' < 0 on the graded half-space, so that the contact is not compact; None if there is none."""
    known = {symbol: mp.mpf(values[name]) for name, symbol in interface.parameters(profile).items()}
    here = HalfSpace(profile, {**known, nt.H: mp.mpf(1), nt.k: mp.mpf(values["k"])}, DIGITS, graded=True)
    with mp.workdps(DIGITS + 10):
        unit = known[nt.wavelength] / (2 * mp.pi)

        def rate(phase: float) -> float:
            return float(here.rates(unit * phase)[0] / phase)

        least = min(PHASES[1:-1], key=rate)
        step = 0.25
        while step > 1e-3:
            least = min((least - step, least, least + step), key=rate)
            step /= 2
        return float(unit * least) if rate(least) < 0.0 else None
