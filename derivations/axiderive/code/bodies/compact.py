"""Bodies of the functions of a compact contact.

Depth, force, mean pressure and stiffness: closed where that is stable, else the regular rule of the force.

Bodies of the functions of a compact contact: closed where that is stable, else the regular rules and roots.
"""

from __future__ import annotations

import sympy as sp

from ...abel import masters
from ...notation import a
from ...physics.medium import HOMOGENEOUS
from ...stable.forms import EvaluationForm, of_lengths
from ...stable.opaque import ArcStrips, ArctanGap, Root, SineRoot
from ...stable.slopes import ROOT, singular_at_break
from ..function import Function
from ..private import through_sine
from ..tables import EXPONENTS
from ..text import python
from .regimes import SMOOTH, Regimes


class Lumped(Regimes):
    """The functions of the contact radius alone."""

    def depth_like(self, suffix: str, name: str) -> Function:
        """Depth, force or mean pressure by their regimes."""
        regimes = self.regimes(suffix)
        forms = {key: self.form(suffix, key) for key in regimes}
        if suffix == "F" and any(form.cancels for form in forms.values()) and self.scale("tip")[0] != "waves":
            return self._force_by_rule(forms)
        if suffix == "pm" and not self._closed_mean(forms):
            force = self.functions["force"]
            value = f"{force.call()} / (np.pi * a**2)"
            return self.functions.add(name, ("a",), [f"return np.where(a > 0.0, {value}, 0.0)"])
        if len(forms) > 1 and suffix != "pm":
            if self.scale("tip")[0] == "tanh":
                inner = self._joined(name, self._of_lengths(forms), ("a", ROOT))
                return self.functions.add(name, ("a",), [f"return {inner.call('a', self._reach())}"])
            self._beyond(name, forms["beyond"])
        if not self.rooted or suffix == "pm":
            return self._joined(name, self._of_lengths(forms))
        inner = self._joined(name, forms, ("a", ROOT))
        lengths = self._of_lengths(forms)
        if lengths != forms or any(form.value.has(ArctanGap) for form in forms.values()):
            return self._joined(name, lengths)
        return self._from_radius(name, inner)

    def _of_lengths(self, forms: dict[str, EvaluationForm]) -> dict[str, EvaluationForm]:
        return {key: of_lengths(form) for key, form in forms.items()}

    def _joined(self, name: str, forms: dict[str, EvaluationForm], given: tuple[str, ...] = ("a",)) -> Function:
        """The regimes on either side of the break; with its root given, under a name of its own."""
        lines: list[str] = []
        # where a root is given the tip comes last: it may have one of its own
        for key, form in sorted(forms.items(), reverse=ROOT not in given):
            own = ("a",) if len(forms) > 1 and key == "tip" else given
            lines += self.functions.steps(form, own)
            value = self.functions.value_lines(form.value, lines)
            lines.append(f"{key} = {value}" if len(forms) > 1 else f"return {value}")
        if len(forms) > 1:
            lines.append(f"return np.where(a < {self.b}, tip, beyond)")
        if ROOT in given:
            return self.functions.add(f"{name}_at", given, lines)
        return self._limited(name, lines)

    def _beyond(self, name: str, form: EvaluationForm) -> Function:
        """In the radius and its root, which says more of a radius next to the break: for the inverse."""
        lines = self.functions.steps(form, ("a", ROOT))
        value = self.functions.value_lines(form.value, lines)
        return self.functions.add(f"{name}_beyond", ("a", ROOT), [*lines, f"return {value}"])

    def _from_radius(self, name: str, inner: Function) -> Function:
        x, y = self.root_pair()
        lines = [f"root = np.sqrt(({x} - {y}) * ({x} + {y}))", f"return {inner.call('a', 'root')}"]
        return self.functions.add(name, ("a",), lines)

    def _closed_mean(self, forms: dict[str, EvaluationForm]) -> bool:
        """Closed, and without a division by a where a may vanish."""
        tip = forms.get("tip")
        if any(form.cancels for form in forms.values()):
            return False
        return tip is None or not sp.denom(sp.together(tip.value)).has(a) or not tip.value.has(sp.Add)

    def _force_by_rule(self, forms: dict[str, EvaluationForm]) -> Function:
        scale = python(HOMOGENEOUS.force_scale)
        if "tip" not in forms:
            message = (
                f"{self.profile.name}: its force beyond the flat face is a difference that loses digits; "
                "emit it by code.bodies.general.library_source, whose rules do not"
            )
            raise ValueError(message)
        tip, radius = forms["tip"], "a" if self.b is None else "inner"
        lines = [] if self.b is None else [f"inner = np.minimum(a, {self.b})"]
        if tip.cancels:
            slope = self.slopes["tip"][0]
            lines.append(f"tip = {scale} * force_integral({slope.growth('t')}, {radius}, {SMOOTH})")
        else:
            moved, steps = self._moved(tip, radius)
            lines += [*steps, f"tip = {python(moved.value)}"]
        if self.b is None:
            lines.append("return tip")
            return self._limited("force", lines)
        slope = self.slopes["beyond"][0]
        growth = slope.with_parameters()
        lines.append(f"beyond = {scale} * force_integral_beyond({growth}, reach, {self.b}{self.strip})")
        lines.append("return tip + beyond")
        # the root says more of a radius next to the break: for the inverse
        whole = self.functions.add("force_at", ("a", "reach"), lines)
        return self.functions.add("force", ("a",), [f"return {whole.call('a', self._reach())}"])

    def _reach(self) -> str:
        """The text of sqrt(a**2 - b**2), and of zero within the break."""
        reach = through_sine(Root(a, self.b), self.profile.abbreviations)
        return python(reach) if isinstance(reach, SineRoot) else f"difference_root(a, {self.b})"

    def stiffness(self, form: EvaluationForm) -> Function:
        """Adds and returns `_stiffness`, dF/dd at a contact radius; NaN beyond the largest one."""
        lines = [*self.functions.steps(form), f"return {python(form.value)}"]
        return self._limited("stiffness", lines)


