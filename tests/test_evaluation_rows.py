"""How the catalogue evaluates a formula, read back as printed: closed forms, slopes, integrals of Gauss rules."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache
from typing import Any

import mpmath as mp
import pytest
import sympy as sp
from stored_book import CATALOGUE, KEYS, evidence, stored

from axiderive import notation as nt
from axiderive.contact.systems import problem
from axiderive.emit.blocks import evaluations
from axiderive.emit.code import python
from axiderive.emit.evaluated import evaluation_rows, form_of
from axiderive.emit.plane.forms import form_of as plane_form
from axiderive.emit.private import PrivateFunctions, through_sine
from axiderive.emit.readback.grammar import read
from axiderive.emit.readback.nodes import environment
from axiderive.emit.readback.points import points_of
from axiderive.emit.readback.printed import Printed, holds, name_in_print, named
from axiderive.entry import Case
from axiderive.profiles import load
from axiderive.proof.evaluate import evaluate
from axiderive.proof.unevaluated import evaluate_case
from axiderive.stable.chosen import chosen
from axiderive.stable.forms import EvaluationForm
from axiderive.stable.gaps import of_lengths

READ_BACK = mp.mpf(10) ** -20
DIGITS = 40
INTEGRATING = 50

EVALUATED = (
    "cone.p", "cone.w", "paraboloid.w", "quartic.w", "sextic.w", "power_law.p", "power_law.w", "polynomial.p",
    "polynomial.w", "sphere.d", "sphere.F", "sphere.p", "ellipsoid.d", "ellipsoid.F", "ellipsoid.p", "hyperboloid.F",
    "truncated_cone.d", "truncated_cone.F", "rounded_cone.d", "rounded_cone.F", "rounded_punch.d", "rounded_punch.F",
    "rounded_curved_punch.d", "rounded_curved_punch.F", "sphere_tipped_cone.d", "sphere_tipped_cone.d",
    "flat_punch.w", "capped_cylinder.F", "capped_cylinder.w", "capped_cylinder.w", "concave_power.w",
    "concave_power.p", "concave_paraboloid.p", "concave_paraboloid.w", "concave_quartic.p", "concave_quartic.w",
    "plane.wedge.p", "plane.wedge.s", "plane.wedge.d", "plane.parabola.s", "plane.parabola.d", "plane.quartic.s",
    "plane.quartic.d", "plane.sextic.s", "plane.sextic.d", "plane.power_law.p", "plane.power_law.s",
    "plane.power_law.d", "plane.truncated_wedge.p", "plane.truncated_wedge.p", "plane.truncated_wedge.s",
    "plane.rounded_wedge.P", "plane.flat_punch.d", "plane.concave_power.p", "plane.concave_power.s",
    "plane.concave_power.d", "plane.concave_parabola.p", "plane.concave_parabola.s", "plane.concave_parabola.d",
    "plane.concave_quartic.p", "plane.concave_quartic.s", "plane.concave_quartic.d", "loads.uniform.w",
    "loads.hertzian.w", "loads.punch.w", "loads.power.w", "loads.power.w",
)  # fmt: skip
"""Entries with an evaluation form in print, in the order of the book, once for every range."""
RULED = (
    "sphere.w", "ellipsoid.w", "hyperboloid.p", "hyperboloid.w", "truncated_cone.p", "truncated_cone.w",
    "truncated_paraboloid.p", "truncated_paraboloid.w", "rounded_cone.p", "rounded_cone.w", "capped_paraboloid.p",
    "capped_paraboloid.w", "rounded_punch.p", "rounded_punch.w", "rounded_curved_punch.p", "rounded_curved_punch.w",
    "sphere_tipped_cone.F", "sphere_tipped_cone.p", "sphere_tipped_cone.w", "wavy_paraboloid.p", "wavy_paraboloid.w",
    "gaussian.F", "gaussian.p", "gaussian.w", "plane.truncated_wedge.d", "plane.rounded_wedge.p",
    "plane.rounded_wedge.s", "plane.rounded_wedge.d", "plane.rounded_punch.P", "plane.rounded_punch.p",
    "plane.rounded_punch.s", "plane.rounded_punch.d",
)  # fmt: skip
"""Entries whose Gauss rule is in print as the integral that it evaluates."""
SUMMED = {
    "cone.w": "beside_cone(r, a)", "paraboloid.w": "beside(r, a, OUTSIDE_2)",
    "quartic.w": "beside(r, a, OUTSIDE_4)", "sextic.w": "beside(r, a, OUTSIDE_6)",
    "capped_cylinder.F": "np.maximum(excess, 0.0)", "capped_cylinder.w": "beside(r, rho, OUTSIDE_2)",
    "concave_paraboloid.p": "(d - _minimum_depth(h) + face) / root",
    "concave_quartic.p": "(d - _minimum_depth(h) + face) / root",
    "concave_paraboloid.w": "power_punches(r, a, 2)", "concave_quartic.w": "power_punches(r, a, 4)",
    "concave_power.p": "power_pressure(r, a, n)", "concave_power.w": "power_punches(r, a, n)",
    "polynomial.p": "power_pressure(r, a, j)", "polynomial.w": "power_displacement(r, a, j)",
    "plane.concave_parabola.p": "carried / (np.pi * root)", "plane.concave_quartic.p": "carried / (np.pi * root)",
    "plane.sextic.d": "15 * np.arcsinh(root / a)", "plane.truncated_wedge.p": "np.arcsinh(root_ax / root_xb)",
    "loads.uniform.w": "uniform(r, a)", "loads.power.w": "power(r, a, s)",
    "loads.hertzian.w": "beside(r, a, OUTSIDE_2)", "loads.punch.w": "np.arctan(a / root)",
}  # fmt: skip
"""What the generated module calls for the forms that are not the evaluation form of their entry."""


@cache
def _evaluation(name: str) -> list[dict[str, Any]]:
    return evaluations(problem(name), stored(name), evidence(name))


def _of(kind: str, key: str) -> list[dict[str, Any]]:
    return [row for row in _evaluation(key.rpartition(".")[0]) if row["comment"] == f"{kind} {key}"]


def _where(one: dict[str, Any]) -> str:
    return str(one["small"].strip("$"))


def _body(tex: str, values: dict[str, Any]) -> Any:
    """The value of the first formula with the names that the others define."""
    first, *definitions = read(tex)
    return first.members[-1](environment(definitions, values))


def _farthest(key: str, one: dict[str, Any], tex: str) -> Any:
    """Largest relative difference between a printed evaluation form and its entry where it is said to hold."""
    name, _, suffix = key.rpartition(".")
    entries, found = stored(name), []
    # an integral loses half of its digits at a root; psi less the first terms of its series seven powers of a/r
    with mp.workdps(INTEGRATING if r"\int" in tex else 5 * DIGITS if r"\psi" in tex else 2 * DIGITS):
        for case, values in points_of(entries[suffix], "formula", entries, 2, 7):
            env = named(values) | Printed(entries, entries).kappa
            if holds(_where(one), env):
                own = evaluate(case.expr, values, DIGITS)
                found.append(abs(_body(tex, env) - own) / abs(own))
    return max(found)


@pytest.mark.slow
def test_evaluation_forms_are_printed_where_they_differ() -> None:
    names = [key for key in KEYS if problem(key).system.name in ("normal", "plane", "loads")]
    rows = [one["comment"] for name in names for one in _evaluation(name)]
    assert [text for text in rows if text.startswith("evaluation")] == [f"evaluation {key}" for key in EVALUATED]
    assert [text for text in rows if text.startswith("rule")] == [f"rule {key}" for key in RULED]
    assert evaluation_rows(load("cone"), stored("cone"), {}) == []


INTEGRATED = (
    "power_law.p", "polynomial.p", "polynomial.w", "sphere.p", "ellipsoid.p", "concave_power.p", "concave_power.w",
    "concave_paraboloid.w", "concave_quartic.w", "plane.power_law.p", "plane.power_law.s", "plane.power_law.d",
    "plane.concave_power.p", "plane.concave_power.s", "plane.concave_power.d", "loads.uniform.w", "loads.power.w",
)  # fmt: skip
"""Evaluation forms with an integral, whose quadratures take seconds."""


@pytest.mark.parametrize(
    "key", [pytest.param(key, marks=pytest.mark.slow) if key in INTEGRATED else key for key in dict.fromkeys(EVALUATED)]
)
def test_a_printed_evaluation_form_is_the_entry(key: str) -> None:
    for one in _of("evaluation", key):
        assert _farthest(key, one, one["tex"]) < READ_BACK
        assert _mutants(one["tex"], lambda tex, key=key, row=one: _farthest(key, row, tex)) >= 2


def _mutants(tex: str, distance: Callable[[str], Any]) -> int:
    """How many changes of a digit or a sign were tried; none of them passes."""
    mutants = 0
    for match in re.finditer(r"\\\\\[1.5mm\]|(\d)|(?<![=&({])([+-])", tex):
        if match[1] or match[2]:
            other = str(int(match[1]) % 9 + 1) if match[1] else "-" if match[2] == "+" else "+"
            changed = tex[: match.start()] + other + tex[match.end() :]
            try:
                assert distance(changed) > READ_BACK, changed
            except (ValueError, TypeError, ZeroDivisionError, SyntaxError, LookupError):
                continue
            mutants += 1
    return mutants


SLOPED = tuple(dict.fromkeys(key.rpartition(".")[0] for key in RULED))


def _grown(name: str) -> str:
    """What a contact grows by: the depth g(a), in the plane the load P(a)."""
    return "P" if name.startswith("plane.") else "d"


def _slope_distance(name: str, one: dict[str, Any], tex: str) -> Any:
    """Largest relative difference between the printed g'(t) and the derivative of the entry of the depth."""
    entries, found = stored(name), []
    with mp.workdps(2 * DIGITS):
        for case, values in points_of(entries[_grown(name)], "formula", entries, 2, 7):
            env = named(values)
            env["t"] = env["a"]
            if holds(_where(one), env):
                own = evaluate(sp.diff(case.expr, nt.a), values, DIGITS)
                found.append(abs(_body(tex, env) - own) / abs(own))
    return max(found)


