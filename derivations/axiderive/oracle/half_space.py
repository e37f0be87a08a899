"""Contact on the homogeneous or the graded half-space as its definitions say: normal, adhesive, superposed.

Adhesion is not derived here by the formulas of the engine but as the normal
contact with the free depth g(a) - Dl, with Dl from the balance of energies
(11.63); what else superposes normal contacts by the definitions of its physics.

The compliances come from the equations of equilibrium alone.  Under a load of
wave number 1 the state at a depth of one homogeneous body is exp(A z) times
that at the surface; displacements that vanish at a large depth and the loads
leave one state.  The image of that depth in the surface is exp(-2 depth).

A pressure p J0(x) on the surface of a half-space with E = z**k moves it by
c p J0(x).  The displacements U(z) J1(x), W(z) J0(x) obey two equations of second
order whose solutions at z = 0 are power series times 1 or z**(1 - k); those
without shear at the surface that vanish at a large depth give c.  The point
force (11.33) is the integral of such pressures over all wave numbers.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..physics import DEPTH, FORCE, PRESSURE
from ..physics.consequences import CONSEQUENCES, SHORT
from ..physics.medium import GRADED, HOMOGENEOUS, Medium
from ..profiles.profile import Profile
from .evaluate import decades, evaluated, stand_ins
from .integrals import Face, Graded, Homogeneous
from .shape import Number, Values, number, shape

SPARE = 12
"""Digits carried beyond those asked for where the end of an integral is singular, which costs half of them."""


@dataclass(frozen=True)
class HalfSpace:
    """One profile at one point on a half-space with c_N(x) = modulus * |x|**k."""

    profile: Profile
    values: Values
    digits: int
    graded: bool
    pressed: tuple[Face, Number] | None = field(default=None, kw_only=True)
    """The profile up to the radius a of a contact and its free depth, in a definition by `SHORT`."""
    known: Mapping[sp.FunctionClass, Callable[..., Number]] = field(default_factory=dict, kw_only=True)
    """What else a definition may be in."""

    @property
    def k(self) -> Number:
        """The exponent of grading, zero on the homogeneous half-space."""
        return number(self.values[nt.k]) if self.graded else mp.mpf(0)

    @property
    def modulus(self) -> Number:
        """The value of H on the graded half-space, of E* on the homogeneous one."""
        return number(self.values[nt.H if self.graded else nt.E_star])

    def at(self, symbol: object) -> Number:
        """The value of a symbol, at the working precision."""
        return number(self.values[symbol])

    def face(self, a: Number, digits: int | None = None) -> Face:
        """The integrals of the profile up to the radius a."""
        kind = Graded if self.graded else Homogeneous
        return kind(shape(self.profile, {**self.values, nt.a: a}), self.k, digits or self.digits)

    def contact(self, a: Number) -> tuple[Number, Number | None]:
        """Contact radius and free depth: a complete contact has the depth d, and at a small one a free edge."""
        if self.profile.compact:
            return a, None
        depth, full = self.at(nt.d), self.depth(a)
        if depth >= full:
            return a, depth
        start, tolerance = a * mp.sqrt(depth / full), mp.mpf(10) ** (-2 * self.digits)
        ends = (start, start * mp.mpf("1.001"))
        return mp.findroot(
            lambda x: self.depth(x) / depth - 1, ends, solver="secant", tol=tolerance, verify=False
        ), None

    def depth(self, a: Number) -> Number:
        """g(a)."""
        return self.face(a).depth(a)

    def force(self, a: Number, free_depth: Number | None = None) -> Number:
        """F of a contact of radius a with the depth g(a), or with the free depth if one is given."""
        return self.modulus * self.face(a).force(a, free_depth)

    def pressure(self, r: Number, a: Number, free_depth: Number | None = None) -> Number:
        """p(r) for r < a, with the depth g(a), or with the free depth if one is given."""
        return self.modulus * self.face(a).pressure(a, r, free_depth)

    def rates(self, a: Number) -> tuple[Number, Number]:
        """dg/da and dF/da of the compact contact; both vanish where it ceases to be one, hence the extra digits."""
        face = self.face(a, self.digits + 20)
        return face.depth_rate(a), self.modulus * face.force_rate(a)

    def retraction(self, a: Number) -> Number:
        """Dl from 2 pi a dgamma = c_N(a) Dl**2, (11.63)."""
        return mp.sqrt(2 * mp.pi * a * self.at(nt.dgamma) / (self.modulus * a**self.k))

    def normal(self, suffix: str, a: Number, free_depth: Number | None = None) -> Number:
        """d, F, pm, p, w, k or a consequence; `free_depth` is that of a complete contact."""
        match suffix:
            case "d":
                return self.depth(a) if free_depth is None else free_depth
            case "F":
                return self.force(a, free_depth)
            case "pm":
                return self.force(a, free_depth) / (mp.pi * a**2)
            case "p":
                return self.pressure(self.at(nt.r), a, free_depth)
            case "w":
                return self.face(a).displacement(a, self.at(nt.r), free_depth)
            case "k" if free_depth is None:
                depth_rate, force_rate = self.rates(a)
                return force_rate / depth_rate
            case "k" if free_depth is not None:  # the force is linear in the free depth
                face = self.face(a)
                return self.modulus * (face.force(a, free_depth + 1) - face.force(a, free_depth))
        if suffix in CONSEQUENCES:
            return self._carried_by_springs(CONSEQUENCES[suffix].springs, a, free_depth)
        message = f"no integral defines {suffix!r}; use d, F, pm, p, w, k or one of {', '.join(CONSEQUENCES)}"
        raise ValueError(message)

    def _carried_by_springs(self, springs: sp.Expr, a: Number, free_depth: Number | None) -> Number:
        """An integral of integrals, of which both are as exact; a shallow profile costs two digits a decade."""
        digits = self.digits + max(SPARE, 2 * decades(self.values))
        with mp.workdps(digits):
            finer = replace(self, digits=digits, values={**self.values, nt.a: a})
            face = finer.face(a)
            return replace(finer, pressed=(face, face.depth(a) if free_depth is None else free_depth)).defined(springs)

    def adhesive(self, suffix: str, a: Number) -> Number:
        """The contact without adhesion whose depth is left short by Dl."""
        retraction = self.retraction(a)
        return retraction if suffix == "Dl" else self.normal(suffix, a, self.depth(a) - retraction)

    def separation(self, control: str, a: Number) -> Number:
        """The work of separation at which the defined F(a) resp. d(a) is stationary at this radius.

        X(a) = X_0(a) - sqrt(dgamma) Y(a): the stationary point asks for sqrt(dgamma) = X_0'/Y'.
        """
        depth_rate, force_rate = self.rates(a)
        unit = mp.sqrt(2 * mp.pi / self.modulus)

        def lost(x: Number) -> Number:
            short = unit * x ** ((1 - self.k) / 2)
            stiffness = 2 * self.modulus * x ** (1 + self.k) / (1 + self.k)
            return short if control == "depth" else stiffness * short

        # the punch alone: a power of a, whose derivative is an exact ratio of its value
        power = (1 - self.k) / 2 if control == "depth" else (3 + self.k) / 2
        own_rate = depth_rate if control == "depth" else force_rate
        return (own_rate * a / (power * lost(a))) ** 2

    @property
    def medium(self) -> Medium:
        """The half-space, as the physics on it are stated for it."""
        return GRADED if self.graded else HOMOGENEOUS

    def defined(self, expr: sp.Expr) -> Number:
        """The value of a definition in depth, force and pressure of radii; integrals over them by quadrature."""
        if isinstance(expr, sp.Piecewise):
            (expr, _), *_ = (own for own in expr.args if own.cond.xreplace(self.values) == sp.true)
        integrals = stand_ins(expr.atoms(sp.Integral), "whole")
        known = {stand_in: self._integrated(own) for own, stand_in in integrals.items()}
        rest, called = self._apart(expr.xreplace(integrals))
        return evaluated(rest, {**self.values, **known, **self._values_of(called)})

    def _integrated(self, integral: sp.Integral) -> Number:
        """By the double exponential rule in stretches that end at the breaks of the profile."""
        ((variable, *ends),) = integral.limits
        low, high = map(self.defined, ends)
        known = [*map(self.at, self.profile.breaks), *self._crossed(integral)]
        breaks = sorted(x for x in known if isinstance(x, mp.mpf) and low < x < high)
        rest, called = self._apart(integral.function)

        def integrand(x: Number) -> Number:
            there = replace(self, values={**self.values, variable: x})
            return evaluated(rest, {**there.values, **there._values_of(called)})

        # pressures are integrals themselves: no more digits of the sum than are asked for
        with mp.workdps(self.digits + MORE if called else mp.mp.dps):
            return mp.quad(integrand, [low, *breaks, high])

    def _crossed(self, integral: sp.Integral) -> list[Number]:
        """Where the radius of a spring, which may be a function of the variable, comes to a break."""
        ((variable, *_),), place = integral.limits, sp.Dummy(positive=True)
        radii = {own.args[0] for name in (DEPTH, SHORT) for own in integral.function.atoms(name)} - {variable}
        roots = [root for radius in radii if radius.has(variable) for root in sp.solve(radius - place, variable)]
        return [
            mp.re(value)
            for root in roots
            for b in map(self.at, self.profile.breaks)
            if mp.im(value := evaluated(root, {**self.values, place: b})) == 0
        ]

    def _values_of(self, called: Mapping[sp.Expr, sp.Symbol]) -> Values:
        return {stand_in: self._called(own) for own, stand_in in called.items()}

    def _called(self, called: sp.Expr) -> Number:
        """The depth, the force or a pressure; a contact no greater than the flat face has no depth, none is outside."""
        *places, radius = (evaluated(x, self.values) for x in called.args)
        if called.func in self.known:
            return self.known[called.func](*places, radius)
        if called.func == SHORT:
            return self._short(radius)
        if called.func == DEPTH:
            flat = self.at(self.profile.breaks[0]) if self.profile.truncated else mp.mpf(0)
            return self.depth(radius) if radius > flat else mp.mpf(0)
        if called.func == FORCE:
            return self.force(radius)
        (place,) = places
        return self.pressure(place, radius) if place < radius else mp.mpf(0)

    def _short(self, radius: Number) -> Number:
        """d - g of a radius below a, by which a face may be stated."""
        assert self.pressed is not None
        face, depth = self.pressed
        below = tuple(replace(piece, hi=min(piece.hi, radius)) for piece in face.shape.stretches if piece.lo < radius)
        return depth - replace(face, shape=replace(face.shape, stretches=below)).depth(radius)

    def _apart(self, expr: sp.Expr) -> tuple[sp.Expr, dict[sp.Expr, sp.Symbol]]:
        """An expression with symbols for depths, forces and pressures, and which symbol stands for which."""
        names = (DEPTH, FORCE, PRESSURE, SHORT, *self.known)
        called = stand_ins({own for name in names for own in expr.atoms(name)}, "called")
        return expr.xreplace(called), called


MORE = 4
"""Digits of an integral over pressures beyond those asked for."""
FAR = 1.5
"""Depth at which the displacements are set to zero, per digit wanted."""


def body_compliance(modulus: str, E: Number, nu: Number, digits: int) -> Number:
    """What a body with Young's modulus E and Poisson's ratio nu adds to 1/E* or 1/G*.

    A pressure moves the surface by twice its share of 1/E*.  Shears along and across a wave, of all directions alike,
    move it by twice its share of 1/G* at the mean.
    """
    depth = FAR * digits
    with mp.workdps(digits + int(depth) + 20):
        shear = E / (2 * (1 + nu))
        first = 2 * shear * nu / (1 - 2 * nu)
        wide = first + 2 * shear
        isotropic = _rates(wide, wide, first, shear)
        if modulus == "E_star":
            return _plane(isotropic, depth, 1) / 2
        # U'' = U across the wave
        across = mp.tanh(depth) / shear
        return (_plane(isotropic, depth, 0) + across) / 4


def transverse_modulus(C_11: Number, C_33: Number, C_13: Number, C_44: Number, digits: int) -> Number:
    """E* of a transversely isotropic half-space: a pressure moves its surface by 2/E*."""
    rates = _rates(C_11, C_33, C_13, C_44)
    with mp.workdps(15):
        decays = sorted(abs(value.real) for value in mp.eig(rates, right=False))
    depth = FAR * digits / float(decays[0])
    with mp.workdps(digits + int(depth * float(decays[-1])) + 20):
        return 2 / _plane(rates, depth, 1)


def _rates(along: Number, into: Number, both: Number, shear: Number) -> Any:
    """Of U, W, the shear T and the stress S into the half-space, by u_x = U sin x, u_z = W cos x."""
    # U' = W + T/C_44, W' = (S - C_13 U)/C_33, T' = C_11 U + C_13 W', S' = -T
    return mp.matrix(
        [
            [0, 1, 1 / shear, 0],
            [-both / into, 0, 0, 1 / into],
            [along - both**2 / into, 0, 0, both / into],
            [0, 0, -1, 0],
        ]
    )


def _plane(rates: Any, depth: float, load: int) -> Number:
    """U under a shear 1 (load 0) or W under a pressure 1 (load 1)."""
    below = mp.expm(rates * depth, method="taylor")
    loads = mp.matrix([-1 if load == 0 else 0, 0 if load == 0 else -1])
    surface = mp.lu_solve(below[:2, :2], -below[:2, 2:] * loads)
    return surface[load]


Pair = tuple[Number, Number]
"""Depth at which the displacement is set to zero, per digit wanted: its image in the surface is exp(-2 depth)."""


def surface_compliance(k: Number, nu: Number, digits: int) -> Number:
    """c for E = z**k, -1 < k < 1, k != 0 and nu < 1/2, to about `digits` digits."""
    depth = mp.mpf(FAR) * digits
    with mp.workdps(digits + int(depth) + 20):
        k, nu = mp.mpf(k), mp.mpf(nu)
        shear, first = 1 / (2 * (1 + nu)), nu / ((1 + nu) * (1 - 2 * nu))
        wide = first + 2 * shear
        zero = mp.mpf(0)
        own = [_series(k, shear, first, zero, start, depth) for start in ((1, 0), (0, 1))]
        # the pressure 1 on the surface; z**(1 - k) in U would be a shear
        forced = _series(k, shear, first, 1 - k, (0, -1 / (wide * (1 - k))), depth)
        matrix = mp.matrix([[own[0][0], own[1][0]], [own[0][1], own[1][1]]])
        return mp.lu_solve(matrix, -mp.matrix(forced))[1]


def _series(k: Number, shear: Number, first: Number, power: Number, start: tuple[Number, Number], z: Number) -> Pair:
    """U and W at depth z of the solution z**power (start + ...)."""
    wide, both = first + 2 * shear, first + shear
    before, last = (mp.mpf(0), mp.mpf(0)), (mp.mpf(start[0]), mp.mpf(start[1]))
    total, scale, n = list(last), mp.mpf(1), 0
    while True:
        n += 1
        grade = (n + power) * (n + power - 1 + k)
        weight = both * (n - 1 + power)
        u = ((weight + k * shear) * last[1] + wide * before[0]) / (shear * grade)
        w = (-(weight + k * first) * last[0] + shear * before[1]) / (wide * grade)
        before, last = last, (u, w)
        scale *= z
        total = [total[0] + u * scale, total[1] + w * scale]
        if n > z and (abs(u) + abs(w)) * scale < mp.eps * (abs(total[0]) + abs(total[1])):
            return total[0] * z**power, total[1] * z**power


def h_N(k: Number, nu: Number, digits: int) -> Number:
    """h_N of (11.33): the point force is the integral of J0(s r) over s, and c scales with s**(k - 1)."""
    compliance = surface_compliance(k, nu, digits)
    with mp.workdps(digits + 20):
        k, nu = mp.mpf(k), mp.mpf(nu)
        fourier = 2**k * mp.gamma((1 + k) / 2) / mp.gamma((1 - k) / 2)
        return 2 * (1 - nu**2) * mp.cos(mp.pi * k / 2) / (compliance * fourier)
