"""The whole answer to an expression: entries with certificates, the generated functions, and how far both agree."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from enum import Enum
from functools import cached_property

import mpmath as mp
import numpy as np
import sympy as sp
from sympy.polys.polyerrors import BasePolynomialError

from ..abel.atoms import HyperboloidAtom, PowerAtom, SphereAtom
from ..abel.reduce import NotReducibleError, parse
from ..build.pool import Beside
from ..code.bodies.general import least_power, library_source
from ..code.normal import module as normal_module
from ..entry import COMPACT, FOUR, Entry
from ..notation import E_star, a, r
from ..oracle.evaluate import case_at, evaluate, evaluated
from ..physics import general, normal
from ..physics.general import layers
from ..physics.medium import GRADED, HOMOGENEOUS, Medium
from ..profiles.profile import Profile, Sketch
from ..proof.certificate import Certificate, certify_profile
from . import undetermined
from .definition import Numeric, definition, lengths, quantity
from .names import ExpressionError
from .profile import OwnProfile
from .undetermined import NotSolvableError
from .validity import Validity, drawn, examine, require_slopes


class Route(Enum):
    """Where the formulas come from."""

    NORMAL_FORM = "normal form"
    COEFFICIENTS = "undetermined coefficients"
    INTEGRALS = "regular integrals"


@dataclass(frozen=True)
class Derived:
    """The profile, which may have learned where it ends, its entries and their certificates."""

    profile: Profile
    entries: dict[str, Entry]
    route: Route
    proofs: Callable[[], dict[str, Certificate]]
    """The certificates by suffix, once they are there."""


def derived(profile: Profile, medium: Medium) -> Derived:
    """The entries by the first route that applies.

    Raises
    ------
    ExpressionError
        If the half-space is graded and the profile is no sum of atoms.
    """
    try:
        found = _normal_form(profile, medium)
        return Derived(*found, Route.NORMAL_FORM, Beside(certify_profile, *found).result)
    except (NotReducibleError, AssertionError, BasePolynomialError):
        if medium is not HOMOGENEOUS:
            message = "no closed form is known on a graded half-space; use a sum of powers without breaks, or --k 0"
            raise ExpressionError(message, profile.subtitle) from None
    try:
        return _by_coefficients(profile)
    except (NotSolvableError, BasePolynomialError, NotImplementedError):
        return Derived(profile, general.derive(profile), Route.INTEGRALS, dict)


def _normal_form(profile: Profile, medium: Medium) -> tuple[Profile, dict[str, Entry]]:
    """Closed entries where the profile is a sum of atoms; the profile learns where a spherical tip ends."""
    atoms = parse(profile.pieces, medium.k).atoms
    spheres = {atom.R for atom in atoms if isinstance(atom, SphereAtom)}
    if spheres:
        if len(spheres) > 1 or profile.breaks or not (end := spheres.pop()).is_Symbol:
            raise NotReducibleError
        profile = replace(profile, chain=(a, end))
    return profile, normal.derive(profile, medium)


def _by_coefficients(profile: Profile) -> Derived:
    """What was found and is proved; what is not stays an integral.

    Raises
    ------
    NotSolvableError
        If the depth or the force is not found, or not proved.
    """
    profile, entries, single = undetermined.derive(profile)
    certificates = certify_profile(profile, dict(entries))
    if not (certificates["d"].proved and certificates["F"].proved and certificates["pm"].proved):
        raise NotSolvableError
    for suffix in ("p", "w"):
        if not certificates[suffix].proved:
            entries[suffix] = single[suffix]
    return Derived(profile, entries, Route.COEFFICIENTS, lambda: certificates)


PLACES = {"": None, "inside": sp.Rational(2, 5), "outside": sp.Rational(3, 2)}
"""Radius over the contact radius at which a quantity is compared, by the place of a field."""
DIGITS = 20
MOST_POWERS = 5
"""Ten powers took 9 s for a displacement without cancellation."""
PAST, LARGER = 2.2, 8
"""A profile that ends before this multiple of its last break is drawn with its other lengths that much larger."""


@dataclass(frozen=True)
class Comparison:
    """One formula against the integral of its definition."""

    suffix: str
    at: str
    residual: float


@dataclass(frozen=True)
class Answer(Derived):
    """What the engine says about an expression."""

    validity: Validity
    comparisons: tuple[Comparison, ...]
    module: str
    """Private functions of the normal contact on the homogeneous half-space as text, for the linker."""
    k: sp.Expr = sp.S.Zero
    """Exponent of the graded half-space; the entries hold for any."""

    @cached_property
    def certificates(self) -> dict[str, Certificate]:
        """The proofs by suffix; they are made when they are first asked for."""
        return self.proofs()

    @property
    def bounded(self) -> bool:
        """Whether the contact ends at a radius that is known at numbers only."""
        ends = self.validity.ends is not None and not self.profile.chain and bool(self.profile.parameters)
        return self.validity.compact_to is not None or ends

    @property
    def worst(self) -> float:
        """The largest relative difference of a formula from its definition, 0 without comparisons."""
        return max((c.residual for c in self.comparisons), default=0.0)

    def status(self, suffix: str) -> str:
        """How one quantity is known."""
        entry = self.entries[suffix]
        if entry.status == "closed":
            proof = self.certificates.get(suffix)
            return "closed, certified" if proof and proof.proved else "closed, not certified"
        if entry.status != "integral":
            return "solved by iteration"
        nested = any(i.function.has(sp.Integral) for c in entry.cases for i in c.expr.atoms(sp.Integral))
        # the force weighs the slope with r**2
        gentle = self._gentle or suffix in ("F", "pm")
        kind = "one regular integral" if gentle else "one integral, infinite but integrable at one end,"
        return f"{kind} over g'(t), itself an integral" if nested else kind.rstrip(",")

    @property
    def _gentle(self) -> bool:
        """Whether the slope is finite at the tip and at every break; that of sqrt(r**2 + 2*r*s) is not."""
        found = layers(self.profile)
        return all(least_power(found, layer.start) >= 1 for layer in found)

    @property
    def told(self) -> str:
        """How the formulas were found, outside the normal form."""
        if self.route is Route.NORMAL_FORM:
            return ""
        closed = [s for s in FOUR if self.entries[s].status == "closed"]
        single = [f"{s}: {self.status(s)}" for s in FOUR if s not in closed]
        found = f"{', '.join(closed)} by undetermined coefficients, certified; " if closed else ""
        return f"outside the normal form; {found}{'; '.join([*single, 'values by generated rules'])}"


def answered(own: OwnProfile, values: Mapping[sp.Symbol, sp.Rational] | None = None, k: sp.Expr = sp.S.Zero) -> Answer:
    """Derive, certify, compare and emit; to be called while the notation is extended by `own.notation`.

    Parameters
    ----------
    own : OwnProfile
        The expression.
    values : mapping, optional
        Values of parameters; the others are those of the sketch.
    k : sympy expression
        Exponent of a graded half-space.
    """
    profile, given = own.profile, dict(values or {})
    known = {symbol: sp.Rational(str(value)) for symbol, value in profile.sketch.values} | given
    require_slopes(profile, _floats(known), own.expression.text)
    if not _real(profile, known):
        known |= {p: LARGER * known[p] for p in lengths(profile.parameters) if p not in (*profile.breaks, *given)}
    validity = examine(profile, _floats(known), own.expression.text)
    if not _real(profile, known):
        message = (
            f"f ends before or soon after its last break ({drawn(_floats(known))}); put numbers for parameters, "
            "so that it ends later"
        )
        raise ExpressionError(message, own.expression.text)
    profile = _placed(profile, known, min(validity.ends or np.inf, validity.compact_to or np.inf))
    found = derived(profile, HOMOGENEOUS if k == 0 else GRADED)
    compared = () if k != 0 else _compared(found, known)
    plain = found if k == 0 else replace(found, entries=normal.derive(found.profile))
    frozen = all(p in given for p in profile.parameters)
    module = _module(plain, validity, known, frozen=frozen)
    return Answer(found.profile, found.entries, found.route, found.proofs, validity, compared, module, k)


def _floats(known: Mapping[sp.Symbol, sp.Rational]) -> dict[sp.Symbol, float]:
    return {symbol: float(value) for symbol, value in known.items()}


def _real(profile: Profile, known: Mapping[sp.Symbol, sp.Rational]) -> bool:
    """Whether there is a slope at the places beyond the breaks: a sphere may end before."""
    if not profile.breaks:
        return True
    numeric = Numeric(profile, _floats(known))
    return bool(np.isfinite(numeric.slope(np.array([PAST * numeric.breaks[-1]]))).all())


def _placed(profile: Profile, known: Mapping[sp.Symbol, sp.Rational], end: float) -> Profile:
    """The profile drawn at the values at hand: beyond its breaks, else at its own length, before its end."""
    breaks = [float(known[b]) for b in profile.breaks]
    sizes = [float(known[p]) for p in lengths(profile.parameters)]
    radius = 1.4 * breaks[-1] if breaks else min([0.8 * min(sizes) if sizes else profile.sketch.a, 0.8 * end])
    return replace(profile, sketch=Sketch(tuple(_floats(known).items()), a=radius))


def _radii(profile: Profile, known: Mapping[sp.Symbol, sp.Rational]) -> list[sp.Rational]:
    """Contact radii within each piece at which formulas are compared."""
    breaks = [known[b] for b in profile.breaks]
    size = sp.Rational(str(profile.sketch.a))
    if not breaks:
        return [size * sp.Rational(2, 5), size]
    inner = [] if profile.truncated else [breaks[0] * sp.Rational(3, 5)]
    middle = [(low + high) / 2 for low, high in zip(breaks, breaks[1:], strict=False)]
    return [*inner, *middle, breaks[-1] * sp.Rational(7, 5)]


def _compared(derived: Derived, known: dict[sp.Symbol, sp.Rational]) -> tuple[Comparison, ...]:
    """Formulas against the definition; an integral over the profile is its definition, its rule is measured instead."""
    profile, entries = derived.profile, derived.entries
    own, found, breaks = definition(profile, known, DIGITS), [], [known[b] for b in profile.breaks]
    for radius, suffix in itertools.product(_radii(profile, known), FOUR):
        entry = entries[suffix]
        over_growth = suffix == "p" and entry.status == "integral" and derived.route is Route.COEFFICIENTS
        if entry.status != "closed" and not over_growth:
            continue
        here, share = {**known, E_star: sp.S.One, a: radius}, PLACES[COMPACT[suffix].place]
        if share is not None:
            at = radius * share
            here[r] = at * sp.Rational(101, 100) if at in breaks else at
        expr, wanted = case_at(entry, here).expr, quantity(own, profile, suffix, radius, here.get(r))
        with mp.workdps(DIGITS + 5):
            value = evaluated(expr, here) if over_growth else evaluate(expr, here, DIGITS + 5)
            residual = abs(value / wanted - 1) if wanted else abs(value)
            found.append(Comparison(suffix, f"a = {float(radius):g}", float(residual)))
    return tuple(found)


def _module(found: Derived, validity: Validity, known: Mapping[sp.Symbol, sp.Rational], *, frozen: bool) -> str:
    """The module of the catalogue's kind where that is safe, else rules over the profile."""
    profile, closed = found.profile, found.route is Route.NORMAL_FORM
    if closed and validity.exact and not profile.breaks and _plain(profile):
        return normal_module({suffix: _with_numbers(entry) for suffix, entry in found.entries.items()}).source()
    numeric = Numeric(profile, _floats(known))
    reach = validity.compact_to if frozen else None
    floor = numeric.breaks[0] if profile.truncated else 0.0
    least = numeric.exponents(validity.compact_to or validity.ends)
    return library_source(profile, least, reach, floor, _end(profile, validity, frozen=frozen))


