"""Bodies of the functions of a compact contact: closed where that is stable, else the regular rules and roots."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import sympy as sp

from ..abel import masters
from ..contact.medium import HOMOGENEOUS
from ..entry import Case, Entry
from ..notation import a
from ..profiles.profile import Profile
from ..stable.forms import EvaluationForm, evaluation_form
from ..stable.gaps import of_lengths
from ..stable.opaque import ArcStrips, Arctan2, ArctanGap, Root, SineRoot
from ..stable.signs import Facts, facts_of
from ..stable.slopes import ROOT, singular_at_break, slope_form
from .code import python
from .kernels import EXPONENTS
from .private import Private, PrivateFunctions, through_sine, without_subtraction

SMOOTH = 32


@dataclass
class Compact:
    """The private functions behind the entries of one compact profile."""

    entries: Mapping[str, Entry]
    functions: PrivateFunctions

    def __post_init__(self) -> None:
        self.profile = self.entries["d"].profile
        self.summed = self.entries["d"].cases[0].expr.has(sp.Sum)
        self.b = self.profile.breaks[0] if self.profile.breaks else None
        depth = self.regimes("d")
        self.slopes = {key: self._slope(key, case) for key, case in depth.items()} if not self.summed else {}
        if self.summed:
            self._summed_slope(depth["tip"].expr)

    def rules(self) -> tuple[tuple[sp.Expr, sp.Expr], ...]:
        return tuple((rule.left, rule.right) for rule in self.profile.rules)

    def facts(self, case: Case) -> Facts:
        return facts_of(case.chain, *self.rules())

    def regimes(self, suffix: str) -> dict[str, Case]:
        """The case of each regime, `tip` for a < b, `beyond` for a > b; the whole contact is `tip` without a break."""
        found: dict[str, Case] = {}
        for case in self.entries[suffix].cases:
            key = "beyond" if self.b is not None and case.chain and case.below(self.b, a) else "tip"
            found.setdefault(key, case)
        return found

    def form(self, suffix: str, key: str) -> EvaluationForm:
        case = self.regimes(suffix)[key]
        return evaluation_form(case.expr, self.facts(case))

    @property
    def rooted(self) -> bool:
        """Whether depth and force are written in a and a root that vanishes at one end of the domain."""
        return self.profile.truncated or (self.b is None and self.scale("tip")[0] == "tanh")

    def scale(self, key: str) -> tuple[str, sp.Expr | None]:
        """Which substitution regularises g' of a regime, and its length."""
        if key == "beyond":
            return "beyond", self.b
        if "tip" not in self.slopes:
            return "", None
        form = self.slopes["tip"][1]
        for _, expr in form.steps:
            if isinstance(expr, Root):
                return "tanh", expr.args[0]
            if isinstance(expr, Arctan2):
                return "sinh", expr.args[1]
        return ("waves", None) if form.value.has(masters.StruveH) else ("", None)

    def _slope(self, key: str, case: Case) -> tuple[Private, EvaluationForm]:
        form = slope_form(case.expr, self.facts(case))
        rooted = any(str(name) == ROOT for name, _ in form.steps)
        fields = ("t", "root") if rooted or key == "beyond" else ("t",)
        lines = self.functions.steps(form, fields)
        text = self.functions.value_lines(form.value, lines)
        lines.append(f"return {text}")
        name = "slope_beyond" if key == "beyond" else "slope"
        doc = "Rate g'(t) of the indentation depth g(t)" + (f" for t > {self.b}." if key == "beyond" else ".")
        return self.functions.add(name, fields, lines, self.functions.needs(form, fields), doc), form

    def _summed_slope(self, depth: sp.Expr) -> None:
        """Term by term for a polynomial."""
        slope = depth.replace(
            lambda e: isinstance(e, sp.Sum), lambda e: sp.Sum(sp.powsimp(sp.diff(e.function, a)), *e.limits)
        )
        form = evaluation_form(slope, facts_of((a,)))
        self.functions.add(
            "slope", ("a",), [f"return {python(form.value)}"], {"A"}, "Rate g'(a) of the indentation depth."
        )

    def depth_like(self, suffix: str, name: str) -> Private:
        """Depth, force or mean pressure by their regimes."""
        regimes = self.regimes(suffix)
        forms = {key: self.form(suffix, key) for key in regimes}
        if suffix == "F" and any(form.cancels for form in forms.values()) and self.scale("tip")[0] != "waves":
            return self._force_by_rule(forms)
        if suffix == "pm" and not self._closed_mean(forms):
            force = self.functions.functions["force"]
            value = f"{force.call()} / (np.pi * a**2)"
            return self.functions.add(name, ("a",), [f"return np.where(a > 0.0, {value}, 0.0)"], force.needs)
        if len(forms) > 1 and suffix != "pm":
            self._beyond(name, forms["beyond"])
        if not self.rooted or suffix == "pm":
            return self._joined(name, {key: of_lengths(form) for key, form in forms.items()})
        inner = self._joined(name, forms, ("a", ROOT))
        if any(form.value.has(ArctanGap) for form in forms.values()):
            return self._joined(name, {key: of_lengths(form) for key, form in forms.items()})
        return self._from_radius(name, inner)

    def _joined(self, name: str, forms: dict[str, EvaluationForm], given: tuple[str, ...] = ("a",)) -> Private:
        """The regimes on either side of the break; with its root given, under a name of its own."""
        lines, needs = [], set()
        for key, form in forms.items():
            lines += self.functions.steps(form, given)
            needs |= self.functions.needs(form, given)
            value = self.functions.value_lines(form.value, lines)
            lines.append(f"{key} = {value}" if len(forms) > 1 else f"return {value}")
        if len(forms) > 1:
            lines.append(f"return np.where(a < {self.b}, tip, beyond)")
            needs.add(str(self.b))
        if ROOT in given:
            return self.functions.add(f"{name}_at", given, lines, needs)
        return self._limited(name, lines, needs)

    def _beyond(self, name: str, form: EvaluationForm) -> Private:
        """In the radius and its root, which says more of a radius next to the break: for the inverse."""
        lines = self.functions.steps(form, ("a", ROOT))
        value = self.functions.value_lines(form.value, lines)
        needs = self.functions.needs(form, ("a", ROOT))
        return self.functions.add(f"{name}_beyond", ("a", ROOT), [*lines, f"return {value}"], needs)

    def _from_radius(self, name: str, inner: Private) -> Private:
        x, y = self.root_pair()
        lines = [f"root = np.sqrt(({x} - {y}) * ({x} + {y}))", f"return {inner.call('a', 'root')}"]
        return self.functions.add(name, ("a",), lines, {*inner.needs, x, y} - {"a"})

    def root_pair(self) -> tuple[str, str]:
        return ("a", str(self.b)) if self.profile.truncated else (str(self.scale("tip")[1]), "a")

    def _limited(self, name: str, lines: list[str], needs: set[str]) -> Private:
        """NaN beyond the largest contact radius."""
        if self.profile.largest is not None:
            value = lines.pop().removeprefix("return ")
            lines.append(f"return np.where({self.domain()[0]}, {value}, np.nan)")
            needs = needs | self.domain()[1]
        return self.functions.add(name, ("a",), lines, needs)

    def domain(self) -> tuple[str, set[str]]:
        """The condition on the contact radius, and what it needs."""
        if self.profile.truncated:
            return f"a >= {self.b}", {str(self.b)}
        if self.profile.largest is not None:
            return f"a <= {python(self.profile.largest)}", {str(s) for s in self.profile.largest.free_symbols}
        kind, length = self.scale("tip")
        if kind == "tanh" and self.b is None:
            return f"a <= {length}", {str(length)}
        return "", set()

    def _closed_mean(self, forms: dict[str, EvaluationForm]) -> bool:
        """Closed, and without a division by a where a may vanish."""
        tip = forms.get("tip")
        if any(form.cancels for form in forms.values()):
            return False
        return tip is None or not sp.denom(sp.together(tip.value)).has(a) or not tip.value.has(sp.Add)

    def _force_by_rule(self, forms: dict[str, EvaluationForm]) -> Private:
        scale = python(HOMOGENEOUS.force_scale)
        if "tip" not in forms:
            message = (
                f"{self.profile.name}: its force beyond the flat face is a difference that loses digits; "
                "emit it by emit.general.library_source, whose rules do not"
            )
            raise ValueError(message)
        tip, radius = forms["tip"], "a" if self.b is None else "inner"
        needs = self.functions.needs(tip, ("a",)) | {"E_star"}
        lines = [] if self.b is None else [f"inner = np.minimum(a, {self.b})"]
        if tip.cancels:
            slope = self.slopes["tip"][0]
            lines.append(f"tip = {scale} * force_integral({slope.growth('t')}, {radius}, {SMOOTH})")
            needs |= set(slope.needs)
        else:
            moved, steps = self._moved(tip, radius)
            lines += [*steps, f"tip = {python(moved.value)}"]
        if self.b is None:
            lines.append("return tip")
            return self._limited("force", lines, needs)
        slope = self.slopes["beyond"][0]
        growth = slope.with_parameters()
        lines.append(f"reach = {self._reach()}")
        lines.append(f"beyond = {scale} * force_integral_beyond({growth}, reach, {self.b}{self._width()})")
        lines.append("return tip + beyond")
        return self.functions.add("force", ("a",), lines, {*needs, *slope.needs, str(self.b)})

    def _reach(self) -> str:
        """The text of sqrt(a**2 - b**2), and of zero within the break."""
        reach = through_sine(Root(a, self.b), self.profile.abbreviations)
        return python(reach) if isinstance(reach, SineRoot) else f"difference_root(a, {self.b})"

    def _moved(self, form: EvaluationForm, radius: str) -> tuple[EvaluationForm, list[str]]:
        """The form of the tip for another name of its radius, and its steps.

        A root that vanishes at the end of an arc is taken from the angle of the break where the tip is whole.
        """
        symbol = sp.Symbol(radius, positive=True)
        moved = EvaluationForm(
            tuple((name, expr.subs(a, symbol)) for name, expr in form.steps), form.value.subs(a, symbol), False
        )
        steps = self.functions.steps(moved)
        for i, (name, expr) in enumerate(form.steps if self.b is not None else ()):
            whole = without_subtraction(expr.subs(a, self.b), self.profile.abbreviations)
            if isinstance(expr, Root) and not isinstance(whole, Root):
                steps[i] = f"{name} = np.where(a < {self.b}, {python(moved.steps[i][1])}, {python(whole)})"
        return moved, steps

    def stiffness(self, form: EvaluationForm) -> Private:
        lines = [*self.functions.steps(form), f"return {python(form.value)}"]
        return self._limited("stiffness", lines, self.functions.needs(form, ("a",)))

    def pressure(self) -> Private:
        lines: list[str] = []
        needs, parts = {"E_star"}, []
        scale = python(HOMOGENEOUS.pressure_scale)
        regimes = self.regimes("p")
        if "tip" in regimes:
            text, more = self._tip_pressure(lines, scale)
            needs |= more
            parts.append(text)
        if "beyond" in regimes:
            slope = self.slopes["beyond"][0]
            growth = slope.with_parameters()
            lines.append(f"growth = pressure_integral_beyond({growth}, r, a, {self.b}{self._width()})")
            needs |= {*slope.needs, str(self.b)}
            parts.append(f"{scale} * growth")
        value = " + ".join(parts)
        if self.b is not None:
            value, lines = self._corner(value, lines)
        return self._inside(value, lines, needs)

    def _inside(self, value: str, lines: list[str], needs: set[str]) -> Private:
        condition, more = self.domain()
        if len(value) > 80:
            lines.append(f"pressed = {value}")
            value = "pressed"
        within = f"np.where(r < a, {value}, 0.0)"
        if condition:
            lines.append(f"inside = {within}")
            within = f"np.where({condition}, inside, np.nan)"
        lines.append(f"return {within}")
        return self.functions.add("pressure", ("r", "a"), lines, needs | more)

    def _corner(self, value: str, lines: list[str]) -> tuple[str, list[str]]:
        """Infinite at the break, where the slope of the profile jumps."""
        jump = singular_at_break(self.slopes["beyond"][1])
        if jump == 0:
            return value, lines
        conditions = [f"(r == {self.b})", f"(a > {self.b})"]
        conditions += [
            f"({_greater(difference)})" for difference in sorted(jump.atoms(sp.Add), key=sp.default_sort_key)
        ]
        return "pressed", [*lines, f"pressed = np.where({' & '.join(conditions)}, np.inf, {value})"]

    def _tip_pressure(self, lines: list[str], scale: str) -> tuple[str, set[str]]:
        radius = "a"
        if self.b is not None:
            radius = "inner"
            lines.append(f"inner = np.minimum(a, {self.b})")
        form = self.form("p", "tip")
        kind, length = self.scale("tip")
        more = {str(self.b)} if self.b is not None else set()
        if not form.cancels and (form.value.has(ArcStrips) or kind in ("", "waves") and self._plain(form)):
            moved, steps = self._moved(form, radius)
            lines += steps
            value = self.functions.value_lines(moved.value, lines)
            more |= self.functions.needs(form, ("r", "a"))
        else:
            slope = self.slopes["tip"][0]
            rule, tail = self._rule("pressure_integral", kind, length)
            growth = slope.growth("t") if kind in ("", "waves") else slope.with_parameters()
            lines.append(f"within = {rule}({growth}, r, {radius}, {tail})")
            value = f"{scale} * within"
            more |= {*slope.needs} | ({str(length)} if length is not None else set())
        if self.b is not None:
            if len(value) > 80:
                lines.append(f"within = {value}")
                value = "within"
            lines.append(f"tip = np.where(r < inner, {value}, 0.0)")
            return "tip", more
        return value, more

    @staticmethod
    def _plain(form: EvaluationForm) -> bool:
        return not any(expr.has(*masters.MASTERS) for expr in (form.value, *(e for _, e in form.steps)))

    def _width(self) -> str:
        return strip_width(self.profile)

    def _rule(self, name: str, kind: str, length: sp.Expr | None) -> tuple[str, str]:
        """The rule and its last arguments."""
        if kind == "waves":
            return f"{name}_waves", "wavelength"
        if kind in ("sinh", "tanh"):
            return f"{name}_{kind}", str(length)
        return name, str(SMOOTH)

    def _monomial_displacement(self, radius: str) -> str:
        """The displacement of a tip whose depth is a power of its radius, through the kernel of that power."""
        found = monomial(self.regimes("d")["tip"].expr)
        if found is None:
            return ""
        depth, exponent = found
        return f"{python(depth.subs(a, sp.Symbol(radius, positive=True)))} * beside(r, {radius}, OUTSIDE_{exponent})"

    def displacement(self) -> Private:
        lines: list[str] = []
        needs, parts = set(), []
        scale = python(HOMOGENEOUS.displacement_scale)
        regimes = self.regimes("w")
        closed = self.form("w", "tip") if "tip" in regimes and self.b is None else None
        if closed is not None and not closed.cancels:
            lines += self.functions.steps(closed)
            outside = self.functions.value_lines(closed.value, lines)
            needs |= self.functions.needs(closed, ("r", "a"))
        else:
            radius = "a" if self.b is None else "inner"
            if "tip" in regimes:
                slope, (kind, length) = self.slopes["tip"][0], self.scale("tip")
                monomial = self._monomial_displacement(radius)
                rule, tail = self._rule("displacement_integral", kind, length)
                growth = slope.growth("t") if kind in ("", "waves") else slope.with_parameters()
                if self.b is not None:
                    lines.append(f"inner = np.minimum(a, {self.b})")
                lines.append(f"tip = {monomial}" if monomial else f"tip = {rule}({growth}, r, {radius}, {tail})")
                needs |= {*slope.needs} | ({str(length)} if length is not None else set())
                parts.append("tip")
            if "beyond" in regimes:
                slope = self.slopes["beyond"][0]
                growth = slope.with_parameters()
                lines.append(f"beyond = displacement_integral_beyond({growth}, r, a, {self.b}{self._width()})")
                needs |= {*slope.needs, str(self.b)}
                parts.append("beyond")
            total = " + ".join(parts)
            outside = f"{scale} * ({total})" if len(parts) > 1 else f"{scale} * {total}"
        depth, profile = self.functions.functions["depth"], self.functions.functions["profile"]
        lines.append(f"outside = {outside}")
        lines.append(f"inside = {depth.call()} - {profile.call()}")
        value = "np.where(r > a, outside, inside)"
        condition, more = self.domain()
        if condition:
            value = f"np.where({condition}, {value}, np.nan)"
        lines.append(f"return {value}")
        return self.functions.add(
            "displacement", ("r", "a"), lines, needs | set(depth.needs) | set(profile.needs) | more
        )


def monomial(depth: sp.Expr) -> tuple[sp.Expr, int] | None:
    """The depth and its power of the radius where that has a kernel of its own."""
    depth = sp.factor_terms(depth)
    power = depth.as_independent(a, as_Add=False)[1]
    return (depth, int(power.as_base_exp()[1])) if power in [a**exponent for exponent in EXPONENTS] else None


def strip_width(profile: Profile) -> str:
    """The last argument of a rule beyond the break.

    Where b = R sin(theta), g' has a singularity at root = i R cos(theta), that is at pi/2 - theta.
    """
    sines = [expr.atoms(sp.sin) for symbol, expr in profile.abbreviations if symbol == profile.breaks[0]]
    angles = [python(sine.args[0]) for found in sines for sine in found]
    return f", width=1.0 - 2.0 * {angles[0]} / np.pi" if angles else ""


def _greater(difference: sp.Expr) -> str:
    terms = sorted(difference.args, key=lambda term: term.could_extract_minus_sign())
    return f"{python(terms[0])} > {python(-terms[1])}"