@pytest.mark.parametrize("name", SLOPED)
def test_a_printed_slope_is_the_derivative_of_the_depth(name: str) -> None:
    rows = _of("slope", f"{name}.{_grown(name)}")
    assert len(rows) == len(stored(name)[_grown(name)].regions())
    for one in rows:
        assert _slope_distance(name, one, one["tex"]) < READ_BACK
        assert _mutants(one["tex"], lambda tex, name=name, row=one: _slope_distance(name, row, tex)) >= 1


def _rule_distance(key: str, tex: str) -> Any:
    """Largest relative difference between a printed integral over the printed slope and the entry."""
    name, _, suffix = key.rpartition(".")
    entries, profile, found = stored(name), problem(name).profile, []
    slopes = [(_where(one), one["tex"]) for one in _of("slope", f"{name}.{_grown(name)}")]
    with mp.workdps(60):  # a root at an end of the range costs half of the digits
        for case, values in points_of(entries[suffix], "formula", entries, 1, 7):
            env: dict[str, Any] = named(values)
            breaks = [env[name_in_print(b)] for b in profile.breaks]

            def slope(t: Any, env: dict[str, Any] = env) -> Any:
                at = {**env, "t": t}
                return next(_body(text, at) for where, text in slopes if holds(where, at))

            env |= {"g'()": slope, "P'()": slope, "cuts": {"t": breaks}}
            own = evaluate_case(case, values, 25)
            found.append(abs(_body(tex, env) - own) / abs(own))
    return max(found)


