"""What an entry says beside its formulas, stated a second time: key, quantity, definition, parameters, symbols.

A formula is proved to be what its quantity is defined as; under another definition, or with a symbol that no
argument carries, a true formula is a false entry.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import sympy as sp

from ..entry import Entry, Quantity, Status
from ..notation import (
    C_11,
    C_13,
    C_33,
    C_44,
    E_0,
    E_star,
    F,
    G_star,
    H,
    L,
    N,
    P,
    R,
    a,
    c_0,
    coefficients,
    d,
    dgamma,
    e,
    h_N,
    j,
    k,
    lambda_M,
    mu_T,
    nu,
    nu_1,
    nu_2,
    r,
    r_peak,
    r_zero,
    radius_1,
    radius_2,
    retraction,
    sigma_0,
    t,
    t_1,
    t_c,
    t_h,
    t_m,
    tilt,
    time,
    v,
    v_2,
    w,
    width,
    x,
    x_zero,
    young_1,
    young_2,
    z,
    z_0,
)
from ..physics import Physics, adhesive, loads, materials, normal, subsurface, viscoelastic
from ..physics.consequences import CONSEQUENCES
from ..physics.medium import Medium
from ..physics.plane import PLANE, PLANE_COMPLETE, PLANE_ECCENTRIC
from ..profiles.loads import Load
from ..profiles.pools import ELASTIC
from ..profiles.profile import Profile
from .algebra.domain import NotProvedError, require

Symbols = tuple[sp.Symbol, ...]
Frames = dict[str, "Frame"]
f_, g_, p_, w1D_, F_, E_, P_ = map(sp.Function, ("f", "g", "p", "w1D", "F", "E", "P"))
ROUTES = {"Fd": ("F", "ad"), "dF": ("d", "aF")}
"""A load or depth that is read as one formula after another, and which."""


@dataclass(frozen=True)
class Frame:
    """What the entry of one quantity has to say."""

    key: str
    profile: Profile
    quantity: Quantity
    definition: sp.Expr
    parameters: Symbols
    unknown: Symbols = ()
    """What the formula is given besides its arguments: the root of an equation that another entry states."""
    partial: Entry | None = None

    def require(self, entry: Entry) -> None:
        """Refuse an entry that says something else.

        Raises
        ------
        NotProvedError
            If one of its fields is another, or a formula holds a symbol that is neither argument nor parameter.
        """
        if (entry.key, entry.profile, entry.quantity) != (self.key, self.profile, self.quantity):
            message = f"{entry.key} is not {self.quantity.function} of {self.key}"
            raise NotProvedError(message)
        require(entry.status == _status(entry), "the formulas of {} are not {}", entry.key, entry.status)
        if entry.definition != self.definition:
            message = f"{entry.key} is defined as {entry.definition}, not as {self.definition}"
            raise NotProvedError(message)
        require(
            entry.composed in (None, ROUTES.get(entry.suffix)), "{} is no composition of {}", entry.key, entry.composed
        )
        if entry.partial != self.partial:
            message = f"{entry.key} is not the contact of the unbounded profile before the edge is reached"
            raise NotProvedError(message)
        if entry.parameters != self.parameters:
            message = f"the parameters of {entry.key} are not {', '.join(map(str, self.parameters))}"
            raise NotProvedError(message)
        self._require_symbols(entry)

    def _require_symbols(self, entry: Entry) -> None:
        known = {*self.quantity.arguments, *self.parameters, *self.unknown}
        known.update(symbol for symbol, _ in self.profile.abbreviations)
        if any(piece.expr.has(sp.Sum) for piece in self.profile.pieces):
            known |= coefficients[j].free_symbols - {j} | {N}
        for case in entry.cases:
            # the region names the radius of an equation, and the depth before the edge is reached
            own = known.union(*(member.free_symbols for member in case.chain))
            if entry.status == "closed":
                own -= {self.quantity.symbol} - known
            require(not case.expr.has(sp.Float), "{} holds a rounded number", entry.key)
            strange = case.expr.free_symbols - own
            if strange:
                message = f"{', '.join(sorted(map(str, strange)))} is neither argument nor parameter of {entry.key}"
                raise NotProvedError(message)


def _status(entry: Entry) -> Status:
    """What the formulas are: equations, integrals or closed."""
    if any(isinstance(case.expr, sp.Equality) for case in entry.cases):
        return "root"
    return "integral" if any(case.expr.has(sp.Integral) for case in entry.cases) else "closed"


def _material(medium: Medium, modulus: bool = True) -> Symbols:
    return ((medium.modulus,) if modulus else ()) + ((medium.k,) if medium.k != 0 else ())


def _grown(medium: Medium) -> dict[str, sp.Expr]:
    """(11.61), (11.51), (11.53), (11.56), at k = 0 (11.29), (11.20), (11.23), (11.26); g(t) is of earlier contacts."""
    m, exponent = medium.modulus, medium.k
    growth = sp.Derivative(g_(t), t)
    outside = sp.Integral(growth * sp.asin(t / r), (t, 0, a)) / sp.pi
    if exponent != 0:
        kernel = t**exponent * (g_(a) - g_(t)) * (r**2 - t**2) ** (-(1 + exponent) / 2)
        outside = sp.cos(sp.pi * exponent / 2) / sp.pi * sp.Integral(kernel, (t, 0, a))
    weight = (a**2 - r**2) ** ((exponent - 1) / 2)
    return {
        "d": a ** (1 - exponent) * sp.Integral(sp.Derivative(f_(r), r) * weight, (r, 0, a)),
        "F": 2 * m * sp.Integral(t**exponent * (g_(a) - g_(t)), (t, 0, a)),
        "p": m / sp.pi * sp.Integral(growth * (t**2 - r**2) ** ((exponent - 1) / 2), (t, r, a)),
        "w": 2 * outside,
    }


def compact(profile: Profile, medium: Medium) -> Frames:
    """Normal contact whose radius grows with the load."""
    own = _grown(medium)
    definitions = {
        **own,
        "k": sp.Derivative(F, d),
        "pm": F / (sp.pi * a**2),
        "ad": sp.Eq(g_(a), d),
        "aF": sp.Eq(own["F"], F),
        "Fd": own["F"],
        "dF": g_(a),
    }
    if medium.k == 0:
        definitions |= {"rp": sp.Eq(sp.Derivative(p_(r), r), 0), "pp": p_(r_peak)}
        definitions |= {suffix: own.definition for suffix, own in CONSEQUENCES.items()}
    known = normal.QUANTITIES["compact"]
    return {
        suffix: Frame(
            medium.key(profile.name, medium.group, suffix), profile, known[suffix], definition,
            profile.parameters + _material(medium, suffix not in ("d", "w", "ad")),
            (r_peak,) if suffix in ("rp", "pp") else (),
        )
        for suffix, definition in definitions.items()
    }  # fmt: skip


def complete(profile: Profile, medium: Medium) -> Frames:
    """Normal contact between fixed edges, with w1D(t) = d - g(t)."""
    m, exponent = medium.modulus, medium.k
    force = 2 * m * sp.Integral(t**exponent * w1D_(t), (t, 0, a))
    rest = sp.Integral(sp.Derivative(w1D_(t), t) * (t**2 - r**2) ** ((exponent - 1) / 2), (t, r, a))
    sunk = sp.Integral(t**exponent * w1D_(t) * (r**2 - t**2) ** (-(1 + exponent) / 2), (t, 0, a))
    weighted = (a**2 - r**2) ** ((1 - exponent) / 2) * p_(r)
    definitions = {
        "F": force,
        "p": m / sp.pi * (w1D_(a) * (a**2 - r**2) ** ((exponent - 1) / 2) - rest),
        "w": 2 * sp.cos(sp.pi * exponent / 2) / sp.pi * sunk,
        "k": sp.Derivative(F, d),
        "dF": sp.Eq(force, F),
        "rz": sp.Eq(sp.Derivative(weighted, r), 0),
        "dmin": sp.Eq(p_(r_zero), 0),
        "Fmin": force,
    }
    if medium.k == 0:
        definitions |= {suffix: own.fixed_definition for suffix, own in CONSEQUENCES.items()}
    (piece,) = profile.pieces
    before: Mapping[str, Entry] = {}
    if piece.expr != 0 and not piece.expr.has(a):
        geometry = tuple(symbol for symbol in profile.parameters if symbol != a)
        before = normal.derive(replace(profile, contact="compact", parameters=geometry), medium)
    known = normal.QUANTITIES["complete"]
    return {
        suffix: Frame(
            medium.key(profile.name, medium.group, suffix), profile, known[suffix], definition,
            profile.parameters + _material(medium, suffix not in ("w", "rz", "dmin")),
            (r_zero,) if suffix in ("rz", "dmin", "Fmin") else (), before.get(suffix),
        )
        for suffix, definition in definitions.items()
    }  # fmt: skip


def _retraction(medium: Medium) -> sp.Expr:
    return sp.Eq(2 * sp.pi * a * dgamma, medium.modulus * a**medium.k * retraction**2)


def adhering(profile: Profile, medium: Medium) -> Frames:
    """The contact without adhesion less a flat punch moved by the retraction."""
    m, exponent = medium.modulus, medium.k
    outside = 2 * sp.asin(a / r) / sp.pi
    if exponent != 0:
        outside = medium.punch_displacement().expr()
    punch = {
        "d": sp.S.One,
        "F": 2 * m * a ** (1 + exponent) / (1 + exponent),
        "p": m / sp.pi * (a**2 - r**2) ** ((exponent - 1) / 2),
        "w": outside,
    }
    left = {suffix: definition - punch[suffix] * retraction for suffix, definition in _grown(medium).items()}
    definitions = {"Dl": _retraction(medium), **left, "ad": sp.Eq(d, left["d"]), "aF": sp.Eq(F, left["F"])}
    for number, suffixes in ((3 + exponent, ("ac", "Fc", "dc")), (1 - exponent, ("am", "Fm", "dm"))):
        # Griffith's balance with the retraction whose punch leaves the load, or the depth, stationary
        level = number * sp.sqrt(sp.pi * dgamma / (2 * m)) * a ** (-(1 + exponent) / 2)
        definitions |= dict.fromkeys(suffixes, sp.Eq(sp.Derivative(g_(a), a), level))
    return {
        suffix: Frame(
            medium.key(profile.name, medium.group, adhesive.GROUP, suffix), profile, adhesive.QUANTITIES[suffix],
            definition, (() if suffix == "Dl" else profile.parameters) + _material(medium) + (dgamma,),
        )
        for suffix, definition in definitions.items()
    }  # fmt: skip


def peeling(profile: Profile, medium: Medium) -> Frames:
    """Adhesive contact between fixed edges."""
    definitions = {
        "Dl": _retraction(medium),
        "Fc": sp.Eq(F_(w1D_(a)), F),
        "dc": sp.Eq(w1D_(a), -retraction),
    }
    return {
        suffix: Frame(
            medium.key(profile.name, medium.group, adhesive.GROUP, suffix), profile, adhesive.PEELING[suffix],
            definition, ((a,) if suffix == "Dl" else profile.parameters) + _material(medium) + (dgamma,),
        )
        for suffix, definition in definitions.items()
    }  # fmt: skip


def superposed(physics: Physics, profile: Profile, medium: Medium) -> Frames:
    """A contact above another one, as its physics defines it."""
    assert physics.definitions is not None
    quantities = physics.table(profile)
    return {
        suffix: Frame(
            medium.key(profile.name, medium.group, physics.group, suffix), profile, quantities[suffix],
            definition, (*profile.parameters, *physics.taken(definition, medium, quantities[suffix].arguments)),
        )
        for suffix, definition in physics.definitions(profile, medium).items()
    }  # fmt: skip


def below(profile: Profile) -> Frames:
    """Fields below the surface: what remains of every wave of the pressure at a depth."""
    wave = sp.Symbol("wave_number", positive=True)
    pressed = g_(a) - g_(t) if profile.compact else w1D_(t)
    remains = sp.Integral(pressed * sp.cos(wave * t), (t, 0, a)) * sp.exp(-wave * z)
    table = subsurface.QUANTITIES if profile.compact else subsurface.QUANTITIES_COMPLETE
    weights = {"S": wave, "D": z * wave**2, "W": sp.S.One}
    return {
        suffix: Frame(
            f"{profile.name}.{subsurface.GROUP}.{suffix}", profile, quantity,
            sp.Integral(weights[suffix[0]] * remains * sp.besselj(int(suffix[1:] or 0), wave * r), (wave, 0, sp.oo)),
            profile.parameters,
        )
        for suffix, quantity in table.items()
    }  # fmt: skip


def relaxing(profile: Profile) -> Frames:
    """Growing contact on a viscoelastic half-space: the elastic force, per modulus, under the relaxation."""
    s = sp.Symbol("s", positive=True)
    summed = E_(time - s) * sp.Derivative(F_(s), s) / E_star
    definition = sp.Integral(summed, (s, 0, time))
    moved, back, lengths = sp.Derivative(sp.Function(d.name)(s), s), (v, v_2, t_m, t_h), profile.parameters
    kinds = {
        "ramp": (definition, (*lengths, v), ()),
        "step": (definition, lengths, (F,)),
        "load": (definition, lengths, ()),
        "earlier": (sp.Eq(sp.Integral(E_(time - s) * moved, (s, t_1, time)), 0), back, (t_1,)),
        "end": (sp.Eq(sp.Integral(E_(t_c - s) * moved, (s, 0, t_c)), 0), back, (t_c,)),
        "retract": (sp.Integral(summed, (s, 0, t_1)), (*lengths, *back), (t_1,)),
        "radius": (sp.Eq(g_(a), v * t_1), (*lengths, *back), (t_1,)),
    }
    found = {}
    for law in viscoelastic.LAWS:
        for kind, (defined, own, unknown) in kinds.items():
            suffix = f"{kind}_{law.suffix}"
            key = f"{profile.name}.{viscoelastic.GROUP}.{suffix}"
            quantity = viscoelastic.QUANTITIES[suffix]
            found[suffix] = Frame(key, profile, quantity, defined, (*own, *law.parameters), unknown)
    return found


def strip(profile: Profile, entries: Mapping[str, Entry]) -> Frames:
    """Plane contact; the modulus is a parameter of what holds it."""
    growth, s = sp.Derivative(P_(t), t), sp.Symbol("s", real=True)
    load = E_star * sp.Integral(x * sp.Derivative(f_(x), x) / sp.sqrt(a**2 - x**2), (x, 0, a))
    grown = {
        "p": sp.Integral(growth / sp.sqrt(t**2 - x**2), (t, x, a)) / sp.pi,
        "s": -2 / (sp.pi * E_star) * sp.Integral(growth / sp.sqrt(x**2 - t**2), (t, 0, a)),
        "d": 2 / (sp.pi * E_star) * sp.Integral(growth * sp.acosh(L / t), (t, 0, a)),
    }
    flat = {
        "p": 1 / (sp.pi * sp.sqrt(a**2 - x**2)),
        "s": -2 / (sp.pi * E_star * sp.sqrt(x**2 - a**2)),
        "d": 2 / (sp.pi * E_star) * sp.acosh(L / a),
    }
    if e in profile.parameters:
        quantities = PLANE_ECCENTRIC
        definitions = {
            "p": sp.Eq(sp.Integral(x * p_(x), (x, -a, a)), P * e),
            "phi": sp.Eq(2 / (sp.pi * E_star) * sp.Integral(p_(s) / (s - x), (s, -a, a)), tilt),
            "cw": sp.Eq(p_(a - width), 0),
        }
    elif profile.complete:
        quantities = PLANE_COMPLETE
        definitions = {suffix: (P - P_(a)) * flat[suffix] + own for suffix, own in grown.items()}
        definitions["xz"] = sp.Eq(sp.Derivative(sp.sqrt(a**2 - x**2) * p_(x), x), 0)
        definitions["Pmin"] = sp.Eq(p_(x_zero), 0)
    else:
        quantities = PLANE
        definitions = {"P": load, **grown, "aP": sp.Eq(load, P)}
    found = {}
    for suffix, definition in definitions.items():
        holds = suffix in entries and any(case.expr.has(E_star) for case in entries[suffix].cases)
        found[suffix] = Frame(
            f"plane.{profile.name}.{suffix}", profile, quantities[suffix], definition,
            profile.parameters + ((E_star,) if holds else ()), (x_zero,) if suffix in ("xz", "Pmin") else (),
        )  # fmt: skip
    return found


def pressed(load: Load) -> Frames:
    """The displacement under a prescribed pressure, (11.105)."""
    xi = sp.Symbol("xi", positive=True)
    definition = 2 / sp.pi * sp.Integral(w1D_(xi) / sp.sqrt(r**2 - xi**2), (xi, 0, sp.Min(r, a)))
    parameters = (*load.parameters, E_star)
    return {"w": Frame(f"loads.{load.name}.w", load, loads.QUANTITIES["w"], definition, parameters)}


def elastic() -> Frames:
    """Elastic constants of the contact."""
    scale = (1 - nu**2) * c_0**k / E_0
    pressed = [(1 - own**2) / young for young, own in ((young_1, nu_1), (young_2, nu_2))]
    sheared = [(2 - own) * (1 + own) / (2 * young) for young, own in ((young_1, nu_1), (young_2, nu_2))]
    definitions = {
        "E_star": sp.Eq(1 / E_star, sp.Add(*pressed)),
        "G_star": sp.Eq(1 / G_star, sp.Add(*sheared)),
        "H": sp.Eq(H, h_N / scale),
        "h_N": sp.Eq(w, scale * sp.cos(sp.pi * k / 2) * F / (h_N * sp.pi * r ** (1 + k))),
        "E_ti": sp.Eq(w, F / (sp.pi * E_star * r)),
        "R": sp.Eq(1 / R, 1 / radius_1 + 1 / radius_2),
        "mu_T": sp.Eq(mu_T**3, R * dgamma**2 / (E_star**2 * z_0**3)),
        "lambda_M": sp.Eq(lambda_M**3, sp.Rational(9, 2) * R * sigma_0**3 / (sp.pi * E_star**2 * dgamma)),
    }
    parameters = {
        "H": (E_0, c_0, k, nu),
        "h_N": (k, nu),
        "E_ti": (C_11, C_33, C_13, C_44),
        "R": (radius_1, radius_2),
        "mu_T": (R, E_star, dgamma, z_0),
        "lambda_M": (R, E_star, dgamma, sigma_0),
    }
    return {
        suffix: Frame(
            f"{ELASTIC.name}.{suffix}", ELASTIC, materials.QUANTITIES[suffix], definition,
            parameters.get(suffix, materials.BODIES),
        )
        for suffix, definition in definitions.items()
    }  # fmt: skip