class Compact(Lumped):
    """The private functions behind the entries of one compact profile."""

    def pressure(self) -> Function:
        """Adds and returns `_pressure` of (r, a): the closed tip, or rules over g', before and beyond the break."""
        lines: list[str] = []
        parts = []
        scale = python(HOMOGENEOUS.pressure_scale)
        regimes = self.regimes("p")
        if "tip" in regimes:
            parts.append(self._tip_pressure(lines, scale))
        if "beyond" in regimes:
            slope = self.slopes["beyond"][0]
            growth = slope.with_parameters()
            lines.append(f"growth = pressure_integral_beyond({growth}, r, a, {self.b}{self.strip})")
            parts.append(f"{scale} * growth")
        value = " + ".join(parts)
        if self.b is not None:
            value, lines = self._corner(value, lines)
        return self._inside(value, lines)

    def _inside(self, value: str, lines: list[str]) -> Function:
        condition = self.domain()
        if len(value) > 80:
            lines.append(f"pressed = {value}")
            value = "pressed"
        within = f"np.where(r < a, {value}, 0.0)"
        if condition:
            lines.append(f"inside = {within}")
            within = f"np.where({condition}, inside, np.nan)"
        lines.append(f"return {within}")
        return self.functions.add("pressure", ("r", "a"), lines)

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

    def _tip_pressure(self, lines: list[str], scale: str) -> str:
        radius = "a"
        if self.b is not None:
            radius = "inner"
            lines.append(f"inner = np.minimum(a, {self.b})")
        form = self.form("p", "tip")
        kind, length = self.scale("tip")
        if self._is_closed(form, kind):
            moved, steps = self._moved(form, radius)
            lines += steps
            value = self.functions.value_lines(moved.value, lines)
        else:
            slope = self.slopes["tip"][0]
            rule, tail = self._rule("pressure_integral", kind, length)
            growth = slope.growth("t") if kind in ("", "waves") else slope.with_parameters()
            lines.append(f"within = {rule}({growth}, r, {radius}, {tail})")
            value = f"{scale} * within"
        if self.b is not None:
            if len(value) > 80:
                lines.append(f"within = {value}")
                value = "within"
            lines.append(f"tip = np.where(r < inner, {value}, 0.0)")
            return "tip"
        return value

    def _is_closed(self, form: EvaluationForm, kind: str) -> bool:
        """Whether the pressure of the tip is its form; where roots or angles grow that must have been measured."""
        if form.cancels:
            return False
        measured = self.functions.variant(self.entries["p"]).closed and self.is_plain(form)
        return form.value.has(ArcStrips) or measured or kind in ("", "waves") and self.is_plain(form)

    @staticmethod
    def is_plain(form: EvaluationForm) -> bool:
        """Whether a form does without the functions that are integrals."""
        return not any(expr.has(*masters.MASTERS) for expr in (form.value, *(e for _, e in form.steps)))

    def _rule(self, name: str, kind: str, length: sp.Expr | None) -> tuple[str, str]:
        """The rule and its last arguments."""
        if kind == "waves":
            return f"{name}_waves", "wavelength"
        if kind in ("sinh", "tanh"):
            return f"{name}_{kind}", str(length)
        return name, str(SMOOTH)

    def _monomial_displacement(self, radius: str) -> str:
        """The displacement of a tip whose depth is a power of its radius, by the form of that power."""
        found = monomial(self.regimes("d")["tip"].expr)
        if found is None:
            return ""
        depth, exponent = found
        sunk = HOMOGENEOUS.displacement_scale * depth.subs(a, sp.Symbol(radius, positive=True))
        return f"{python(sunk)} * {beside(radius, exponent)}"

    def displacement(self) -> Function:
        """Adds and returns `_displacement` of (r, a): d - f(r) under the contact, outside a closed form or a rule."""
        lines: list[str] = []
        parts, terms = [], []
        scale = python(HOMOGENEOUS.displacement_scale)
        regimes = self.regimes("w")
        closed = self.form("w", "tip") if "tip" in regimes and self.b is None else None
        if closed is not None and not closed.cancels:
            lines += self.functions.steps(closed)
            outside = self.functions.value_lines(closed.value, lines)
        else:
            radius = "a" if self.b is None else "inner"
            if "tip" in regimes:
                slope, (kind, length) = self.slopes["tip"][0], self.scale("tip")
                monomial = self._monomial_displacement(radius)
                rule, tail = self._rule("displacement_integral", kind, length)
                growth = slope.growth("t") if kind == "waves" else slope.with_parameters()
                if self.b is not None:
                    lines.append(f"inner = np.minimum(a, {self.b})")
                if monomial:
                    terms.append(monomial)
                else:
                    lines.append(f"tip = {rule}({growth}, r, {radius}, {tail})")
                    parts.append("tip")
            if "beyond" in regimes:
                slope = self.slopes["beyond"][0]
                growth = slope.with_parameters()
                lines.append(f"beyond = displacement_integral_beyond({growth}, r, a, {self.b}{self.strip})")
                parts.append("beyond")
            if parts:
                terms.append(f"{scale} * ({' + '.join(parts)})" if len(parts) > 1 else f"{scale} * {parts[0]}")
            outside = " + ".join(terms)
        depth, profile = self.functions["depth"], self.functions["profile"]
        lines.append(f"outside = {outside}")
        lines.append(f"inside = {depth.call()} - {profile.call()}")
        value = "np.where(r > a, outside, inside)"
        condition = self.domain()
        if condition:
            value = f"np.where({condition}, {value}, np.nan)"
        lines.append(f"return {value}")
        return self.functions.add("displacement", ("r", "a"), lines)


def beside(radius: str, exponent: int) -> str:
    """The call for the displacement beside a contact of that radius whose depth is a power of it."""
    return f"beside(r, {radius}, OUTSIDE_{exponent})" if exponent > 1 else f"beside_cone(r, {radius})"


def monomial(depth: sp.Expr) -> tuple[sp.Expr, int] | None:
    """The depth and its power of the radius where that has a kernel of its own."""
    depth = sp.factor_terms(depth)
    power = depth.as_independent(a, as_Add=False)[1]
    return (depth, int(power.as_base_exp()[1])) if power in [a**exponent for exponent in EXPONENTS] else None


def _greater(difference: sp.Expr) -> str:
    terms = sorted(difference.args, key=lambda term: term.could_extract_minus_sign())
    return f"{python(terms[0])} > {python(-terms[1])}"
