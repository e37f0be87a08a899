"""Bodies for profiles with several breaks or without closed forms.

Function functions of a profile with several breaks or without closed forms: rules over the profile.

Depth, force and displacement are integrals of f' times a positive weight.  The
pressure is one of g' where f is a polynomial, whose g' is closed without
cancellation, else one of (s f')' times an elliptic integral.

What begins at the tip or at a break, as text: its functions, how far a rule goes, and g' in closed form.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

import numpy as np
import sympy as sp

from ...abel.form import Order
from ...abel.reduce import NotReducibleError, parse
from ...notation import E_star, a, r
from ...physics.consequences import CONSEQUENCES, Consequence
from ...physics.general import Layer, beyond, excess, layers
from ...profiles.profile import Piece, Profile
from ...stable.forms import EvaluationForm, evaluation_form
from ...stable.signs import facts_of
from ...stable.slopes import slope_form
from ..function import Function
from ..module import PLACE
from ..normal import bodies_source, profile_function
from ..private import LINE, PrivateFunctions
from ..text import python
from .inverses import changed

LEAST_POWER = sp.Rational(1, 12)
"""The least exponent a profile may have; a parameter may be as small."""


def reach(layers: Iterable[Layer], start: sp.Expr) -> str:
    """How far a rule goes towards a start where f is a power below 1 of the distance, as its last argument."""
    least = least_power(layers, start)
    return "" if least >= 1 else f", {_far(least):.1f}"


def least_power(layers: Iterable[Layer], start: sp.Expr) -> sp.Expr:
    """The least power of the distance from a start in what begins there, 1 if all are larger."""
    shapes = (beyond(layer.shape, start) for layer in layers if layer.start == start)
    powers = [power for shape in shapes for power in _powers(shape)]
    if any(not power.is_number for power in powers):
        return LEAST_POWER
    return min((power for power in powers if power > 0), default=sp.S.One)


def _powers(expr: sp.Expr) -> Iterator[sp.Expr]:
    """Powers of the distance that an expression has, those behind a root of what vanishes at the start too."""
    for power in expr.atoms(sp.Pow):
        place = next((symbol for symbol in (r, excess) if power.base.has(symbol)), None)
        if power.base == place:
            yield power.exp
        elif place is not None and not power.exp.is_Integer and sp.expand(power.base.subs(place, 0)) == 0:
            yield power.exp * _order(power.base, place)


def _order(base: sp.Expr, place: sp.Symbol) -> sp.Expr:
    """The least power of a base that vanishes."""
    if base.is_polynomial(place):
        return sp.Integer(min(power for (power,) in sp.Poly(base, place).monoms()))
    return min((power for power in (sp.S.One, *_powers(base)) if power.is_positive), default=sp.S.One)


def _far(power: sp.Expr) -> float:
    """The t with power*(t + t**3/75) = 46, where the integral of a power has lost its last digit."""
    wanted = 46.0 / float(power)
    return float(max(root.real for root in np.roots([1.0 / 75.0, 0.0, 1.0, -wanted]) if abs(root.imag) < 1e-9))


def text(expr: sp.Expr) -> str:
    """The expression as Python code, in its stable form where that is one expression and does not cancel."""
    form = evaluation_form(expr, facts_of(()))
    return python(expr) if form.cancels or form.steps else python(form.value)


def radius_text(start: sp.Expr) -> str:
    """A radius as Python code, zero as a float."""
    return "0.0" if start == 0 else str(start)


def closed(layer: Layer) -> EvaluationForm | None:
    """g' of a layer by the engine, if it is a polynomial and its form does not cancel."""
    b = layer.start
    if not layer.shape.is_polynomial(r):
        return None
    pieces = (Piece(None, layer.shape),) if b == 0 else (Piece(b, sp.S.Zero), Piece(None, layer.shape))
    chain = (a,) if b == 0 else (b, a)
    try:
        depth = parse(pieces).depth(Order(chain)).expr()
        form = slope_form(depth, facts_of(chain))
    except (NotReducibleError, ValueError, AssertionError):
        return None
    rooted = {str(name) for name, _ in form.steps}
    allowed = set() if b == 0 else {"root"}
    plain = {name for name in rooted if name.startswith("root")} <= allowed
    return form if plain and not form.cancels else None


