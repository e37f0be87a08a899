"""What a scene can ask for, and the rules between its parameters.

The functions a scene can ask for, by physics: name, fields, and one line that says what they are.

The rules between the parameters of a scene, which on the graded half-space depend on its exponent.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..code import docstring
from ..code import plane as plane_text
from ..code.physics import adhesive as adhesive_text
from ..code.physics import loads as loads_text
from ..code.physics import tangential as tangential_text
from ..code.physics import viscoelastic as viscoelastic_text
from ..entry import COMPACT, COMPLETE, Entry, Quantity
from ..letters import name_of
from ..oracle.half_space import HalfSpace
from ..physics import adhesive, detachment, loads, normal, tangential, viscoelastic
from ..physics.adhesive import pull_off_rule
from ..physics.medium import GRADED, HOMOGENEOUS
from ..physics.plane_quantities import PLANE, PLANE_COMPLETE, PLANE_ECCENTRIC
from ..profiles import NAMES
from ..profiles.profile import Profile, Rule

LAWS = {law.name: law for law in viscoelastic.LAWS}
LETTERS = {"tau": "relaxation", "t": "time"}
"""Parameters of the material, and the time, that share their letter with another symbol of the notation."""
THRESHOLDS = ("rz", "dmin", "Fmin", "xz", "Pmin")
"""Results about the least load of complete contact, which a concave face has."""
CONCAVE = "concave"
"""A complete contact from some least load on."""
TILTED = "tilted"
"""The contact under an eccentric load, complete until one edge lifts off."""
MATERIAL = {
    "normal": ("E_star",),
    "adhesive": ("E_star", "dgamma"),
    "tangential": ("E_star", "G_star", "mu"),
    "plane": ("E_star",),
    "loads": ("E_star",),
    "graded": ("H", "k"),
    "graded.adhesive": ("H", "k", "dgamma"),
    "graded.tangential": ("H", "k", "H_x", "mu"),
    **{f"viscoelastic.{name}": tuple(map(name_of, law.parameters)) for name, law in LAWS.items()},
}
GROUP = {
    "normal": "", "plane": "", "loads": "", "adhesive": "adh.", "tangential": "tan.", "viscoelastic": "vis.",
    "graded.normal": "fgm.", "graded.adhesive": "fgm.adh.", "graded.tangential": "fgm.tan.",
}  # fmt: skip
LOADED = {"ramp": ("v",), "step": ("d",), "load": ("F",)}
"""What is given beside the time, by the kind of loading."""
PULL_OFF = "pull_off"
INVERSES = frozenset(["radius_from_depth", "radius_from_force", "force_from_depth", "depth_from_force"])
BELOW = {"tangential": "normal", "graded.tangential": "graded"}
"""The contact whose functions come with those of another."""
SIGNED = frozenset(["radius_from_depth", "radius_from_force"])
"""Fields that are negative where adhesion pulls."""


@dataclass(frozen=True)
class Function:
    """One function of the interface."""

    physics: str
    quantity: Quantity
    summary: str
    contact: str = "compact"

    @property
    def law(self) -> str:
        """The material law in its name in the catalogue."""
        return law_of(self.physics)

    @property
    def name(self) -> str:
        """What the function is called in a scene, without the material law."""
        return self.quantity.function.removesuffix(f"_{self.law}") if self.law else self.quantity.function

    @property
    def module(self) -> str:
        """The package it is in, below that of the catalogue."""
        return "viscoelastic" if self.law else {"graded": "graded.normal"}.get(self.physics, self.physics)

    @property
    def fields(self) -> tuple[str, ...]:
        """Names of its positional arguments; under a law the time comes first."""
        if self.law:
            return ("t", *LOADED[self.quantity.suffix.partition("_")[0]])
        return tuple(str(argument) for argument in self.quantity.arguments)

    @property
    def signed(self) -> bool:
        """Whether a field may be negative: loads under adhesion, places under an eccentric load."""
        return (kind_of(self.physics) == "adhesive" and self.name in SIGNED) or self.leaning

    @property
    def leaning(self) -> bool:
        """Whether the two sides of the middle differ, as under an eccentric load."""
        return self.contact == TILTED and self.name == "pressure"

    @property
    def parity(self) -> str:
        """Whether a field takes places on both sides of the middle, where it is even or odd."""
        mirrored = self.physics == "plane" and not self.leaning
        return plane_text.EVALUATED.get(self.quantity.suffix, "") if mirrored else ""

    def doc(self, profile: str) -> str:
        """The docstring: summary, unit of the result, key of the formula."""
        unit = nt.describe(self.quantity.symbol).unit
        return f"{self.summary.rstrip('.')} [{unit}]; {profile}.{GROUP[self.module]}{self.quantity.suffix}."


def law_of(physics: str) -> str:
    """The material law of a viscoelastic contact, empty for any other."""
    group, _, law = physics.partition(".")
    return law if group == "viscoelastic" else ""


def kind_of(physics: str) -> str:
    """The kind of contact on whatever medium: normal, adhesive, tangential, viscoelastic, plane or loads."""
    group, _, kind = physics.partition(".")
    return (kind or "normal") if group == "graded" else group


def id_of(physics: str, profile: str) -> str:
    """How the catalogue calls a profile: strips and pressures are told apart from round profiles of the same name."""
    return f"{physics}.{profile}" if physics in ("plane", "loads") else profile


def contact_of(profile: Profile) -> str:
    """Compact, complete or prescribed, as the profile says; a concave face and an eccentric load are told apart."""
    if profile.complete and profile.pieces[0].expr.has(nt.a):
        return CONCAVE
    return TILTED if nt.e in profile.parameters else profile.contact


def parameters(profile: Profile) -> dict[str, sp.Symbol]:
    """The parameters of a profile by their names in the functions."""
    letter = name_of if profile.contact == "prescribed" else str
    return {letter(symbol): symbol for symbol in profile.parameters}


def functions(physics: str, contact: str = "compact") -> dict[str, Function]:
    """All functions of a physics by name, `pull_off` left out."""
    table: Mapping[str, Quantity]
    if physics.startswith("viscoelastic."):
        return _viscoelastic(physics, contact)
    if physics.startswith("graded"):
        return {name: replace(own, physics=physics) for name, own in functions(kind_of(physics), contact).items()}
    if physics == "adhesive" and contact != "compact":
        table, text = detachment.QUANTITIES, {"Dl": "Retraction of the edge at which it peels off."}
    elif physics == "adhesive":
        table, text = adhesive.QUANTITIES, adhesive_text.SUMMARY
    elif physics == "tangential":
        table, text = tangential.QUANTITIES, tangential_text.SUMMARY
    elif physics == "loads":
        table, text = loads.QUANTITIES, loads_text.SUMMARY
    elif physics == "plane":
        own = {"compact": PLANE, TILTED: PLANE_ECCENTRIC}.get(contact, PLANE_COMPLETE)
        shape = {} if contact == TILTED else {"f": plane_text.SHAPE}
        table, text = {**shape, **own}, plane_text.document.SUMMARY
    else:
        table, text = COMPACT if contact == "compact" else COMPLETE, docstring.SUMMARY
    return {
        quantity.function: Function(physics, quantity, text[suffix], contact)
        for suffix, quantity in table.items()
        if suffix in text and not quantity.member and (suffix not in THRESHOLDS or contact == CONCAVE)
    }


def peaks(profile: Profile | None) -> dict[str, Function]:
    """The greatest pressure and its radius, of a profile that has them: a function of a scene has one result."""
    if profile is None or profile.name not in NAMES or "rp" not in normal.derive(profile):
        return {}
    own = [replace(q, function=f"peak_{q.member}") for q in COMPACT.values() if q.member]
    return {q.function: Function("normal", q, docstring.SUMMARY[q.suffix].partition(",")[0]) for q in own}


def _viscoelastic(physics: str, contact: str) -> dict[str, Function]:
    law = LAWS[physics.partition(".")[2]]
    text = {kind: line.format(viscoelastic_text.MATERIAL[law.name]) for kind, line in viscoelastic_text.SUMMARY.items()}
    loadings = [kind for kind in LOADED if kind != "load" or contact == "compact"]
    kinds = ((kind, viscoelastic.QUANTITIES[f"{kind}_{law.suffix}"]) for kind in loadings)
    found = [Function(physics, quantity, text[kind], contact) for kind, quantity in kinds]
    return {function.name: function for function in found}


def record(name: str, profile: Profile | None = None) -> nt.Notation:
    """The notation of a parameter by its name in the functions."""
    own = parameters(profile) if profile is not None else {}
    return nt.describe(own.get(name, LETTERS.get(name, name)))


def arguments(function: Function, entries: Mapping[str, Entry]) -> tuple[str, ...]:
    """Fields of a function; the stiffness of a capped cylinder takes the depth."""
    entry = entries.get(function.quantity.suffix)
    if function.quantity.suffix == "k" and entry is not None and any(c.expr.has(nt.d) for c in entry.cases):
        return ("d",)
    return function.fields


NEEDS_PULL_OFF = frozenset([PULL_OFF, *SIGNED])
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
    if profile.complete and rule.right == nt.n:
        return replace(rule, left=1 - nt.k, reason=rule.reason.replace("n > 1", "n > 1 - k"))
    return rule


def of_pull_off(profile: Profile, physics: str) -> list[Rule]:
    """What the exponent of a power law must be for a contact that is stable under tension."""
    if kind_of(physics) != "adhesive" or not profile.compact:
        return []
    rule = pull_off_rule(profile, GRADED if physics.startswith("graded") else HOMOGENEOUS)
    return [rule] if rule else []


def depend_on_waves(profile: Profile, physics: str) -> bool:
    """Whether the rule between height and length of the waves is another one for every exponent of the grading."""
    return physics.startswith("graded") and nt.wavelength in profile.parameters


def open_between_waves(profile: Profile, values: Mapping[str, float]) -> float | None:
    """A radius at which g' < 0 on the graded half-space, so that the contact is not compact; None if there is none."""
    known = {symbol: mp.mpf(values[name]) for name, symbol in parameters(profile).items()}
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
