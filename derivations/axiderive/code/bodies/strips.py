"""Bodies of the functions of strips: of contacts that grow, and with fixed edges, level or tilted.

Where the contact grows they are closed where that is stable, else integrals over strips; a punch is the strip over the
whole width and its concave face, the eccentric one before and after one edge has lifted off.

A closed form is chosen by region, with the names of its roots kept apart; bounds of the logarithmic slope of the load,
from the exact formula, are what makes Newton's bracket sure.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache

import mpmath as mp
import sympy as sp

from ...abel.masters import IncompleteBeta
from ...entry import Case, Entry
from ...notation import E_star, L, P, a, e, n, r, x, x_zero
from ...oracle.evaluate import of_one_variable
from ...physics.plane import PRESSURE, SURFACE
from ...stable.forms import EvaluationForm, evaluation_form, plane_form
from ...stable.opaque import PowerPunches, PowerStrips, Root, named
from ...stable.signs import facts_of
from ...stable.slopes import slope_form
from ...stable.variants import FULL, Variant
from ..function import Function
from ..private import PrivateFunctions
from ..text import printable, python
from .complete import threshold


@dataclass(frozen=True)
class Region:
    """A closed form and the comparisons low < high that single it out."""

    comparisons: tuple[tuple[sp.Expr, sp.Expr], ...]
    form: EvaluationForm


def regions(entry: Entry, variant: Variant = FULL) -> tuple[Region, ...]:
    """The distinct formulas of an entry as evaluation forms; those that are roots of an equation are not asked for."""
    first = {case.expr: case for case in reversed(entry.cases)}
    return tuple(Region(comparisons, form_of(first[expr], variant)) for comparisons, expr in entry.regions())


def form_of(case: Case, variant: Variant = FULL) -> EvaluationForm:
    """The evaluation form of a case in a variant; by all rules where NumPy lacks a function of that."""
    form = _form_of(case, variant)
    return form if printable(form) else _form_of(case, FULL)


def _form_of(case: Case, variant: Variant) -> EvaluationForm:
    """Incomplete Beta functions as integrals over the growing contact."""
    lengths = case.chain if all(length.is_Symbol for length in case.chain) else ()
    point = L if case.expr.has(L) else x
    if not case.expr.has(IncompleteBeta):
        return plane_form(case.expr, facts_of(lengths), variant)
    in_r = case.expr.subs(point, r)
    facts = facts_of(tuple(r if length == point else length for length in lengths))
    form = plane_form(in_r, facts, variant)
    steps = tuple((name, strips(expr).subs(r, point)) for name, expr in form.steps)
    return EvaluationForm(steps, strips(form.value).subs(r, point), form.cancels)


def strips(expr: sp.Expr) -> sp.Expr:
    """Integrals of t^(n-1) through the function that stays exact for small n."""
    expr = expr.subs(PowerPunches(r, a, n - 1), a / n * PowerStrips(r, a, n))
    return sp.factor_terms(sp.Add(*(sp.powsimp(term) for term in sp.Add.make_args(sp.expand(expr)))))


def moved(form: EvaluationForm, old: sp.Symbol, new: str) -> EvaluationForm:
    """The form at another value of a length."""
    symbol = sp.Symbol(new, positive=True)
    steps = tuple((name, expr.subs(old, symbol)) for name, expr in form.steps)
    return EvaluationForm(steps, form.value.subs(old, symbol), form.cancels)


def told_apart(forms: tuple[EvaluationForm, ...]) -> tuple[EvaluationForm, ...]:
    """The forms with a root of the same name but another meaning named after its lengths."""
    taken: dict[sp.Symbol, sp.Expr] = {}
    out = []
    for form in forms:
        renamed = {
            name: named("root_" + "".join(map(str, expr.args)))
            for name, expr in form.steps
            if isinstance(expr, Root) and taken.setdefault(name, expr) != expr
        }
        steps = tuple((renamed.get(name, name), expr.subs(renamed)) for name, expr in form.steps)
        out.append(EvaluationForm(steps, form.value.subs(renamed), form.cancels))
    return tuple(out)


def lines_of(functions: PrivateFunctions, name: str, form: EvaluationForm, lines: list[str]) -> None:
    """Append the steps that are not there yet, and `name = value`."""
    for line in functions.steps(form):
        if line not in lines:
            lines.append(line)
    lines.append(f"{name} = {functions.value_lines(form.value, lines)}")


DECADES = range(-24, 25)


@cache
def exponents(entry: Entry) -> tuple[str, str]:
    """Whole numbers between which d ln P/d ln t lies; a = t, and a = b sqrt(1 + t^2) over a flat face of half-width b.

    The parameters of the sketch stand for all: P is a length scale times a function of a/b.
    """
    values = {symbol: sp.Rational(str(value)) for symbol, value in entry.profile.sketch.values} | {E_star: sp.S.One}
    (b,) = entry.profile.breaks
    t = sp.Dummy("t", positive=True)
    half_width = b * sp.sqrt(1 + t**2) if entry.profile.truncated else t * b
    slopes = []
    with mp.workdps(60):
        for case in entry.cases:
            load = case.expr.subs(a, half_width)
            slope = of_one_variable(t * sp.diff(load, t) / load, t, values)
            for k in DECADES:
                point = mp.mpf(10) ** (mp.mpf(k) / 4)
                if entry.profile.truncated or (point < 1 if case.below(a, b) else point > 1):
                    slopes.append(mp.re(slope(point)))
    return f"{math.floor(min(slopes) + mp.mpf('1e-6'))}.0", f"{math.ceil(max(slopes) - mp.mpf('1e-6'))}.0"


@dataclass
class Compact:
    """The private functions behind the entries of one profile; lengths of the contact are a, and `inner` up to b."""

    entries: Mapping[str, Entry]
    functions: PrivateFunctions

    def __post_init__(self) -> None:
        self.profile = self.functions.profile
        self.b = self.profile.breaks[0] if self.profile.breaks else None

    def add_all(self) -> None:
        """Adds the private functions of profile, growth, load, pressure, slope, depth and half-width."""
        add_profile(self.functions)
        self._growths()
        self._load()
        self._pressure()
        self._slope()
        self._depth()
        self._half_width()

    def tip(self, suffix: str) -> Case | None:
        """The case of a contact that ends below the break, if there are such contacts."""
        cases = [c for c in self.entries[suffix].cases if self.b is None or c.below(a, self.b)]
        return cases[0] if cases else None

    def _growths(self) -> None:
        """P'(t)/E_star below and beyond the break."""
        if self.b is None:
            return
        for case in self.entries["P"].cases:
            beyond = case.below(self.b, a)
            variant = self.functions.rate_variant(self.entries["P"])
            form = slope_form(case.expr / E_star, facts_of(case.chain), variant)
            form = form if printable(form) else slope_form(case.expr / E_star, facts_of(case.chain))
            fields = ("t", "root") if beyond else ("t",)
            lines = self.functions.steps(form, fields)
            lines.append(f"return {python(form.value)}")
            doc = "Growth P'(t)/E_star of the line load" + (f" for t > {self.b}." if beyond else ".")
            name = "growth_beyond" if beyond else "growth"
            self.functions.add(name, fields, lines, doc)

    def _closed(self, suffix: str) -> list[str] | None:
        """Lines that end with `value = ...`, or None where a region loses digits or there are more than two."""
        own = regions(self.entries[suffix], self.functions.variant(self.entries[suffix]))
        if len(own) > 2 or any(region.form.cancels for region in own):
            return None
        forms = told_apart(tuple(region.form for region in own))
        lines: list[str] = []
        names = ("value",) if len(forms) == 1 else ("below", "above")
        for name, form in zip(names, forms, strict=True):
            lines_of(self.functions, name, form, lines)
        if len(forms) > 1:
            ((low, high),) = own[0].comparisons
            lines.append(f"value = np.where({low} < {high}, below, above)")
        return lines

    def _superposed(self, suffix: str, rule: str, scale: sp.Expr, field: str) -> list[str]:
        """The tip in closed form, and the strips beyond the break by a rule."""
        growth = self.functions["growth_beyond"]
        lines, parts = list[str](), list[str]()
        tip = self.tip(suffix)
        if tip is not None:
            form = moved(form_of(tip, self.functions.variant(self.entries[suffix])), a, "inner")
            lines.append(f"inner = np.minimum(a, {self.b})")
            lines_of(self.functions, "tip", form, lines)
            parts.append(f"np.where({field} < inner, tip, 0.0)" if suffix == "p" else "tip")
        lines.append(f"beyond = {rule}({growth.with_parameters()}, {field}, a, {self.b})")
        sign, size = ("-", -scale) if scale.could_extract_minus_sign() else ("", scale)
        added = f"{python(size)} * beyond"
        value = f"{parts[0]} {sign or '+'} {added}" if parts else f"{sign}{added}"
        return [*lines, f"value = {value}"]

    def _add(self, suffix: str, lines: list[str]) -> Function:
        *before, value, last = ["", *lines]
        if value.startswith("value = ") and last == "return value":
            lines = [*before[1:], value.replace("value =", "return", 1)]
        return self.functions.of_entry(self.entries[suffix], lines)

    def _load(self) -> None:
        closed = self._closed("P")
        if closed is None or self.profile.truncated and self.entries["aP"].status == "root":
            growth, b = self.functions["growth_beyond"], str(self.b)
            lines = [f"return E_star * load_beyond({growth.with_parameters()}, root, {b})"]
            doc = f"Line load at a = sqrt({b}**2 + root**2)."
            inner = self.functions.add("load_at", ("root",), lines, doc)
            closed = closed or [f"root = np.sqrt((a - {b}) * (a + {b}))", f"value = {inner.call('root')}"]
        self._add("P", [*closed, "return value"])

    def _within(self, lines: list[str], value: str) -> list[str]:
        """NaN for a contact smaller than the flat face."""
        if not self.profile.truncated:
            return [*lines, f"return {value}"]
        return [*lines, f"return np.where(a >= {self.b}, {value}, np.nan)"]

    def _pressure(self) -> None:
        found = self._closed("p") or self._superposed("p", "pressure_integral_beyond", PRESSURE * E_star, "x")
        self._add("p", self._within(found, "np.where(x < a, value, 0.0)"))

    def _slope(self) -> None:
        lines = self._closed("s") or self._superposed("s", "slope_beyond", -SURFACE, "x")
        inside = self.functions["profile_slope"]
        value = f"np.where(x > a, value, -{inside.call()})"
        self._add("s", self._within(lines, value))

    def _depth(self) -> None:
        closed = self._closed("d")
        lines = closed or self._superposed("d", "depth_beyond", SURFACE, "L")
        if closed is None:
            height = self.functions["profile"]
            lines.append(f"value = np.where(a < L, value, {height.call('a')})")
        if not self.profile.truncated:
            lines.append("value = np.where(a > 0.0, value, 0.0)")
        value = "np.where(a <= L, value, np.nan)"
        self._add("d", self._within(lines, value))

    def _half_width(self) -> None:
        entry = self.entries["aP"]
        if entry.status == "closed":
            form = self.functions.form(entry, entry.cases[0].expr, facts_of(()))
            self._add("aP", self.functions.returned(form))
            return
        beyond = self.functions["growth_beyond"]
        low, high = exponents(self.entries["P"])
        b = str(self.b)
        if self.profile.truncated:
            load = self.functions["load_at"]
            body = [
                "def curve(t: Array) -> tuple[Array, Array]:",
                f"    a, root = {b} * np.sqrt(1.0 + t * t), {b} * t",
                f"    value = {load.call('root')}",
                f"    return value, E_star * root * root / a * {beyond.call('a', 'root')} / value",
                "",
                f"t = inverse(curve, P, np.ones_like(P), ({low}, {high}))",
                f"return {b} * np.sqrt(1.0 + t * t)",
            ]
        else:
            load, tip = self.functions["load"], self.functions["growth"]
            body = [
                "def curve(a: Array) -> tuple[Array, Array]:",
                f"    root = np.sqrt((a - {b}) * (a + {b}))",
                f"    growth = np.where(a < {b}, {tip.call('a')}, {beyond.call('a', 'root')})",
                f"    value = {load.call('a')}",
                "    return value, E_star * a * growth / value",
                "",
                f"return inverse(curve, P, np.full_like(P, 0.99 * {b}), ({low}, {high}))",
            ]
        self._add("aP", body)


