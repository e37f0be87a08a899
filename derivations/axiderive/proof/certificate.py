"""Exact certificates for the formulas of the catalogue: no sampling, no limits, no simplification.

A certificate either lists the statements that were shown or gives the reason
why the formula is not proved; it never raises.
"""

from __future__ import annotations

import functools
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from ..abel.form import Chain
from ..entry import Entry
from ..notation import F, d
from ..physics import normal
from ..physics import subsurface as deep
from ..physics.consequences import CONSEQUENCES, Consequence
from ..physics.medium import HOMOGENEOUS, Medium
from ..physics.systems import of
from ..profiles.loads import Load
from ..profiles.pools import ELASTIC
from ..profiles.profile import Profile
from . import frame
from .algebra.domain import NotProvedError
from .frame import Frames
from .rules import adhesive, graded, loads, materials, plane, rings, subsurface, superposed, viscoelastic
from .rules.compact import Compact
from .rules.complete import Complete
from .statement import Rule


def _follows(proof: Compact | Complete, own: Consequence) -> list[str]:
    return proof.follows(own)


COMPACT: dict[str, Rule] = {
    "d": ((), Compact.depth),
    "F": (("d",), Compact.force),
    "p": (("d",), Compact.pressure),
    "w": (("d",), Compact.displacement),
    "k": (("F",), Compact.stiffness),
    "pm": (("F",), Compact.mean_pressure),
    "ad": (("d",), Compact.composition, "ad", d, "d", None),
    "aF": (("F",), Compact.composition, "aF", F, "F", None),
    "Fd": (("F",), Compact.composition, "Fd", d, "d", "F"),
    "dF": (("F",), Compact.composition, "dF", F, "F", "d"),
    "rp": (("p",), rings.greatest),
    "pp": (("p", "rp"), rings.greatest_pressure),
    **{suffix: (own.grown.needs, _follows, own) for suffix, own in CONSEQUENCES.items()},
}

COMPLETE: dict[str, Rule] = {
    "F": ((), Complete.force),
    "p": ((), Complete.pressure),
    "w": ((), Complete.displacement),
    "k": (("F",), Complete.stiffness),
    "dF": (("F",), Complete.depth_from_force),
    "rz": (("p",), Complete.zero_radius),
    "dmin": (("p",), Complete.minimum_depth),
    "Fmin": (("F", "dmin"), Complete.minimum_force),
    **{suffix: (own.fixed_rate.needs, _follows, own) for suffix, own in CONSEQUENCES.items()},
}


@dataclass(frozen=True)
class Certificate:
    """Whether a formula is proved, the statements that were shown, or why it is not proved."""

    key: str
    proved: bool
    steps: tuple[str, ...] = ()
    reason: str = ""


class Prover:
    """Certificates of one profile; what a formula rests on is certified first, once.

    A quantity `plain.F` is the force of the normal contact below, proved by `plain`.
    """

    def __init__(
        self,
        entries: dict[str, Entry],
        frames: Frames,
        rules: dict[str, Rule],
        build: Callable[[], Any],
        plain: Prover | None = None,
    ) -> None:
        self.entries, self.frames, self.rules, self.build, self.plain = entries, frames, rules, build, plain
        self.proof: Any = None
        self.done: dict[str, Certificate] = {}

    def certify(self, suffix: str) -> Certificate:
        """The certificate of a quantity, made once; of the contact below for a name like `plain.F`."""
        if self.plain is not None and suffix.startswith("plain."):
            return self.plain.certify(suffix.removeprefix("plain."))
        if suffix not in self.done:
            self.done[suffix] = self._attempt(suffix)
        return self.done[suffix]

    def _attempt(self, suffix: str) -> Certificate:
        key = self.entries[suffix].key
        if suffix not in self.rules:
            root = self.entries[suffix].status == "root"
            reason = f"{key} is the root of an equation" if root else f"there is no rule for the quantity {suffix}"
            return Certificate(key, False, reason=reason)
        needed, rule, *given = self.rules[suffix]
        try:
            self.frames[suffix].require(self.entries[suffix])
            steps = tuple(dict.fromkeys(rule(self.built(), *given)))
        except NotProvedError as error:
            return Certificate(key, False, reason=str(error))
        except Exception as error:  # a wrong formula may break any step; the caller gets the reason, not the error
            return Certificate(key, False, reason=f"the proof stopped: {type(error).__name__}: {error}")
        for base in map(self.certify, needed):
            if not base.proved:
                return Certificate(key, False, steps, f"rests on {base.key}, which is not proved")
        return Certificate(key, True, steps)

    def built(self) -> Any:
        """The statements of the profile."""
        if self.proof is None:
            self.proof = self.build()
        return self.proof


