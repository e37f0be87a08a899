"""How the catalogue evaluates a formula, read back as printed: closed forms, slopes, integrals of Gauss rules."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache
from typing import Any

import mpmath as mp
import pytest
import sympy as sp
from stored_book import CATALOGUE, evidence, stored

from axiderive import notation as nt
from axiderive.emit.code import python
from axiderive.emit.evaluated import evaluation_rows, form_of
from axiderive.emit.private import PrivateFunctions, through_sine
from axiderive.emit.readback.grammar import read
from axiderive.emit.readback.nodes import environment
from axiderive.emit.readback.points import points_of
from axiderive.emit.readback.printed import holds, name_in_print, named
from axiderive.profiles import NAMES, load
from axiderive.proof.evaluate import evaluate
from axiderive.proof.unevaluated import evaluate_case
from axiderive.stable.gaps import of_lengths

READ_BACK = mp.mpf(10) ** -20
DIGITS = 40


EVALUATED = (
    "cone.p", "sphere.d", "sphere.F", "ellipsoid.d", "ellipsoid.F", "hyperboloid.F", "truncated_cone.d",
    "truncated_cone.F", "rounded_cone.d", "rounded_cone.F", "rounded_punch.d", "rounded_punch.F",
    "rounded_curved_punch.d", "rounded_curved_punch.F", "sphere_tipped_cone.d", "sphere_tipped_cone.d", "flat_punch.w",
)  # fmt: skip
"""Entries with an evaluation form in print, in the order of the book, once for every range."""
RULED = (
    "sphere.w", "ellipsoid.w", "hyperboloid.p", "hyperboloid.w", "truncated_cone.p", "truncated_cone.w",
    "truncated_paraboloid.p", "truncated_paraboloid.w", "rounded_cone.p", "rounded_cone.w", "capped_paraboloid.p",
    "capped_paraboloid.w", "rounded_punch.p", "rounded_punch.w", "rounded_curved_punch.p", "rounded_curved_punch.w",
    "sphere_tipped_cone.F", "sphere_tipped_cone.p", "sphere_tipped_cone.w", "wavy_paraboloid.p", "wavy_paraboloid.w",
    "gaussian.F", "gaussian.p", "gaussian.w",
)  # fmt: skip
"""Entries whose Gauss rule is in print as the integral that it evaluates."""


@cache
def _evaluation(name: str) -> list[dict[str, Any]]:
    return evaluation_rows(load(name), stored(name), evidence(name))


def _of(kind: str, key: str) -> list[dict[str, Any]]:
    return [row for row in _evaluation(key.partition(".")[0]) if row["comment"] == f"{kind} {key}"]


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
    with mp.workdps(2 * DIGITS):
        for case, values in points_of(entries[suffix], "formula", entries, 2, 7):
            env = named(values)
            if holds(_where(one), env):
                own = evaluate(case.expr, values, DIGITS)
                found.append(abs(_body(tex, env) - own) / abs(own))
    return max(found)


@pytest.mark.slow
def test_evaluation_forms_are_printed_where_they_differ() -> None:
    rows = [one["comment"] for name in NAMES for one in _evaluation(name)]
    assert [text for text in rows if text.startswith("evaluation")] == [f"evaluation {key}" for key in EVALUATED]
    assert [text for text in rows if text.startswith("rule")] == [f"rule {key}" for key in RULED]
    assert evaluation_rows(load("cone"), stored("cone"), {}) == []


@pytest.mark.parametrize("key", dict.fromkeys(EVALUATED))
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


def _slope_distance(name: str, one: dict[str, Any], tex: str) -> Any:
    """Largest relative difference between the printed g'(t) and the derivative of the entry of the depth."""
    entries, found = stored(name), []
    with mp.workdps(2 * DIGITS):
        for case, values in points_of(entries["d"], "formula", entries, 2, 7):
            env = named(values)
            env["t"] = env["a"]
            if holds(_where(one), env):
                own = evaluate(sp.diff(case.expr, nt.a), values, DIGITS)
                found.append(abs(_body(tex, env) - own) / abs(own))
    return max(found)


@pytest.mark.parametrize("name", SLOPED)
def test_a_printed_slope_is_the_derivative_of_the_depth(name: str) -> None:
    rows = _of("slope", f"{name}.d")
    assert len(rows) == len(stored(name)["d"].regions())
    for one in rows:
        assert _slope_distance(name, one, one["tex"]) < READ_BACK
        assert _mutants(one["tex"], lambda tex, name=name, row=one: _slope_distance(name, row, tex)) >= 1


def _rule_distance(key: str, tex: str) -> Any:
    """Largest relative difference between a printed integral over the printed slope and the entry."""
    name, _, suffix = key.rpartition(".")
    entries, profile, found = stored(name), load(name), []
    slopes = [(_where(one), one["tex"]) for one in _of("slope", f"{name}.d")]
    with mp.workdps(60):  # a root at an end of the range costs half of the digits
        for case, values in points_of(entries[suffix], "formula", entries, 1, 7):
            env: dict[str, Any] = named(values)
            breaks = [env[name_in_print(b)] for b in profile.breaks]

            def slope(t: Any, env: dict[str, Any] = env) -> Any:
                at = {**env, "t": t}
                return next(_body(text, at) for where, text in slopes if holds(where, at))

            env |= {"g'()": slope, "cuts": {"t": breaks}}
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
    name, _, suffix = key.partition(".")
    text = (CATALOGUE / "axicontact" / "normal" / f"{name}.py").read_text()
    if key in RULED:
        rule = {"F": "force_integral", "p": "pressure_integral", "w": "displacement_integral"}[suffix]
        assert rule in text
        return
    for one in _of("evaluation", key):
        for case, values in points_of(stored(name)[suffix], "formula", stored(name), 1, 7):
            if holds(_where(one), named(values)):
                form = of_lengths(form_of(load(name), case.expr, case.chain))
                lines: list[str] = []
                assert PrivateFunctions.value_lines(form.value, lines) in text
                assert all(line in text for line in lines)
                shorts = load(name).abbreviations
                assert all(python(through_sine(expr, shorts)) in text for _, expr in form.steps)
                break
        else:
            pytest.fail(f"{key} is printed for no case")