def add_profile(functions: PrivateFunctions) -> None:
    """The profile and its slope, piece by piece."""
    pieces = functions.profile.pieces
    for name, doc in (("profile", ""), ("profile_slope", "Slope f'(x) of the profile.")):
        values, lines = list[str](), list[str]()
        for piece in pieces:
            expr = sp.expand_power_base(piece.expr)
            if name == "profile_slope":
                expr = sp.powsimp(sp.diff(expr, x))
            elif piece.expr.has(sp.Add):
                expr = piece.expr
            form = evaluation_form(expr, facts_of(()))
            lines += [line for line in functions.steps(form) if line not in lines]
            values.append(python(form.value) if form.value != 0 else "0.0")
        text = values[-1]
        for piece, value in reversed(list(zip(pieces, values, strict=True))[:-1]):
            text = f"np.where(x > {piece.upper}, {text}, {value})"
        if "x" not in text:
            text = "np.zeros_like(x)" if text == "0.0" else f"{text} * np.ones_like(x)"
        if functions.profile.complete and name == "profile":
            text = f"np.where(x <= a, {text}, np.nan)"
        functions.add(name, ("x",), [*lines, f"return {text}"], doc)


@dataclass
class Complete:
    """The private functions behind the entries of one profile in complete contact."""

    entries: Mapping[str, Entry]
    functions: PrivateFunctions

    def __post_init__(self) -> None:
        self.concave = "Pmin" in self.entries

    def add_all(self) -> None:
        """Adds the private functions of profile, pressure, slope and depth, and of the least load if concave."""
        add_profile(self.functions)
        if self.concave:
            self._zero_distance()
            self._minimum_load()
        self._pressure()
        self._slope()
        self._depth()

    def _add(self, suffix: str, lines: list[str], value: str) -> Function:
        """NaN where the contact is not complete."""
        if self.concave and suffix in ("p", "s", "d"):
            least = self.functions["minimum_load"]
            # at the least load itself, which a caller computes, the contact is complete
            lines.append(f"complete = {least.call()} * (1.0 - 1e-15) <= P")
            lines.append(f"result = {value}")
            value = "np.where(complete, result, np.nan)"
        return self.functions.of_entry(self.entries[suffix], [*lines, f"return {value}"])

    def _parts(self, suffix: str) -> list[str]:
        """Lines that end with `value = ...`: what the load does, and what the face does.

        The second part of the slope is opposed to the first by a bounded factor at
        most, since P >= P_min; depth and pressure do change their signs.
        """
        lines: list[str] = []
        entry = self.entries[suffix]
        exprs, forms = parts(entry, self.concave, self.functions.variant(entry))
        for name, form in zip(exprs, forms, strict=True):
            if name == "face" and form.value.could_extract_minus_sign():
                form = type(form)(form.steps, -form.value, form.cancels)  # noqa: PLW2901
                lines_of(self.functions, "face", form, lines)
                lines.append("value = strip - face")
            else:
                lines_of(self.functions, name, form, lines)
                lines += ["value = strip + face"] if name == "face" else []
        return lines

    def _zero_distance(self) -> None:
        entry = self.entries["xz"]
        place = "a * ring_of_zero_pressure(n)" if entry.status == "root" else python(entry.cases[0].expr)
        self._add("xz", [], "0.0 * a" if place == "0" else place)

    def _minimum_load(self) -> None:
        place, form = threshold(self.functions, self.entries["Pmin"], x_zero)
        self._add("Pmin", [*self.functions.steps(form), *place], python(form.value))

    def _pressure(self) -> None:
        excess = excess_over_threshold(self.entries) if self.concave else None
        if excess is None:
            lines = self._parts("p")
        else:
            least = self.functions["minimum_load"]
            lines = ["root = np.sqrt((a - x) * (a + x))", f"face = {python(excess)}"]
            carried = named("carried")
            lines.append(f"carried = P - {least.call()} + face")
            lines.append(f"value = {python(PRESSURE * carried / named('root'))}")
        self._add("p", lines, "np.where((x <= a) & (P > 0.0), value, 0.0)")

    def _slope(self) -> None:
        lines = self._parts("s")
        inside = self.functions["profile_slope"]
        slope = f"-{inside.call()}" if self.concave else "0.0"
        # infinite at the edge itself
        lines.append("outside = np.where(P > 0.0, value, 0.0)")
        self._add("s", lines, f"np.where(x >= a, outside, {slope})")

    def _depth(self) -> None:
        self._add("d", self._parts("d"), "np.where(a <= L, value, np.nan)")