def _normal_prover(profile: Profile, entries: dict[str, Entry], medium: Medium) -> Prover:
    bounds: tuple[Chain, ...] = ()
    stated, found = medium, entries
    if medium.graded:
        found, medium, bounds = graded.shifted(entries), graded.MEDIUM, graded.BOUNDS
    if profile.compact:
        frames, rules = frame.compact(profile, stated), COMPACT
        ring = entries.get("rp")
        if ring is not None and all(case.expr == 0 for case in ring.cases):
            # the axis is shown of the face, not of its pressure
            rules = COMPACT | {ring.suffix: (("d",), rings.greatest)}
        return Prover(entries, frames, rules, lambda: Compact(profile, found, medium, bounds))
    frames = frame.complete(profile, stated)
    return Prover(entries, frames, COMPLETE, lambda: Complete(profile, found, medium, bounds))


@functools.lru_cache(maxsize=4)
def _derived(profile: Profile, medium: Medium) -> Prover:
    """The normal contact that other kinds of contact rest on, derived and proved anew."""
    return _normal_prover(profile, normal.derive(profile, medium), medium)


def homogeneous_statements(profile: Profile) -> Compact | Complete:
    """What is stated of the normal contact on the homogeneous half-space."""
    found: Compact | Complete = _derived(profile, HOMOGENEOUS).built()
    return found


def _prover(profile: Profile, entries: dict[str, Entry]) -> Prover:
    """By the system of the entries: cone.fgm.d, cone.adh.F, cone.fgm.tan.tau, cone.vis.step_mx, loads.uniform.w."""
    system = of(next(iter(entries.values())))
    physics, medium = system.physics, system.medium
    if isinstance(profile, Load):
        return Prover(entries, frame.pressed(profile), loads.RULES, lambda: loads.Loads(profile, entries))
    if profile == ELASTIC:
        return Prover(entries, frame.elastic(), materials.RULES, lambda: materials.Materials(entries))
    if system.pool.strip:
        return Prover(entries, frame.strip(profile, entries), *plane.statements(profile, entries))
    if physics.over is None:
        return _normal_prover(profile, entries, medium)
    plain = _derived(profile, medium)
    found = graded.shifted(entries) if medium.graded else entries
    if physics.laws:
        rules = viscoelastic.rules(entries, plain.entries)
        frames = frame.relaxing(profile)
        return Prover(entries, frames, rules, lambda: viscoelastic.Viscoelastic(plain.built(), found), plain)
    if physics is deep.PHYSICS:
        own, build = subsurface.rules(profile.compact), subsurface.Subsurface
        return Prover(entries, frame.below(profile), own, lambda: build(plain.built(), found), plain)
    if physics.proofs:
        proofs = physics.proofs(profile, graded.MEDIUM if medium.graded else medium)
        frames, shown = frame.superposed(physics, profile, medium), superposed.rules(proofs)
        return Prover(entries, frames, shown, lambda: superposed.Superposed(plain.built(), found, proofs), plain)
    if profile.compact:
        frames = frame.adhering(profile, medium)
        return Prover(entries, frames, adhesive.RULES, lambda: adhesive.Adhesive(plain.built(), found), plain)
    frames = frame.peeling(profile, medium)
    return Prover(entries, frames, adhesive.PEELING, lambda: adhesive.Detachment(plain.built(), found), plain)


def certify(profile: Profile, entries: dict[str, Entry], suffix: str) -> Certificate:
    """The certificate of one entry; `entries` are all entries of the profile for one kind of contact, by suffix."""
    return _prover(profile, entries).certify(suffix)


def certify_profile(profile: Profile, entries: dict[str, Entry]) -> dict[str, Certificate]:
    """The certificates of all entries of a profile for one kind of contact, keyed by suffix."""
    prover = _prover(profile, entries)
    return {suffix: prover.certify(suffix) for suffix in entries}
