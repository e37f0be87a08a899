"""Bodies of the inverse functions: closed where stable, else Newton's iteration in a variable of bounded slope."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass

import mpmath as mp
import sympy as sp

from ..contact.medium import HOMOGENEOUS
from ..entry import Entry
from ..notation import a
from ..stable.forms import EvaluationForm, evaluation_form
from ..stable.signs import facts_of
from .code import python
from .compact import Compact
from .example import NUMERIC
from .private import Private

TARGET = {"ad": ("depth", "d"), "aF": ("force", "F")}


@dataclass
class Inverses:
    """The private functions behind the inverse entries of one compact profile."""

    compact: Compact

    def __post_init__(self) -> None:
        self.functions = self.compact.functions
        self.profile = self.compact.profile

    def add_all(self) -> dict[str, Private]:
        """Functions of `ad`, `aF`, `Fd`, `dF`."""
        radius = {suffix: self._radius(suffix) for suffix in ("ad", "aF")}
        return radius | {"Fd": self._through("Fd", "force", "ad"), "dF": self._through("dF", "depth", "aF")}

    def _closed(self, entry: Entry) -> EvaluationForm | None:
        """The closed form if there is one regime, nothing cancels and no large angle is raised to an exponential.

        sinh(asinh(x)/3) loses ln(x)/3 units of the last place: 221 at a force of 1e183.
        """
        if entry.status != "closed" or len(entry.cases) != 1:
            return None
        form = evaluation_form(entry.cases[0].expr, facts_of(entry.cases[0].chain, *self.compact.rules()))
        raised = any(expr.has(sp.sinh, sp.cosh) for expr in (form.value, *(expr for _, expr in form.steps)))
        return None if form.cancels or raised else form

    def _radius(self, suffix: str) -> Private:
        entry, (_, field) = self.compact.entries[suffix], TARGET[suffix]
        form = self._closed(entry)
        name = entry.quantity.function
        if form is not None:
            lines = self.functions.returned(form)
            return self.functions.add(name, (field,), lines, self.functions.needs(form, (field,)))
        if self.compact.rooted:
            contact = self._contact(suffix)
            return self.functions.add(name, (field,), [f"return {contact.call()}[0]"], contact.needs)
        return self._newton(suffix, name)

    def _through(self, suffix: str, outer: str, inner: str) -> Private:
        """F(a(d)) or d(a(F)), closed or as that composition."""
        entry, (_, field) = self.compact.entries[suffix], TARGET[inner]
        name = entry.quantity.function
        form = self._closed(entry) if entry.composed is None else None
        if form is not None:
            lines = self.functions.returned(form)
            return self.functions.add(name, (field,), lines, self.functions.needs(form, (field,)))
        if self.compact.rooted:
            contact = self.functions.functions.get(f"contact_from_{TARGET[inner][0]}") or self._contact(inner)
            target, curve = (self.functions.functions[f"{part}_at"] for part in (outer, TARGET[inner][0]))
            lines = [f"a, root = {contact.call()}", *self._changed(field, target, curve, "a", "root")]
            return self.functions.add(name, (field,), lines, {*contact.needs, *target.needs, *curve.needs, "E_star"})
        radius = self.functions.functions[self.compact.entries[inner].quantity.function]
        target = self.functions.functions[outer]
        if not any("inverse" in line for line in radius.lines):
            lines = [f"return {target.call(radius.call())}"]
            return self.functions.add(name, (field,), lines, {*radius.needs, *target.needs})
        return self._corrected(name, field, target, radius, self.functions.functions[TARGET[inner][0]])

    def _corrected(self, name: str, field: str, target: Private, radius: Private, curve: Private) -> Private:
        """The radius is rounded, and says too little next to a break; dF/dd = 2 E* a makes good what it lost."""
        lines = [f"a = {radius.call()}", *self._changed(field, target, curve, "a")]
        return self.functions.add(name, (field,), lines, {*radius.needs, *target.needs, *curve.needs, "E_star"})

    def _changed(self, field: str, target: Private, curve: Private, *given: str) -> list[str]:
        stiffness = python(HOMOGENEOUS.stiffness())
        missed = f"{field} - {curve.call(*given)}"
        change = f"{stiffness} * ({missed})" if field == "d" else f"({missed}) / ({stiffness})"
        return [
            f"change = np.where((a > 0.0) & (a < np.inf), {change}, 0.0)",
            f"return {target.call(*given)} + change",
        ]

    def _contact(self, suffix: str) -> Private:
        """Contact radius and its root together: near the end of the domain the radius alone says too little."""
        curve, field = TARGET[suffix]
        target = self.functions.functions[f"{curve}_at"]
        slope = self.compact.slopes["beyond" if self.profile.truncated else "tip"][0]
        if self.profile.truncated:
            b = str(self.compact.b)
            place = f"{b} * np.sqrt(1.0 + t * t), {b} * t"
            rate = f"root * root / a * {slope.call('a', 'root')}"
            needs = {b}
        else:
            R = str(self.compact.scale("tip")[1])
            place = f"{R} * np.tanh(t), {R} / np.cosh(t)"
            rate = f"t * root * root / {R} * {slope.call('a', 'root')}"
            needs = {R}
        if suffix == "aF":
            rate = f"{python(HOMOGENEOUS.stiffness())} * {rate}"
        lines = [
            "def curve(t: Array) -> tuple[Array, Array]:",
            f"    a, root = {place}",
            f"    value = {target.call('a', 'root')}",
            f"    return value, {rate} / value",
            "",
            f"t = inverse(curve, {field}, np.ones_like({field}), {self._exponents(suffix)})",
            f"return {place}",
        ]
        doc = "Contact radius a and its root" + (
            f" sqrt(a**2 - {b}**2)." if self.profile.truncated else f" sqrt({R}**2 - a**2)."
        )
        needs |= {*target.needs, *slope.needs}
        return self.functions.add(f"contact_from_{curve}", (field,), lines, needs, doc)

    def _newton(self, suffix: str, name: str) -> Private:
        curve, field = TARGET[suffix]
        target = self.functions.functions[curve]
        slope_text, needs = self._slope_of_radius()
        rate = f"a * {slope_text}"
        if suffix == "aF":
            rate = f"{python(HOMOGENEOUS.stiffness())} * {rate}"
            needs = needs | {"E_star"}
        largest = self.profile.largest
        start = f"np.full_like({field}, {self._start()})"
        options = "" if largest is None else ", largest"
        lines = [
            "def curve(a: Array) -> tuple[Array, Array]:",
            f"    value = {target.call('a')}",
            f"    return value, {rate} / value",
            "",
        ]
        call = f"inverse(curve, {field}, {start}, {self._exponents(suffix)}{options})"
        if self._bends_freely():
            lines.append(f"return inverse_across(curve, {field}, {self.compact.b}, {self._exponents(suffix)})")
            needs = needs | {str(self.compact.b)}
        elif largest is None:
            lines.append(f"return {call}")
        else:
            needs = needs | {str(s) for s in largest.free_symbols}
            lines.append(f"largest = {python(largest)} * np.ones_like({field})")
            lines.append(f"a = {call}")
            # the largest depth and the argument are both rounded
            lines.append(f"return np.where({target.call('largest')} * {1 + 2**-50!r} >= {field}, a, np.nan)")
        return self.functions.add(name, (field,), lines, needs | set(target.needs) | self._start_needs())

    def _bends_freely(self) -> bool:
        """Whether g' has a parameter of its own beyond the break, so that it may outgrow the tip at will."""
        if set(self.compact.slopes) != {"tip", "beyond"}:
            return False
        tip, beyond = (self.compact.slopes[key][1].needs() for key in ("tip", "beyond"))
        return bool({str(symbol) for symbol in beyond - tip} - {"t", "root", str(self.compact.b)})

    def _start(self) -> str:
        """A length of the profile, small against the largest contact radius."""
        if self.compact.summed:
            return "1.0"
        lengths = [p for p in self.profile.parameters if p.name in ("b", "s", "wavelength")]
        return (
            f"{lengths[-1]} / 1000.0"
            if lengths and self.compact.b is None
            else "1.0"
            if not lengths
            else str(lengths[0])
        )

    def _start_needs(self) -> set[str]:
        return set(re.findall(r"[A-Za-z]\w*", self._start()))

    def _slope_of_radius(self) -> tuple[str, set[str]]:
        """Text of g'(a) in all regimes."""
        if self.compact.summed:
            depth = self.functions.functions["slope"]
            return depth.call("a"), set(depth.needs)
        tip = self.compact.slopes.get("tip")
        if self.compact.b is None:
            assert tip is not None
            return tip[0].call("a"), set(tip[0].needs)
        beyond = self.compact.slopes["beyond"][0]
        slope = self._joined_slope(tip[0] if tip else None, beyond)
        return slope.call("a"), set(slope.needs)

    def _joined_slope(self, tip: Private | None, beyond: Private) -> Private:
        known = self.functions.functions.get("slope_at")
        if known:
            return known
        assert tip is not None
        b = str(self.compact.b)
        root = "np.sqrt((R - a) * (R + a))" if len(tip.fields) == 2 else ""
        inner = tip.call("a", root) if root else tip.call("a")
        lines = [
            f"root = np.sqrt((a - {b}) * (a + {b}))",
            f"return np.where(a < {b}, {inner}, {beyond.call('a', 'root')})",
        ]
        doc = "Rate g'(a) of the indentation depth on both sides of the break."
        return self.functions.add(
            "slope_at", ("a",), lines, {*tip.needs, *beyond.needs, b} | ({"R"} if root else set()), doc
        )

    def _exponents(self, suffix: str) -> str:
        """Whole numbers between which d ln value/d ln t lies, from the exact formula over twelve decades."""
        low, high = exponents(self.compact, suffix)
        return f"({low}, {high})"


