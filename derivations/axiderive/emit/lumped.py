"""Depth, force, mean pressure and stiffness: closed where that is stable, else the regular rule of the force."""

from __future__ import annotations

import sympy as sp

from ..contact.medium import HOMOGENEOUS
from ..notation import a
from ..stable.forms import EvaluationForm
from ..stable.gaps import of_lengths
from ..stable.opaque import ArctanGap, Root, SineRoot
from ..stable.slopes import ROOT
from .code import python
from .private import Private, through_sine
from .regimes import SMOOTH, Regimes


class Lumped(Regimes):
    """The functions of the contact radius alone."""

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
            if self.scale("tip")[0] == "tanh":
                inner = self._joined(name, self._of_lengths(suffix, forms), ("a", ROOT))
                return self.functions.add(name, ("a",), [f"return {inner.call('a', self._reach())}"], inner.needs)
            self._beyond(name, forms["beyond"])
        if not self.rooted or suffix == "pm":
            return self._joined(name, self._of_lengths(suffix, forms))
        inner = self._joined(name, forms, ("a", ROOT))
        lengths = self._of_lengths(suffix, forms)
        if lengths != forms or any(form.value.has(ArctanGap) for form in forms.values()):
            return self._joined(name, lengths)
        return self._from_radius(name, inner)

    def _of_lengths(self, suffix: str, forms: dict[str, EvaluationForm]) -> dict[str, EvaluationForm]:
        wanted = "lengths" in self.functions.variant(self.entries[suffix]).rules
        return {key: of_lengths(form) for key, form in forms.items()} if wanted else forms

    def _joined(self, name: str, forms: dict[str, EvaluationForm], given: tuple[str, ...] = ("a",)) -> Private:
        """The regimes on either side of the break; with its root given, under a name of its own."""
        lines, needs = [], set()
        # where a root is given the tip comes last: it may have one of its own
        for key, form in sorted(forms.items(), reverse=ROOT not in given):
            own = ("a",) if len(forms) > 1 and key == "tip" else given
            lines += self.functions.steps(form, own)
            needs |= self.functions.needs(form, own)
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
        lines.append(f"beyond = {scale} * force_integral_beyond({growth}, reach, {self.b}{self._width()})")
        lines.append("return tip + beyond")
        needs = {*needs, *slope.needs, str(self.b)}
        # the root says more of a radius next to the break: for the inverse
        whole = self.functions.add("force_at", ("a", "reach"), lines, needs)
        reach = self._reach()
        own = needs if reach.startswith("difference_root") else needs - {str(self.b)}
        return self.functions.add("force", ("a",), [f"return {whole.call('a', reach)}"], own)

    def _reach(self) -> str:
        """The text of sqrt(a**2 - b**2), and of zero within the break."""
        reach = through_sine(Root(a, self.b), self.profile.abbreviations)
        return python(reach) if isinstance(reach, SineRoot) else f"difference_root(a, {self.b})"

    def stiffness(self, form: EvaluationForm) -> Private:
        lines = [*self.functions.steps(form), f"return {python(form.value)}"]
        return self._limited("stiffness", lines, self.functions.needs(form, ("a",)))