COUNT = 64
"""Nodes over a closed g'."""
LIBRARY = "from ..{place}.over_profile import across, over_profile, pressure_over_profile"
"""Integrals over the profile itself, which are known to the linker alone."""


def library_source(
    profile: Profile,
    exponents: tuple[float, float],
    reach: float | None = None,
    floor: float = 0.0,
    end: str = "",
) -> str:
    """The functions as text, for the linker.

    Parameters
    ----------
    profile : Profile
        Compact, with any number of breaks.
    exponents : tuple of float
        Least logarithmic slope of depth and force over the contact radius.
    reach : float, optional
        Contact radius up to which the contact is compact, for frozen parameters; beyond it there are no inverses.
    floor : float
        Radius of the flat face of a truncated profile, for the same parameters.
    end : str
        Radius at which the profile ends, a parameter or a number.
    """
    functions = PrivateFunctions(profile)
    profile_function(functions)
    _General(functions, reach, floor, end).add_all(exponents)
    source = bodies_source(functions, profile.title)
    return source.replace("import numpy as np\n", f"import numpy as np\n\n{LIBRARY.format(place=PLACE)}", 1)


@dataclass
class _General:
    functions: PrivateFunctions
    reach: float | None = None
    floor: float = 0.0
    end: str = ""

    def __post_init__(self) -> None:
        self.profile = self.functions.profile
        self.layers = layers(self.profile)
        self.start = self.profile.breaks[0] if self.profile.truncated else None

    def add_all(self, exponents: tuple[float, float]) -> None:
        """Adds all private functions; `exponents` bound the logarithmic slopes of depth and force from below."""
        self.steep = [self._steepness(i, piece) for i, piece in enumerate(self.profile.pieces)]
        self.growths = [self._growth(i, layer) for i, layer in enumerate(self.layers)]
        self.bends = [
            None if growth else self._bend(i, layer)
            for i, (layer, growth) in enumerate(zip(self.layers, self.growths, strict=True))
        ]
        self._over("depth", "1.0", "a")
        self._over("force", "x * x", python(2 * E_star))
        self._pressure()
        self._displacement()
        self.functions.add("stiffness", ("a",), ["return 2 * E_star * a"])
        force = self.functions["force"]
        self.functions.add("mean_pressure", ("a",), [f"return {force.call()} / (np.pi * a**2)"])
        for own in CONSEQUENCES.values():
            self._follows(own)
        rate = self._slope_at()
        for field, curve, exponent in (("d", "depth", exponents[0]), ("F", "force", exponents[1])):
            self._inverse(field, curve, rate, exponent)

    def _follows(self, own: Consequence) -> None:
        """A consequence by the depths of smaller contacts, of which one within a flat face has none, and no force."""
        rules, inside = own.rules, own.compact.place == "inside"
        depth, force = self.functions["depth"], self.functions["force"]

        def pressed(call: str) -> str:
            return call if self.start is None else f"np.where(inner > {self.start}, {call}, 0.0)"

        least = "inner" if self.start is None else f"np.maximum(inner, {self.start})"
        lines = [line.format(of_a=depth.call(), of_inner=pressed(depth.call(least))) for line in rules.anywhere]
        starts = [sp.S.Zero, *self.profile.breaks]
        for low, high, steep in zip(starts, [*map(str, starts[1:]), "np.inf"], self.steep, strict=True):
            if steep is None:
                continue
            lower = radius_text(low)
            if inside:
                lower = "inner" if low == 0 else f"np.maximum({low}, inner)"
            beyond_inner = "excess" if low == 0 else f"(excess + ({lower} - inner))"
            # what lies below is nothing beside the rest, and the places of its rule would underflow
            at_least = depth.call("np.maximum(x, 1e-40 * a)")
            weight = rules.weight.format(of_x=at_least).replace("from_inner", beyond_inner)
            lines += [f"def weight_{low}(x: Array, z: Array, excess: Array, within: Array) -> Array:"]
            lines += [f"    return {weight} * z"]
            before = "whole + " if any(line.startswith("whole = ") for line in lines) else ""
            lines.append(f"whole = {before}over_profile(weight_{low}, a, {lower}, {high}{reach(self.layers, low)})")
        value = rules.whole.format(force=pressed(force.call(least)), flat=self.start or "0.0")
        lines.append(f"return {self._reached(value)}")
        self.functions.add(own.compact.function, tuple(map(str, own.compact.arguments)), lines)

    def _steepness(self, index: int, piece: Piece) -> Function | None:
        starts = (sp.S.Zero, *self.profile.breaks[:index])
        own = [layer for layer in self.layers if layer.start in starts]
        if not own:
            return None
        if index == 0:
            return self.functions.add("steepness_0", ("r",), [f"return {text(own[0].slope)}"], "Slope f'(r).")
        start = starts[-1]
        inner = [layer.slope.subs(r, start + excess) for layer in own if layer.start != start]
        slope = sp.Add(*inner, *(beyond(layer.slope, start) for layer in own if layer.start == start))
        doc = f"Slope f'(r) at r = {start} + excess."
        return self.functions.add(f"steepness_{index}", ("excess",), [f"return {text(slope)}"], doc)

    def _growth(self, index: int, layer: Layer) -> Function | None:
        """g'(t) of a layer in closed form, if it is a polynomial and the form does not cancel."""
        form = closed(layer)
        if form is None:
            return None
        fields = ("t",) if layer.start == 0 else ("t", "root")
        doc = "Rate g'(t) of the indentation depth" + (f", what begins at {layer.start}." if layer.start != 0 else ".")
        lines = self.functions.steps(form, fields)
        lines.append(f"return {self.functions.value_lines(form.value, lines)}")
        return self.functions.add(f"growth_{index}", fields, lines, doc)

    def _bend(self, index: int, layer: Layer) -> Function:
        if layer.start == 0:
            return self.functions.add(f"bend_{index}", ("r",), [f"return {text(layer.bend)}"], "(r f')'.")
        bend, doc = beyond(layer.bend, layer.start), f"(r f')' of what begins at {layer.start}."
        return self.functions.add(f"bend_{index}", ("excess",), [f"return {text(bend)}"], doc)

    def _whole(self, weight: str) -> list[str]:
        """Lines that add up the integrals over the pieces; `weight` in x and z."""
        starts = [sp.S.Zero, *self.profile.breaks]
        found: list[tuple[str, str]] = []
        for low, high, steep in zip(starts, [*map(str, starts[1:]), "np.inf"], self.steep, strict=True):
            if steep is not None:
                factor = "" if weight == "1.0" else f" * {weight}"
                place = "x" if low == 0 else "excess"
                limits = f"a, {radius_text(low)}, {high}{reach(self.layers, low)}"
                found.append((f"lambda x, z, excess, within: {steep.call(place)}{factor}", limits))
        lines: list[str] = []
        for integrand, limits in found:
            before = "whole = whole + " if lines else "whole = "
            line = f"{before}over_profile({integrand}, {limits})"
            split = [f"{before}over_profile(", f"    {integrand},", f"    {limits},", ")"]
            lines += [line] if len(line) <= LINE else split
        return lines

    def _over(self, name: str, weight: str, scale: str) -> None:
        lines = self._whole(weight)
        lines.append(f"return {self._reached(f'{scale} * whole')}")
        self.functions.add(name, ("a",), lines)

    def _reached(self, value: str) -> str:
        return f"np.where(a >= {self.start}, {value}, np.nan)" if self.start is not None else value

    def _pressure(self) -> None:
        lines, value = [], "E_star / np.pi * pressed"
        for i, (layer, growth, bend) in enumerate(zip(self.layers, self.growths, self.bends, strict=True)):
            if growth and layer.start == 0:
                rule = f"pressure_integral({growth.growth('t')}, r, a, {COUNT})"
            elif growth:
                rule = f"pressure_integral_beyond({growth.with_parameters()}, r, a, {layer.start})"
            else:
                assert bend is not None
                limits = f"{radius_text(layer.start)}, {text(layer.kink)}{reach(self.layers, layer.start)}"
                rule = f"pressure_over_profile({bend.growth(*bend.fields)}, r, a, {limits})"
            lines.append(f"pressed = {'pressed + ' if i else ''}{rule}")
        for layer in self.layers:
            if layer.kink != 0:
                at = f"(r == {layer.start}) & (a > {layer.start})"
                lines.append(f"pressed = np.where({at}, np.inf, pressed)")
        lines.append(f"return {self._reached(f'np.where(r < a, {value}, 0.0)')}")
        self.functions.add("pressure", ("r", "a"), lines)

    def _displacement(self) -> None:
        depth, profile = self.functions["depth"], self.functions["profile"]
        lines = ["root = difference_root(r, a)", "angle = np.arctan2(a, root)"]
        lines += self._whole("(a * angle - z * np.arctan2(z, root))")
        lines += ["outside = 2 / np.pi * whole", f"inside = {depth.call()} - {profile.call()}"]
        lines.append(f"return {self._reached('np.where(r > a, outside, inside)')}")
        self.functions.add("displacement", ("r", "a"), lines)

    def _slope_at(self) -> Function:
        lines = []
        for i, (layer, growth, bend) in enumerate(zip(self.layers, self.growths, self.bends, strict=True)):
            before = "rate + " if i else ""
            if growth and layer.start == 0:
                lines.append(f"rate = {before}{growth.call('a')}")
                continue
            if growth or layer.kink != 0:
                lines.append(f"root_{i} = difference_root(a, {layer.start})")
            if growth:
                value = growth.call("a", f"root_{i}")
            else:
                assert bend is not None
                place = "x" if layer.start == 0 else "excess"
                limits = f"a, {radius_text(layer.start)}, np.inf{reach(self.layers, layer.start)}"
                value = f"over_profile(lambda x, z, excess, within: {bend.call(place)}, {limits})"
                value += f" + {text(layer.start * layer.kink)} / root_{i}" if layer.kink != 0 else ""
            value = value if layer.start == 0 else f"np.where(a > {layer.start}, {value}, 0.0)"
            lines.append(f"rate = {before}{value}")
        return self.functions.add("slope_at", ("a",), [*lines, "return rate"], "Rate g'(a) of the indentation depth.")

    def _inverse(self, field: str, curve: str, rate: Function, exponent: float) -> None:
        target = self.functions[curve]
        scale = "2 * E_star * a * " if curve == "force" else ""
        if self.start is not None:
            place, step, start = (
                f"{self.start} * np.sqrt(1.0 + t * t)",
                f"(a - {self.start}) * (a + {self.start}) / a",
                "1.0",
            )
        else:
            place, step, start = "t", "a", self._length()
        largest, found = "", place
        if self.end and self.start is None:
            start, largest = f"0.5 * {self.end}", f", {self.end}"
        if self.reach is not None:
            far = math.sqrt((self.reach / self.floor) ** 2 - 1.0) if self.floor else self.reach
            start, largest = repr(0.5 * far), f", {far!r}"
            found = f"np.where({target.call(repr(self.reach))} >= {field}, {place}, np.nan)"
        lines = [
            "def curve(t: Array) -> tuple[Array, Array]:",
            f"    a = {place}",
            f"    value = {target.call('a')}",
            f"    return value, {scale}{step} * {rate.call('a')} / value",
            "",
            f"t = inverse(curve, {field}, np.full_like({field}, {start}), ({exponent!r}, np.inf){largest})",
            f"return {found}",
        ]
        radius = self.functions.add(f"radius_from_{curve}", (field,), lines)
        other = "depth" if curve == "force" else "force"
        name = "force_from_depth" if curve == "depth" else "depth_from_force"
        outer = self.functions[other]
        self.functions.add(name, (field,), [f"a = {radius.call()}", *changed(field, outer, target, "a")])

    def _length(self) -> str:
        """A length of the profile as first guess."""
        from ... import notation as nt

        lengths = [p.name for p in self.profile.parameters if nt.describe(p).dimension == nt.LENGTH]
        return lengths[0] if lengths else "1.0"