def _end(profile: Profile, validity: Validity, *, frozen: bool) -> str:
    """The radius at which f ends as text, where it is known."""
    if profile.chain and profile.chain[-1] != a:
        return str(profile.chain[-1])
    return repr(validity.ends) if validity.ends is not None and frozen else ""


def _with_numbers(entry: Entry) -> Entry:
    """Gamma functions of broken powers as the numbers they are."""

    def numbers(expr: sp.Expr) -> sp.Expr:
        return expr.replace(lambda e: isinstance(e, sp.gamma) and e.is_number, lambda e: sp.Float(e.evalf(25), 17))

    cases = tuple(replace(case, expr=numbers(case.expr)) for case in entry.cases)
    return replace(entry, cases=cases) if entry.status != "root" else entry


def _plain(profile: Profile) -> bool:
    """Whether the modules of the catalogue evaluate it without loss: whole powers, one other power, one round shape."""
    atoms = parse(profile.pieces).atoms
    powers = [atom.n for atom in atoms if isinstance(atom, PowerAtom)]
    if len(powers) == len(atoms):
        # the pressure of a root of r is an elliptic integral
        return (all(n.is_Integer for n in powers) and len(powers) <= MOST_POWERS) or (
            len(powers) == 1 and powers[0] != sp.S.Half
        )
    first = atoms[0]
    length = first.R if isinstance(first, SphereAtom) else first.b if isinstance(first, HyperboloidAtom) else sp.S.Zero
    return len(atoms) == 1 and bool(length.is_Symbol)