def parts(entry: Entry, concave: bool, variant: Variant) -> tuple[tuple[str, ...], tuple[EvaluationForm, ...]]:
    """What the load does and what the face does, by name; one value without a hollow face."""
    case = entry.cases[0]
    whole = sp.expand(case.expr)
    load = whole.coeff(P) * P
    exprs = {"strip": load, "face": whole - load} if concave else {"value": case.expr}
    return tuple(exprs), told_apart(tuple(form_of(Case(case.chain, expr), variant) for expr in exprs.values()))


def excess_over_threshold(entries: Mapping[str, Entry]) -> sp.Expr | None:
    """M(x) >= 0 in p = (P - P_min + M)/(pi root), where the face is algebraic."""
    weighted = sp.expand(sp.expand(entries["p"].cases[0].expr * sp.sqrt(a**2 - x**2) / PRESSURE))
    face = sp.factor(sp.expand(weighted - P + entries["Pmin"].cases[0].expr))
    return face if face.is_polynomial(x) else None


SIDE, SHORT, NEAR, REACH, FAR, BEYOND, ALONG, END = (
    sp.Symbol(name, positive=True) for name in ("side", "short", "near", "reach", "far", "beyond", "along", "end")
)
LEAN = {"short": "a - np.abs(e)", "side": "np.copysign(1.0, e)"}
"""Distance of the load from its edge, and the side it leans to."""