def exponents(compact: Compact, suffix: str) -> tuple[str, str]:
    if compact.summed:
        return ("1.0", "len(A)") if suffix == "ad" else ("2.0", "len(A) + 1.0")
    quantity = "d" if suffix == "ad" else "F"
    values = {symbol: sp.Float(str(value), 60) for symbol, value in compact.profile.sketch.values}
    values[sp.Symbol("E_star", positive=True)] = sp.Float(1, 60)
    slopes = [
        s
        for k in range(-24, 25)
        if (s := _slope_at(compact, quantity, mp.mpf(10) ** (mp.mpf(k) / 4), values)) is not None
    ]
    if compact.scale("tip")[0] == "waves":
        # where the waves are steepest g' touches zero, and it never exceeds twice the slope of the paraboloid
        return "0.0", f"{math.ceil(max(slopes)) + 3}.0"
    low, high = min(slopes), max(slopes)
    if compact.b is not None and not compact.profile.truncated:
        # beyond the break the depth may rise as steeply as the parameters let it
        return f"{math.floor(low + 1e-6)}.0", "np.inf"
    if compact.profile.largest is not None:
        low = 0.0
    return f"{math.floor(low + 1e-6)}.0", f"{math.ceil(high - 1e-6)}.0"


def _slope_at(compact: Compact, quantity: str, t: mp.mpf, values: dict[sp.Symbol, sp.Expr]) -> float | None:
    """d ln value/d ln t by a central difference at 60 digits."""
    profile, regimes = compact.profile, compact.regimes(quantity)
    short = {symbol: expr.subs(values) for symbol, expr in profile.abbreviations}
    known = values | {symbol: sp.N(expr, 60) for symbol, expr in short.items()}

    curves = {
        key: sp.lambdify(a, case.expr.subs({s: v for s, v in known.items()}), NUMERIC) for key, case in regimes.items()
    }

    def log_value(t: mp.mpf) -> mp.mpf | None:
        kind, length = compact.scale("tip")
        if profile.truncated:
            radius = mp.mpf(str(known[compact.b])) * mp.sqrt(1 + t * t)
        elif kind == "tanh" and compact.b is None:
            radius = mp.mpf(str(known[length])) * mp.tanh(t)
        else:
            radius = t
        if profile.largest is not None and radius > mp.mpf(str(sp.N(profile.largest.subs(known), 60))):
            return None
        key = "tip" if compact.b is None or ("tip" in regimes and radius < mp.mpf(str(known[compact.b]))) else "beyond"
        value = curves[key](radius)
        return mp.log(value) if value > 0 else None

    with mp.workdps(60):
        step = mp.mpf(10) ** -12
        low, high = log_value(t * (1 - step)), log_value(t * (1 + step))
        return None if low is None or high is None else float((high - low) / (2 * step))