LONG = ("sphere_tipped_cone.F", "sphere_tipped_cone.p", "rounded_curved_punch.p", "rounded_cone.p",
        "capped_paraboloid.p")  # fmt: skip
"""Rules over a corner, whose quadrature takes ten seconds and more."""


def _marked(key: str) -> Any:
    if key == "truncated_paraboloid.w":
        return key
    return pytest.param(key, marks=pytest.mark.sweep if key in LONG else pytest.mark.slow)


@pytest.mark.parametrize("key", [*map(_marked, RULED)])
def test_a_printed_rule_is_an_integral_of_the_entry(key: str) -> None:
    (one,) = _of("rule", key)
    assert _rule_distance(key, one["tex"]) < READ_BACK
    assert _rule_distance(key, one["tex"].replace("2", "3", 1)) > READ_BACK or "2" not in one["tex"]


@pytest.mark.parametrize("key", dict.fromkeys((*EVALUATED, *RULED)))
def test_the_catalogue_evaluates_what_is_printed(key: str) -> None:
    """The value and the roots of the form, or of the slope under a rule, stand in the generated module."""
    name, _, suffix = key.rpartition(".")
    folder = "" if "." in name else "normal."
    text = (CATALOGUE / "axicontact" / f"{folder}{name}".replace(".", "/")).with_suffix(".py").read_text()
    if key in RULED:
        rule = {
            "F": "force_integral", "p": "pressure_integral", "w": "displacement_integral", "P": "load_beyond",
            "s": "slope_beyond", "d": "depth_beyond",
        }[suffix]  # fmt: skip
        assert rule in text
        return
    if key in SUMMED:
        assert SUMMED[key] in text
        return
    for one in _of("evaluation", key):
        for case, values in points_of(stored(name)[suffix], "formula", stored(name), 1, 7):
            if holds(_where(one), named(values)):
                form, shorts = _computed(name, suffix, case), problem(name).profile.abbreviations
                lines: list[str] = []
                assert PrivateFunctions.value_lines(form.value, lines) in text
                assert all(line in text for line in lines)
                assert all(python(through_sine(expr, shorts)) in text for _, expr in form.steps)
                break
        else:
            pytest.fail(f"{key} is printed for no case")


def _computed(name: str, suffix: str, case: Case) -> EvaluationForm:
    """What the module computes one after the other."""
    if not name.startswith("plane."):
        return of_lengths(form_of(stored(name)[suffix], case.expr, case.chain))
    if problem(name).profile.contact == "compact":
        return plane_form(case, chosen(f"{name}.{suffix}").below)
    return plane_form(Case(case.chain, sp.expand(case.expr).coeff(nt.P) * nt.P))