def add_all(entries: Mapping[str, Entry], functions: PrivateFunctions) -> None:
    """`pressure`, `tilt` and `contact_width`; both regimes by exact distances from the edges."""
    _pressure(entries["p"], functions)
    for suffix in ("phi", "cw"):
        _by_regimes(entries[suffix], functions)


def _limit(entry: Entry) -> str:
    """The condition under which both edges touch."""
    low, high = entry.cases[0].chain
    return f"{python(low)} < {python(high)}"


def _lifted(expr: sp.Expr) -> sp.Expr:
    """In the distances of the point and of the load from the edge that the load leans to."""
    return _in_distances(expr, SIDE * (a - NEAR), a - SHORT)


def _in_distances(expr: sp.Expr, place: sp.Expr, eccentricity: sp.Expr) -> sp.Expr:
    expr = expr.subs(x, place).subs(sp.Abs(e), eccentricity).subs(sp.sign(e), SIDE)
    return expr.replace(lambda part: part.is_Add, lambda part: sp.expand(sp.expand(part).subs(SIDE**2, 1)))


def _pressure(entry: Entry, functions: PrivateFunctions) -> None:
    """The punch at x >= 0: the numerator linear in x between its values in the middle and at the edge.

    Both values are positive as long as both edges touch, so that nothing cancels.
    After lift-off a point is `reach` away from the end of the contact.  Next to that end both of the places that it
    is the difference of are exact: counted from the lifted edge up to half way to the middle, from the middle beyond.
    """
    touching, apart = (case.expr for case in entry.cases)
    numerator = sp.expand(touching * sp.pi * a**2 * sp.sqrt(a**2 - x**2) / P)
    middle, edge = numerator.subs(x, 0), numerator.subs(x, a)
    if sp.expand(numerator - middle - x * (edge - middle) / a) != 0:
        message = f"{entry.key}: the numerator {numerator} is not linear in x"
        raise ValueError(message)
    share = sp.factor(edge / a) * x + sp.factor(middle / a) * (a - x)
    (extent,) = apart.atoms(sp.Max)
    reach = sp.Add(*extent.args)
    from_lifted = _in_distances(reach, SIDE * (FAR - a), (a + BEYOND) / 2)
    from_middle = _in_distances(reach, SIDE * ALONG, (3 * a + END) / 4)
    pressed = _lifted(apart.subs(extent, REACH))
    lines = [
        "root = np.sqrt((a - x) * (a + x))",
        f"touching = P * ({python(share)}) / (np.pi * a**2 * root)",
        f"short, side = {LEAN['short']}, {LEAN['side']}",
        "beyond, along = 2 * np.abs(e) - a, side * x",
        "near, far, end = a - along, a + along, 2 * beyond - a",
        f"reach = np.maximum(np.where(end < -a / 2, {python(from_lifted)}, {python(from_middle)}), 0.0)",
        f"apart = {python(pressed)}",
        f"pressed = np.where({_limit(entry)}, touching, apart)",
        "return np.where((x <= a) & (P > 0.0), pressed, 0.0)",
    ]
    functions.of_entry(entry, lines, "Pressure for x >= 0 under a load on either side.")


def _by_regimes(entry: Entry, functions: PrivateFunctions) -> None:
    touching, apart = (case.expr for case in entry.cases)
    lifted = sp.factor(_lifted(apart))
    lines = [f"{symbol} = {LEAN[symbol.name]}" for symbol in (SHORT, SIDE) if lifted.has(symbol)]
    lines.append(f"return np.where({_limit(entry)}, {python(touching)}, {python(lifted)})")
    functions.of_entry(entry, lines)
