"""Bodies of the inverse functions.

Bodies of the inverse functions: closed where stable, else an iteration in a variable of bounded slope.

It begins at a fit of the inverse where one dimensionless number says all, at what joins the two ends of the curve
where two do, and over waves on a Taylor series.  Where `slope_bounds` proves the slope it bounds every step; everywhere
signs guarantee the bracket.  The count is not fixed: mostly three evaluations are enough, and the last point of an
array ends it.  At most six have been seen in `tests/test_inverse_steps.py`, and elsewhere seven at four of 180 points
next to the edge of a spherical tip and at one of 1200 beside a rounded edge; arrays on both sides of the edge of a
spherical tip, which are one iteration, need up to five of the whole array and three of numbers.

The inverse of a paraboloid with a concentric wave: its curve in the unit and with the factor of the waves.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ...abel import masters
from ...entry import COMPACT, Entry
from ...notation import a
from ...physics.medium import HOMOGENEOUS
from ...profiles.profile import Profile
from ...stable.forms import EvaluationForm, evaluation_form
from ...stable.signs import facts_of
from ...stable.slopes import ROOT
from ..function import Function
from ..text import python
from .compact import Compact
from .growth import exponents, powers, start, tip_exponent


def wave_lines(profile: Profile, depth: sp.Expr, field: str) -> list[str]:
    """The body of a(d) or a(F), by the `field`.

    The depth is g(a) = square (z**2 + waves z H_0(z)) with a = unit z.

    Raises
    ------
    ValueError
        If the depth is not of that form.
    """
    depth = sp.expand(depth)
    (wave,) = depth.atoms(masters.StruveH)
    unit, square = a / wave.args[1], depth.coeff(wave, 0) / a**2
    waves = depth.coeff(wave, 1) / (a * unit * square)
    if any(sp.cancel(expr).has(a) for expr in (unit, square, waves)):
        message = f"{profile.name}: g(a) = {depth} is no paraboloid with one wave; solve it by `inverse`"
        raise ValueError(message)
    scaled = f"{field} / unit * ({python(sp.cancel(1 / square))} / unit)"
    if field == "F":
        # dF = 2 E* a dg
        scaled += f" / ({python(HOMOGENEOUS.stiffness().subs(a, sp.Symbol('unit', positive=True)))})"
    return [
        f"unit = {python(sp.cancel(unit))}",
        f"waves = {python(sp.factor_terms(sp.cancel(waves)))}",
        f"return unit * inverse_over_waves({scaled}, waves, {1 if field == 'd' else 2})",
    ]


BEYOND, BELOW = "{0} * np.sqrt(1.0 + t * t), {0} * t", "{0} * np.tanh(t), {0} / np.cosh(t)"
"""A radius and its root over the unknown, exact next to a flat face or a break, and to an end of the profile."""
TARGET = {q.suffix: (COMPACT[q.inverts].function, q.inverts) for q in COMPACT.values() if q.symbol == a}
"""Of an inverse: the curve of which it is a root, and the field that is given."""


def changed(field: str, target: Function, curve: Function, *given: str) -> list[str]:
    """The lines of F(a(d)) or d(a(F)): the radius is rounded, and dF/dd = 2 E* a makes good what it lost."""
    stiffness = python(HOMOGENEOUS.stiffness())
    missed = f"{field} - {curve.call(*given)}"
    change = f"{stiffness} * ({missed})" if field == "d" else f"({missed}) / ({stiffness})"
    return [
        f"change = np.where((a > 0.0) & (a < np.inf), {change}, 0.0)",
        f"return {target.call(*given)} + change",
    ]


@dataclass
class Inverses:
    """The private functions behind the inverse entries of one compact profile."""

    compact: Compact

    def __post_init__(self) -> None:
        self.functions = self.compact.functions
        self.profile = self.compact.profile

    def add_all(self) -> dict[str, Function]:
        """Functions of `ad`, `aF`, `Fd`, `dF`."""
        own = [q for q in COMPACT.values() if q.inverts]
        return {q.suffix: self._through(q.suffix, *q.composed) if q.composed else self._radius(q.suffix) for q in own}

    def closed(self, entry: Entry) -> EvaluationForm | None:
        """The closed form if there is one regime, nothing cancels and no large angle is raised to an exponential.

        sinh(asinh(x)/3) loses ln(x)/3 units of the last place: 221 at a force of 1e183.
        """
        if entry.status != "closed" or len(entry.cases) != 1:
            return None
        form = self.functions.form(entry, entry.cases[0].expr, self.compact.facts(entry.cases[0]))
        raised = any(expr.has(sp.sinh, sp.cosh) for expr in (form.value, *(expr for _, expr in form.steps)))
        return None if form.cancels or raised else form

    def _radius(self, suffix: str) -> Function:
        entry, (_, field) = self.compact.entries[suffix], TARGET[suffix]
        form = self.closed(entry)
        name = entry.quantity.function
        if form is not None:
            return self.functions.add(name, (field,), self.functions.returned(form))
        if self.compact.rooted:
            contact = self._contact(suffix)
            return self.functions.add(name, (field,), [f"return {contact.call()}[0]"])
        return self._newton(suffix, name)

    def _through(self, suffix: str, outer: str, inner: str) -> Function:
        """F(a(d)) or d(a(F)), closed or as that composition."""
        entry, (_, field) = self.compact.entries[suffix], TARGET[inner]
        name, outer = entry.quantity.function, COMPACT[outer].function
        form = self.closed(entry) if entry.composed is None else None
        if form is not None:
            return self.functions.add(name, (field,), self.functions.returned(form))
        if self.compact.rooted:
            contact = self.functions.functions.get(f"contact_from_{TARGET[inner][0]}") or self._contact(inner)
            target, curve = (self.functions[f"{part}_at"] for part in (outer, TARGET[inner][0]))
            lines = [f"a, root = {contact.call()}", *changed(field, target, curve, "a", "root")]
            return self.functions.add(name, (field,), lines)
        radius = self.functions[self.compact.entries[inner].quantity.function]
        target = self.functions[outer]
        if not any("inverse" in line for line in radius.lines):
            return self.functions.add(name, (field,), [f"return {target.call(radius.call())}"])
        # the radius is rounded, and says too little next to a break; dF/dd = 2 E* a makes good what it lost
        lines = [f"a = {radius.call()}", *changed(field, target, self.functions[TARGET[inner][0]], "a")]
        return self.functions.add(name, (field,), lines)

    def _contact(self, suffix: str) -> Function:
        """Contact radius and its root together: near the end of the domain the radius alone says too little."""
        curve, field = TARGET[suffix]
        target = self.functions[f"{curve}_at"]
        slope = self.compact.slopes["beyond" if self.profile.truncated else "tip"][0]
        if self.profile.truncated:
            b = str(self.compact.b)
            place = BEYOND.format(b)
            scale = f"{python(HOMOGENEOUS.stiffness() / a)} * root * root" if suffix == "aF" else "root * root / a"
            rate = f"{scale} * {slope.call('a', 'root')}"
        else:
            R = str(self.compact.scale("tip")[1])
            place = BELOW.format(R)
            scale = f"{python(HOMOGENEOUS.stiffness())} * t" if suffix == "aF" else "t"
            rate = f"{scale} * root * root / {R} * {slope.call('a', 'root')}"
        like = start(self.compact, suffix)
        lines = [
            "def curve(t: Array) -> tuple[Array, Array]:",
            f"    a, root = {place}",
            f"    value = {target.call('a', 'root')}",
            f"    return value, {rate} / value",
            "",
            f"rest = {like.rest}",
            f"start = between(np.log({field} / curve(1.0)[0]), {like.text('rest')})",
            f"t = inverse(curve, {field}, start, {self._exponents(suffix)}, smooth=True)",
            f"return {place}",
        ]
        doc = "Contact radius a and its root" + (
            f" sqrt(a**2 - {b}**2)." if self.profile.truncated else f" sqrt({R}**2 - a**2)."
        )
        return self.functions.add(f"contact_from_{curve}", (field,), lines, doc, "tuple[Array, Array]")

    def _newton(self, suffix: str, name: str) -> Function:
        curve, field = TARGET[suffix]
        if self.compact.scale("tip")[0] == "waves":
            lines = wave_lines(self.profile, self.compact.entries["d"].cases[0].expr, field)
            return self.functions.add(name, (field,), lines)
        if self.compact.b is not None:
            return self._across(suffix, name)
        target, slope = self.functions[curve], self.functions["slope"]
        lines = [
            "def curve(a: Array) -> tuple[Array, Array]:",
            f"    value = {target.call('a')}",
            f"    return value, {self._rate(suffix)} * {slope.call('a')} / value",
            "",
        ]
        largest = self.profile.largest
        if largest is not None:
            like = start(self.compact, suffix)
            lines += [
                "def like(short: Array) -> Array:",
                f"    rest = {like.rest}",
                f"    return between(np.log(short / {like.scale:.7g}), {like.text('rest')})",
                "",
                f"largest = {python(largest)} * np.ones_like({field})",
                f"return inverse_below(curve, {field}, largest, {self._exponents(suffix)}, like)",
            ]
            return self.functions.add(name, (field,), lines)
        first = "start" if self.compact.summed else f"{python(self.first_radius())} * np.ones_like({field})"
        lines += self._least_start(suffix)
        lines.append(f"return inverse(curve, {field}, {first}, {self._exponents(suffix)}, smooth=True)")
        return self.functions.add(name, (field,), lines)

    @staticmethod
    def _rate(suffix: str) -> str:
        """What the slope g' is multiplied with in the derivative by ln a."""
        return python(HOMOGENEOUS.stiffness() * a) if suffix == "aF" else "a"

    def _across(self, suffix: str, name: str) -> Function:
        """Beyond the break where the tip is a power, else on both sides, each with its own unknown."""
        (curve, field), b = TARGET[suffix], str(self.compact.b)
        grown, leaves = tip_exponent(self.compact, suffix), powers(self.compact, suffix)
        if self.compact.scale("tip")[0] == "tanh":
            slope = self._joined_slope()
            found = f"inverse_across(curve, {field}, {b}, {grown}, {self.compact.scale('tip')[1]}, {leaves})"
        else:
            slope = self.compact.slopes["beyond"][0]
            found = f"inverse_beyond(curve, {field}, {b}, {grown}, {leaves})"
        target = self.functions.functions.get(f"{curve}_at") or self.functions[f"{curve}_beyond"]
        lines = [
            "def curve(a: Array, root: Array) -> tuple[Array, Array]:",
            f"    rate = {self._rate(suffix)} * {slope.call('a', 'root')}",
            f"    return {target.call('a', 'root')}, rate",
            "",
            f"return {found}",
        ]
        return self.functions.add(name, (field,), lines)

    def _least_start(self, suffix: str) -> list[str]:
        """The radius at which the first term of a sum alone would do: at most `len(A)` times too large."""
        if not self.compact.summed:
            return []
        _, field = TARGET[suffix]
        value = evaluation_form(self.compact.entries[field].cases[0].expr, facts_of((a,))).value
        (series,) = value.atoms(sp.Sum)
        (coefficient,) = series.function.atoms(sp.Indexed)
        share = python(sp.Symbol(field, positive=True) / value.subs(series, (series.function / coefficient).subs(a, 1)))
        degree = "j" if suffix == "ad" else "(j + 1)"
        return [
            # the coefficient by itself, because its product with numbers alone may overflow
            f"alone = ({share} / A_j for j, A_j in enumerate(A, 1))",
            f"terms = (np.log(share) / {degree} for j, share in enumerate(alone, 1))",
            "start = np.exp(reduce(np.minimum, terms))",
        ]

    def first_radius(self) -> sp.Expr:
        """A length of the profile that is small against the largest contact radius."""
        lengths = [p for p in self.profile.parameters if p.name == "b"]
        return lengths[-1] / 1000 if lengths else sp.S.One

    def _joined_slope(self) -> Function:
        tip, beyond = (self.compact.slopes[side][0] for side in ("tip", "beyond"))
        b, end = self.compact.b, self.compact.scale("tip")[1]
        lines = [
            f"root_tip = np.sqrt(({end} - a) * ({end} + a))",
            f"return np.where(a < {b}, {tip.call('a', 'root_tip')}, {beyond.call('a', 'root')})",
        ]
        doc = "Rate g'(a) of the indentation depth on both sides of the break."
        return self.functions.add("slope_at", ("a", ROOT), lines, doc)

    def _exponents(self, suffix: str) -> str:
        """Whole numbers between which d ln value/d ln t lies."""
        low, high = exponents(self.compact, suffix)
        return f"({low}, {high})"
