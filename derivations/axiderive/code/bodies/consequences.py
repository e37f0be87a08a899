"""Bodies of the consequences of a contact: closed where that keeps its digits, else by the rules of their own file."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from ...entry import Entry
from ...notation import a, d, r
from ...physics.consequences import CONSEQUENCES, Consequence
from ...stable.forms import EvaluationForm
from ...stable.signs import facts_of
from ..function import Function
from ..private import PrivateFunctions
from ..text import python
from .compact import Compact
from .complete import Complete

LONG = 110
"""Characters of a value that is written in two parts, that of the punch and that of the face."""
RHO, ROOT, RISE = (sp.Symbol(name, positive=True) for name in ("rho", "root", "rise"))


def of_compact(compact: Compact, entries: Mapping[str, Entry]) -> None:
    """Adds the private functions of those that a compact profile has."""
    for suffix, own in CONSEQUENCES.items():
        if suffix not in entries:
            continue
        forms = {key: compact.form(suffix, key) for key in compact.regimes(suffix)}
        inside = own.compact.place == "inside"
        if all(_keeps(form) for form in forms.values()) and not (inside and (compact.b or compact.summed)):
            _closed(compact, own, forms)
        else:
            _by_rule(compact, own)


def _keeps(form: EvaluationForm) -> bool:
    """Whether a form keeps its digits and costs less than a rule."""
    parts = (form.value, *(expr for _, expr in form.steps))
    return not form.cancels and Compact.is_plain(form) and not any(part.has(sp.Integral) for part in parts)


def _limited(compact: Compact, own: Consequence, lines: list[str], value: str) -> None:
    """NaN where there is no such contact, and beyond it the whole force."""
    fields, condition = [str(symbol) for symbol in own.compact.arguments], compact.domain()
    if condition and len(value) > 80:
        lines.append(f"found = {value}")
        value = "found"
    value = f"np.where({condition}, {value}, np.nan)" if condition else value
    compact.functions.add(own.compact.function, fields, [*lines, f"return {value}"])


def _closed(compact: Compact, own: Consequence, forms: Mapping[str, EvaluationForm]) -> None:
    lines, values = list[str](), list[str]()
    for form in forms.values():
        lines += [line for line in compact.functions.steps(form) if line not in lines]
        values.append(compact.functions.value_lines(_parted(form.value, lines), lines))
    value = f"np.where(a < {compact.b}, {', '.join(values)})" if len(forms) > 1 else values[0]
    if own.compact.place == "inside" and len(value) > 60:
        lines.append(f"within = {value}")
        value = "within"
    if own.compact.place == "inside":
        # an angle to the axis has no bound there
        axis = f"np.where(r > 0.0, {value}, 0.0)" if r in _singular(forms) else value
        value = f"np.where(r < a, {axis}, {compact.functions['force'].call()})"
    _limited(compact, own, lines, value)


def _singular(forms: Mapping[str, EvaluationForm]) -> set[sp.Symbol]:
    """The symbols by which a form divides, or of which it takes a function."""
    parts = [part for form in forms.values() for part in (form.value, *(expr for _, expr in form.steps))]
    divided = {s for part in parts for power in part.atoms(sp.Pow) if power.exp.is_negative for s in power.free_symbols}
    return divided.union(*(f.free_symbols for part in parts for f in part.atoms(sp.Function)))


def _by_rule(compact: Compact, own: Consequence) -> None:
    """The rules before and beyond the break, added to what a smaller contact or a flat face has."""
    functions, rules, name = compact.functions, own.rules, f"{own.compact.function}_integral"
    b, regimes, (kind, length) = compact.b, compact.regimes(own.suffix), compact.scale("tip")
    place = ["r"] if own.compact.place == "inside" else []
    over_depth = rules.over == "depth"
    sunk = ["sunk"] if over_depth else []
    lines = [f"sunk = {functions['depth'].call()}"] if over_depth else []
    parts, radius = list[str](), "a"
    if "tip" in regimes:
        if b is not None:
            radius = "inner"
            lines.append(f"inner = np.minimum(a, {b})")
        whole = kind == "tanh" and b is None
        growth = functions["depth_at" if whole else "depth"] if over_depth else functions["slope"]
        tail = [str(length)] if kind == "tanh" and not (over_depth and b) else []
        reach = [str(length) if length is not None else radius] if over_depth and not tail else []
        width = ", width=1.0 / (1.0 + 4.0 * np.pi / wavelength * a)" if kind == "waves" else ""
        width = compact.strip if over_depth and b is not None and kind == "tanh" else width
        near = [f"np.minimum(r, {radius})"] if place else []
        lengths = ", ".join([*near, radius, *sunk, *tail, *reach])
        lines.append(f"tip = {name}{'_tanh' if tail else ''}({_passed(compact, growth)}, {lengths}{width})")
        parts.append("tip")
    if "beyond" in regimes:
        known = functions.functions
        growth = known.get("depth_beyond") or known["depth_at"] if over_depth else known["slope_beyond"]
        lengths = ", ".join([*place, "a", *sunk, str(b)])
        lines.append(f"beyond = {name}_beyond({_passed(compact, growth)}, {lengths}{compact.strip})")
        parts.append("beyond")
    summed = " + ".join(parts)
    value = f"{python(rules.scale)} * ({summed})" if len(parts) > 1 else f"{python(rules.scale)} * {summed}"
    start = _start(compact, rules.start if "tip" in regimes else rules.flat)
    if start.startswith(("b *", f"{b} *")):
        value = f"{python(rules.scale)} * ({start} + {summed})"
    elif start:
        value = f"{start} + {value}"
    _limited(compact, own, lines, value)


def _start(compact: Compact, start: str) -> str:
    ends = "np.minimum(r, a)"
    force = compact.functions["force"].call(ends)
    if compact.profile.truncated:
        beyond = compact.functions["force"].call(f"np.maximum({ends}, {compact.b})")
        force = f"np.where(r > {compact.b}, {beyond}, 0.0)"
    return start.format(force=force, b=compact.b)


def _passed(compact: Compact, growth: Function) -> str:
    """The function and its parameters, coefficients of a polynomial within it."""
    return f"{growth.growth('t')}, ()" if compact.summed else growth.with_parameters()


def of_complete(complete: Complete) -> None:
    """Adds the private functions of a contact with a fixed edge."""
    for suffix, own in CONSEQUENCES.items():
        if suffix in complete.entries:
            _fixed(complete, complete.functions, own)


def _fixed(complete: Complete, functions: PrivateFunctions, own: Consequence) -> None:
    """The formula of the whole face; where that is reached late, of the contact of radius rho and what is beyond it."""
    entry, force = complete.entries[own.suffix], functions["force"]
    edge, lines, whole = "a", list[str](), entry.cases[-1].expr
    over = _over_threshold(complete, own, lines)
    if over is not None:
        value = over
    elif entry.partial is None:
        value = _form(functions, entry, whole, lines)
    else:
        grown = entry.partial.cases[0].expr
        edge, reach = "rho", complete.reach
        lines += [f"whole = {python(reach)}", "rho = np.minimum(whole, a)"]
        beyond = _form(functions, entry, sp.factor(sp.expand(whole - grown)), lines)
        value = f"{_form(functions, entry, grown.subs(a, RHO), lines)} + np.where(whole > a, {beyond}, 0.0)"
    if own.complete.place == "inside":
        lines.append(f"within = {value}")
        value = f"np.where(r < {edge}, within, {force.call()})"
    complete.add(own.suffix, complete.from_threshold(lines, value, own.complete.arguments[-1]), lines)


def _over_threshold(complete: Complete, own: Consequence, lines: list[str]) -> str | None:
    """A field that grows with d - d_min and what there is at d_min, as powers of the root, where the face is algebraic.

    What is left at d_min may vanish on the axis as r**4, of which a sum over d keeps no digit.
    """
    if not complete.concave or own.complete.place != "inside":
        return None
    whole = complete.entries[own.suffix].cases[-1].expr.subs(r, sp.sqrt(a**2 - ROOT**2))
    per_depth = sp.factor(sp.diff(whole, d))
    rest = sp.factor(sp.expand(whole.subs(d, complete.least_depth) / per_depth))
    if not rest.is_polynomial(ROOT) or per_depth.has(d):
        return None
    rise = {a - ROOT: RISE, ROOT - a: -RISE}
    face = rest.subs(rise)
    for part in face.atoms(sp.Add):
        if part.has(ROOT) and len({sp.sign(factor) for factor in sp.Poly(part, ROOT, a).coeffs()}) > 1:
            # powers of the root that cancel near the axis, where the rise is small
            face = face.subs(part, sp.horner(sp.expand(part.subs(ROOT, a - RISE)), RISE))
    lines += ["root = np.sqrt((a - r) * (a + r))", "rise = r**2 / (a + root)", f"face = {python(face)}"]
    least = complete.functions["minimum_depth"].call()
    return f"{python(per_depth.subs(rise))} * (d - {least} + face)"


def _form(functions: PrivateFunctions, entry: Entry, expr: sp.Expr, lines: list[str]) -> str:
    """The value of a formula, and its steps in the lines."""
    edge = RHO if expr.has(RHO) else a
    form = functions.form(entry, expr, facts_of((r, edge) if entry.quantity.place else ()))
    lines += functions.steps(form)
    whole = _parted(form.value, lines)
    value = functions.value_lines(whole, lines)
    inside = next((factor for factor in sp.Mul.make_args(whole) if factor.is_Add and factor.has(d)), None)
    if len(value) < LONG or inside is None:
        return value
    face = [term for term in inside.args if not term.has(d)]
    lines += [f"punch = {python(inside - sp.Add(*face))}", f"face = {python(sp.Add(*face))}"]
    return f"{python(whole / inside)} * (punch + face)"


def _parted(value: sp.Expr, lines: list[str]) -> sp.Expr:
    """A long value with its one function of the place under a name, which the lines define."""
    own = [function for function in value.atoms(sp.Function) if function.has(r)]
    if len(own) != 1 or len(python(value)) < LONG:
        return value
    lines.append(f"share = {python(own[0])}")
    return value.xreplace({own[0]: sp.Symbol("share", positive=True)})
