"""What a scene can ask for: kinds of contact, functions with fields and one line on each, rules between parameters."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..code import subsurface as fields
from ..code.plane import SHAPE
from ..code.tables import bounds
from ..entry import COMPACT, Entry, Quantity
from ..letters import name_of
from ..oracle.half_space import HalfSpace
from ..physics import Physics, adhesive, normal, subsurface, viscoelastic
from ..physics.adhesive import pull_off_rule
from ..physics.systems import SYSTEMS, System
from ..physics.viscoelastic import Law
from ..profiles import NAMES
from ..profiles.profile import Profile, Rule

MATERIALS = [*dict.fromkeys(symbol for own in SYSTEMS for symbol in (
    *own.physics.parameters(own.medium), *(one for law in own.physics.laws for one in law.parameters)))]  # fmt: skip
LETTERS = {name_of(symbol): symbol.name for symbol in (*MATERIALS, nt.time)}
"""Names of the parameters of a material and of the time by their letters, which other symbols may have too."""
CONCAVE = "concave"
"""A complete contact from some least load on."""
TILTED = "tilted"
"""The contact under an eccentric load, complete until one edge lifts off."""
WHOLE = {subsurface.PHYSICS: fields.GIVEN}
"""Functions of several results, each of which has its own way over arrays."""
BACK = ("v", "v_2", "t_m", "t_h")
LOADED = {"ramp": ("t", "v"), "step": ("t", "d"), "load": ("t", "F"), "end": BACK,
          **dict.fromkeys(("retract", "radius", "earlier"), ("t", *BACK))}  # fmt: skip
"""What functions of a material law are given, by the kind of loading."""
PULL_OFF = "pull_off"
INVERSES = frozenset(quantity.function for quantity in COMPACT.values() if quantity.inverts)
SIGNED = frozenset(quantity.function for quantity in adhesive.QUANTITIES.values() if quantity.inverts)
"""Fields that are negative where adhesion pulls."""


@dataclass(frozen=True)
class Kind:
    """A kind of contact that a scene can ask for: a system, and the material law where it has some."""

    system: System
    law: Law | None = None

    @property
    def name(self) -> str:
        """What scenes and messages call it: "normal", "graded", "graded.adhesive", "viscoelastic.maxwell"."""
        own = self.system.name.removesuffix(".normal")
        return f"{own}.{self.law.name}" if self.law else own

    @property
    def physics(self) -> Physics:
        """The physics on whatever medium."""
        return self.system.physics

    @property
    def graded(self) -> bool:
        """Whether the half-space is graded."""
        return self.system.medium.graded

    @property
    def plain(self) -> System:
        """The system that comes first for its bodies: normal contact on the homogeneous half-space, for most."""
        return next(own for own in SYSTEMS if own.pool is self.system.pool)

    @property
    def below(self) -> Kind | None:
        """The contact whose functions come with its own."""
        return Kind(self.system.base) if self.system.base and self.physics.beside else None

    @property
    def material(self) -> tuple[str, ...]:
        """Names of the parameters of its material."""
        own = self.law.parameters if self.law else self.physics.parameters(self.system.medium)
        return tuple(map(name_of, own))


KINDS = {kind.name: kind for own in SYSTEMS if own.physics.wanted for kind in
         ([Kind(own, law) for law in own.physics.laws] or [Kind(own)])}  # fmt: skip
NORMAL = KINDS["normal"]


@dataclass(frozen=True)
class Function:
    """One function of the interface."""

    kind: Kind
    quantity: Quantity
    contact: str = "compact"

    @property
    def name(self) -> str:
        """What the function is called in a scene, without the material law."""
        law, function = self.kind.law, self.quantity.function
        return function.removesuffix(f"_{law.name}") if law else function

    @property
    def module(self) -> str:
        """The package it is in, below that of the catalogue."""
        return self.kind.system.name

    @property
    def fields(self) -> tuple[str, ...]:
        """Names of its positional arguments; under a law those of its loading."""
        if self.kind.law:
            return LOADED[self.quantity.suffix.partition("_")[0]]
        return tuple(map(name_of, self.quantity.arguments))

    @property
    def signed(self) -> bool:
        """Whether a field may be negative: loads under adhesion, places under an eccentric load."""
        pulled = self.kind.physics.tension or self.kind.physics.searched
        return bool(pulled and self.name in SIGNED) or self.leaning

    @property
    def leaning(self) -> bool:
        """Whether the two sides of the middle differ, as under an eccentric load."""
        return self.contact == TILTED and self.name == "pressure"

    @property
    def parity(self) -> str:
        """Whether a field takes places on both sides of the middle, where it is even or odd."""
        mirrored = self.kind.system.pool.strip and not self.leaning
        return self.quantity.parity if mirrored else ""

    @property
    def whole(self) -> bool:
        """Whether it has several results and its own way over arrays."""
        return self.kind.physics in WHOLE

    def doc(self, profile: str) -> str:
        """The docstring: summary, unit of the result, key of the formula; of several results what they are."""
        if self.whole:
            return self.quantity.summary
        unit = nt.describe(self.quantity.symbol).unit
        if self.quantity in self.kind.physics.searched:
            return f"{self.quantity.summary.rstrip('.')} [{unit}]."
        system = self.kind.system
        key = system.medium.key(system.pool.id(profile), system.group, self.quantity.suffix)
        return f"{self.quantity.summary.rstrip('.')} [{unit}]; {key}."


def contact_of(profile: Profile) -> str:
    """Compact, complete or prescribed, as the profile says; a concave face and an eccentric load are told apart."""
    if profile.complete and profile.pieces[0].expr.has(nt.a):
        return CONCAVE
    return TILTED if nt.e in profile.parameters else profile.contact


def parameters(profile: Profile) -> dict[str, sp.Symbol]:
    """The parameters of a profile by their names in the functions."""
    letter = name_of if profile.contact == "prescribed" else str
    return {letter(symbol): symbol for symbol in profile.parameters}


def functions(kind: Kind, contact: str = "compact") -> dict[str, Function]:
    """All functions of a kind of contact by name, `pull_off` left out."""
    if kind.law:
        return _viscoelastic(kind, kind.law, contact)
    tables = [*WHOLE.get(kind.physics, kind.physics.quantities).values()]
    table = tables[{"compact": 0, TILTED: -1}.get(contact, 1 % len(tables))]
    if kind.system.pool.strip and contact != TILTED:
        table = {"f": SHAPE} | {**table}
    return {
        quantity.function: Function(kind, quantity, contact)
        for quantity in (*table.values(), *kind.physics.searched)
        if not quantity.control and not quantity.member and (not quantity.threshold or contact == CONCAVE)
    }


def peaks(profile: Profile | None) -> dict[str, Function]:
    """The greatest pressure and its radius, of a profile that has them: a function of a scene has one result."""
    if profile is None or profile.name not in NAMES:
        return {}
    known = normal.derive(profile)
    own = [q for q in COMPACT.values() if q.member and q.suffix in known]
    alone = [replace(q, function=f"peak_{q.member}", summary=q.summary.partition(",")[0]) for q in own]
    return {q.function: Function(NORMAL, q) for q in alone}


def function(kind: Kind, profile: Profile, name: str) -> Function:
    """The function of a kind of contact, or of the one that comes with it."""
    contact = contact_of(profile)
    plain = functions(kind.below or NORMAL, contact)
    return functions(kind, contact).get(name) or plain.get(name) or peaks(profile)[name]


def _viscoelastic(kind: Kind, law: Law, contact: str) -> dict[str, Function]:
    # a radius is a question of a contact that grows
    quantities = [viscoelastic.QUANTITIES[f"{load}_{law.suffix}"] for load in LOADED]
    found = [Function(kind, q, contact) for q in quantities if contact == "compact" or q.symbol != nt.a]
    return {function.name: function for function in found}


def ramps(profile: Profile) -> bool:
    """Whether the force under a ramp of the depth is known: of a contact that grows, and of the flat punch."""
    return profile.compact or (profile.pieces[0].expr == 0 and not profile.breaks)


def unit(name: str, profile: Profile) -> str:
    """The unit of a field or a parameter."""
    return "rad" if name == subsurface.ANGLE.name else record(name, profile).unit


def record(name: str, profile: Profile | None = None) -> nt.Notation:
    """The notation of a parameter by its name in the functions."""
    own = parameters(profile) if profile is not None else {}
    return nt.describe(own.get(name, LETTERS.get(name, name)))


def interval(record: nt.Notation) -> tuple[str, str, str]:
    """The ends of the domain of a parameter, as Python writes them, and which one is in it."""
    try:
        return bounds(record.domain)
    except (ValueError, TypeError):
        return "0.0" if record.symbol.is_positive else "-inf", "inf", ""


def arguments(function: Function, entries: Mapping[str, Entry]) -> tuple[str, ...]:
    """Fields of a function; the stiffness of a capped cylinder takes the depth."""
    entry = entries.get(function.quantity.suffix)
    if entry is not None and entry.arguments != entry.quantity.arguments:
        return tuple(map(name_of, entry.arguments))
    return function.fields


NEEDS_PULL_OFF = frozenset([PULL_OFF, *SIGNED])
"""Functions that rest on a pull-off."""
DIGITS = 8
PHASES = tuple(0.5 * i for i in range(4, 16))
"""Values of 2 pi a/wavelength around the least g'/a of waves: from 4.49 at k = -1, where g' ~ f', to pi at k = 1."""


def between(profile: Profile, kind: Kind) -> list[Rule]:
    """The rules of the profile on its medium."""
    if not (kind.graded and profile.complete):
        return [*profile.rules]
    known = {rule: rule.reason.replace("n > 1", "n > 1 - k") for rule in profile.rules if rule.right == nt.n}
    return [replace(rule, left=1 - nt.k, reason=known[rule]) if rule in known else rule for rule in profile.rules]


def of_pull_off(profile: Profile, kind: Kind) -> list[Rule]:
    """What the exponent of a power law must be for a contact that is stable under tension."""
    found = pull_off_rule(profile, kind.system.medium) if kind.physics.tension and profile.compact else None
    return [found] if found else []


def depend_on_waves(profile: Profile, kind: Kind) -> bool:
    """Whether the rule between height and length of the waves is another one for every exponent of the grading."""
    return kind.graded and nt.wavelength in profile.parameters


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
