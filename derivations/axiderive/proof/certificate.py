"""Exact certificates for the formulas of the catalogue: no sampling, no limits, no simplification.

A certificate either lists the statements that were shown or gives the reason
why the formula is not proved; it never raises.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from ..entry import Entry
from ..notation import F, d
from ..profiles.profile import Profile
from .compact import Compact
from .complete import Complete
from .domain import NotProvedError

Rule = tuple[tuple[str, ...], Callable[[Any], list[str]]]

COMPACT: dict[str, Rule] = {
    "d": ((), Compact.depth),
    "F": (("d",), Compact.force),
    "p": (("d",), Compact.pressure),
    "w": (("d",), Compact.displacement),
    "k": (("F",), Compact.stiffness),
    "pm": (("F",), Compact.mean_pressure),
    "ad": (("d",), lambda proof: proof.composition("ad", d, "d", None)),
    "aF": (("F",), lambda proof: proof.composition("aF", F, "F", None)),
    "Fd": (("F",), lambda proof: proof.composition("Fd", d, "d", "F")),
    "dF": (("F",), lambda proof: proof.composition("dF", F, "F", "d")),
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
}


@dataclass(frozen=True)
class Certificate:
    """Whether a formula is proved, the statements that were shown, or why it is not proved."""

    key: str
    proved: bool
    steps: tuple[str, ...] = ()
    reason: str = ""


class Prover:
    """Certificates of one profile; what a formula rests on is certified first, once."""

    def __init__(self, entries: dict[str, Entry], rules: dict[str, Rule], build: Callable[[], Any]) -> None:
        self.entries, self.rules, self.build = entries, rules, build
        self.proof: Any = None
        self.done: dict[str, Certificate] = {}

    def certify(self, suffix: str) -> Certificate:
        if suffix not in self.done:
            self.done[suffix] = self._attempt(suffix)
        return self.done[suffix]

    def _attempt(self, suffix: str) -> Certificate:
        key = self.entries[suffix].key
        if suffix not in self.rules:
            return Certificate(key, False, reason=f"there is no rule for the quantity {suffix}")
        needed, rule = self.rules[suffix]
        try:
            if self.proof is None:
                self.proof = self.build()
            steps = tuple(dict.fromkeys(rule(self.proof)))
        except NotProvedError as error:
            return Certificate(key, False, reason=str(error))
        except Exception as error:  # a wrong formula may break any step; the caller gets the reason, not the error
            return Certificate(key, False, reason=f"the proof stopped: {type(error).__name__}: {error}")
        for base in map(self.certify, needed):
            if not base.proved:
                return Certificate(key, False, steps, f"rests on {base.key}, which is not proved")
        return Certificate(key, True, steps)


def _prover(profile: Profile, entries: dict[str, Entry]) -> Prover:
    if profile.contact == "compact":
        return Prover(entries, COMPACT, lambda: Compact(profile, entries))
    return Prover(entries, COMPLETE, lambda: Complete(profile, entries))


def certify(profile: Profile, entries: dict[str, Entry], suffix: str) -> Certificate:
    """The certificate of one entry; `entries` are all entries of the profile by suffix."""
    return _prover(profile, entries).certify(suffix)


def certify_profile(profile: Profile, entries: dict[str, Entry]) -> dict[str, Certificate]:
    """The certificates of all entries of a profile, keyed by suffix."""
    prover = _prover(profile, entries)
    return {suffix: prover.certify(suffix) for suffix in entries}
