"""What the inverses without a root of their own are solved for, in print and in the modules."""

from __future__ import annotations

import inspect
import random
from collections.abc import Callable
from importlib import import_module
from typing import Any

import mpmath as mp
import numpy as np
import pytest
import sympy as sp
from misprints import misprints
from stored_book import CATALOGUE, stored
from test_evaluated_physics import as_read, passes, rows_of

from axicontact import _across, _graded_across, _graded_inverse, _unknowns
from axiderive import notation as nt
from axiderive.contact.systems import problem
from axiderive.emit.readback.further import wrong
from axiderive.emit.unknowns import END, FIRST, JOINT, LAST, LEADING, NAMES, NEXT, SHARE, T, Unknown, X, unknowns
from axiderive.emit.unknowns_graded import BENT, JOINED, READ, SHARP, graded_unknowns
from axiderive.proof.evaluate import evaluate

ROWS = [
    (key, row)
    for key in ("polynomial", "wavy_paraboloid", "gaussian", "hyperboloid", "truncated_paraboloid.fgm",
                "rounded_punch.fgm", "ellipsoid.fgm", "hyperboloid.fgm", "wavy_paraboloid.fgm",
                "sphere_tipped_cone.fgm", "gaussian.fgm", "capped_paraboloid.fgm", "rounded_cone.fgm")
    for row in rows_of(key) if row["comment"].startswith("solved")
]  # fmt: skip


@pytest.mark.parametrize(("key", "row"), ROWS)
def test_rows_are_read_back_and_their_misprints_are_not(key: str, row: dict[str, Any]) -> None:
    assert not wrong(as_read(row), stored)
    texts = list(dict.fromkeys(tex for _, tex in misprints(row["tex"], random.Random(key))))[:4]
    assert texts
    assert [tex for tex in texts if passes(as_read(row, tex))] == []


def source(key: str) -> str:
    return (CATALOGUE / problem(key).module).read_text(encoding="utf-8")


def test_the_starts_are_those_of_the_modules() -> None:
    for key, text in (
        ("hyperboloid", "b / 1000 * np.ones_like(d)"), ("hyperboloid.fgm", "d, 1.5 * b,"),
        ("polynomial.fgm", "d, 1.0,"),
        ("wavy_paraboloid.fgm", "d, 1.5 * wavelength,"), ("gaussian", "largest = 1.5019752682686114 * s *"),
        ("wavy_paraboloid", "unit = wavelength / (2 * np.pi)"),
        ("polynomial", "(np.log(share) / (j + 1) for j, share in enumerate(alone, 1))"),
    ):  # fmt: skip
        assert text in source(key)
    (first,) = (own.equations for own in unknowns(stored("gaussian")))
    assert [one.right for one in first] == [r"\frac{a_1}{1+t}", r"1.5019752682686114\,s"]


R, K = 1.3, -0.4
KNOWN = {nt.R: R, nt.b: R, nt.s: R, nt.k: K}


def radius_at(monkeypatch: pytest.MonkeyPatch, x: float, search: Callable[..., Any], *given: Any) -> float:
    """The radius at which an iteration has its load taken for the unknown x."""
    taken: list[float] = []
    found: list[float] = []

    def load(a: Any, *_: Any) -> Any:
        taken.append(float(np.ravel(a)[0]))
        return 1.0 - 0.5 / (1.0 + a)

    def look(curve: Callable[..., Any], value: Any, *_: Any, **__: Any) -> Any:
        taken.clear()
        curve(np.array([x]))
        found.append(taken[0])
        return value

    monkeypatch.setattr(_graded_inverse, "inverse", look)
    search(load, lambda a, *_: 1.0 + 0.0 * a, np.array([0.3]), *given)
    (one,) = found
    return one


def number(value: sp.Expr, **known: float) -> float:
    names = {name: symbol for symbol, name in NAMES.items()}
    return float(value.subs(KNOWN | {names.get(name, nt.a): x for name, x in known.items()}))


def equation(own: Unknown, left: str) -> sp.Expr:
    return next(one.value for one in own.equations if one.left == left)


EDGED = {"truncated_cone": (1.0, 1.0), "truncated_paraboloid": (1.0, 2.0), "rounded_punch": (3.0, 2.0)}
SHARPER = -0.85


@pytest.mark.parametrize("name", EDGED)
def test_beyond_an_edge_the_length_of_the_print_is_solved_for(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    assert float(SHARP) == _unknowns.SHARP
    first, last = EDGED[name]
    found = list(graded_unknowns(stored(f"{name}.fgm")))
    for own in (own for own in found if own.small != JOINED):
        radius, length = equation(own, "a"), equation(own, "t")
        ends = np.array(first + K), np.array(last + (1.0 + K if own.suffixes == ("aF",) else 0.0))
        assert f"({first} + k, {last + 1.0 if own.suffixes == ('aF',) else last}" in source(f"{name}.fgm")
        for x in (0.6, 2.3):
            printed = number(radius, t=number(length, x=x))
            met = radius_at(monkeypatch, x, _graded_inverse.contact_beyond, np.array([R]), (), ends)
            assert met == pytest.approx(printed, rel=1e-14, abs=0.0)
    joined = [own for own in found if own.small == JOINED]
    assert len(joined) == (2 if first == 1.0 else 0)
    for own in joined:
        ends = np.array(first + SHARPER), np.array(last + (1.0 + SHARPER if own.suffixes == ("aF",) else 0.0))
        for t in (0.4, 3.0):
            x = float(equation(own, "x").subs({nt.k: SHARPER, T: t}))
            assert float(_unknowns.root_of(np.array(x), *ends)[0]) == pytest.approx(t, rel=1e-12, abs=0.0)


GIVEN = {"R1": 2.5, "R2": 1.1, "theta": 0.42, "b": 0.7, "H": 1.9, "h": 0.3, "s": 1.4, "R": 1.3}
LOADED = {"ad": "depth", "aF": "force"}


def starts(name: str, suffix: str, load: Any, k: float, monkeypatch: pytest.MonkeyPatch) -> list[float]:
    """Where the iterations behind a radius on the graded half-space begin."""
    begun: list[float] = []

    def look(curve: Callable[..., Any], value: Any, start: Any, *_: Any, **__: Any) -> Any:
        begun.append(float(np.ravel(start)[0]))
        return start + 0.0 * value

    with monkeypatch.context() as patched:
        for module in (_graded_inverse, _graded_across, _across):
            patched.setattr(module, "inverse", look)
        private(name, f"_radius_from_{LOADED[suffix]}", k)(np.atleast_1d(load))
    return begun


def private(name: str, function: str, k: float) -> Callable[..., Any]:
    """A function of a module over its first argument, at the parameters given."""
    own = getattr(import_module(f"axicontact.graded.normal.{name}"), function)
    last = [key for key in inspect.signature(own).parameters if key in GIVEN or key == "k"]
    quiet = np.errstate(all="ignore")  # as `elementwise` calls it
    return quiet(lambda first: own(first, *(np.array([GIVEN.get(key, k)]) for key in last)))


def loaded(name: str, suffix: str, k: float, a: float) -> Any:
    """The load at a radius, and the values at which the print has it."""
    load = float(private(name, f"_{LOADED[suffix]}", k)(np.array([a]))[0])
    profile = stored(f"{name}.fgm")["d"].profile
    known = {nt.describe(key).symbol: sp.Rational(str(value)) for key, value in GIVEN.items()}
    known |= {short: expr.subs(known) for short, expr in profile.abbreviations}
    return load, known | {nt.k: sp.Rational(str(k)), (nt.d if suffix == "ad" else nt.F): sp.Float(load, 30)}


def where(value: sp.Expr, symbol: sp.Symbol, want: float, known: dict[sp.Symbol, Any]) -> Any:
    """The value of an increasing unknown at which another one takes a value."""
    curve = sp.lambdify(symbol, value.subs(known), "mpmath")
    return sp.Float(mp.findroot(lambda x: curve(x) - want, (1e-3, 1e3), solver="anderson", maxsteps=500, tol=1e-25), 20)


STARTED = {"truncated_cone": 1.1, "truncated_paraboloid": 1.1, "rounded_punch": 1.1, "sphere": 1.1, "ellipsoid": 0.5,
           "gaussian": 1.1}  # fmt: skip


@pytest.mark.parametrize("name", STARTED)
@pytest.mark.parametrize("suffix", LOADED)
@pytest.mark.parametrize("k", [K, SHARPER])
def test_the_starts_of_the_print_are_those_of_the_modules(
    name: str, suffix: str, k: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    rows = [own for own in graded_unknowns(stored(f"{name}.fgm")) if own.suffixes == (suffix,)]
    load, known = loaded(name, suffix, k, STARTED[name])
    own = rows[0]
    if name == "gaussian":
        known[END] = sp.Float(_graded_inverse.gaussian_reach(GIVEN["s"], np.array(k)).item(), 20)
        known[LAST] = equation(own, "x_1").subs(known)
    elif own.remark.startswith("$a_0$"):
        known[FIRST] = equation(own, "a").subs(known).subs(T, where(equation(own, "x"), T, 0.5, known))
    elif k < float(SHARP) - 1 and len(rows) > 1:
        known[LAST] = equation(rows[1], "x").subs(known).subs(T, 1)
    elif own.remark:
        known[LAST] = where(equation(own, "t"), X, 1.0, known)
    printed = evaluate(own.equations[-1].value, known, 15)
    assert starts(name, suffix, load, k, monkeypatch) == pytest.approx([float(printed)], rel=1e-9)


@pytest.mark.parametrize("name", ["capped_paraboloid", "rounded_cone", "rounded_curved_punch", "sphere_tipped_cone"])
@pytest.mark.parametrize("suffix", LOADED)
def test_below_a_break_the_start_is_the_power_of_the_tip(
    name: str, suffix: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    own = next(own for own in graded_unknowns(stored(f"{name}.fgm")) if own.suffixes == (suffix,))
    assert own.small == "a<b"
    load, known = loaded(name, suffix, K, 0.4)
    if name == "sphere_tipped_cone":
        known[LAST] = equation(next(iter(graded_unknowns(stored(f"{name}.fgm")))), "x_1").subs(known)
    printed = float(evaluate(own.equations[-1].value, known, 15))
    assert starts(name, suffix, load, K, monkeypatch)[0] == pytest.approx(printed, rel=1e-9)


@pytest.mark.parametrize("suffix", LOADED)
@pytest.mark.parametrize("k", [K, SHARPER])
@pytest.mark.parametrize("a", [0.75, 3.0])
def test_beyond_a_break_the_start_is_read_from_both_terms(
    suffix: str, k: float, a: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    """c and C from the formula itself and its slope, at the place that the print names."""
    assert 10.0**READ == _graded_across.CLOSE
    assert f"in value and slope at $t=t_1 y=10^{{{READ}}}$" in next(
        own.remark for own in graded_unknowns(stored("sphere_tipped_cone.fgm")) if own.small == "a>b"
    )
    name = "capped_paraboloid"
    rows = list(graded_unknowns(stored(f"{name}.fgm")))
    own = next(own for own in rows if own.suffixes == (suffix,) and own.small == "a>b")
    length = next(own for own in rows if own.small == (BENT if k > float(SHARP) - 1 else JOINED))
    load, known = loaded(name, suffix, k, a)
    below, beyond = (case.expr for case in stored(f"{name}.fgm")["d" if suffix == "ad" else "F"].cases)
    more = beyond.subs(nt.a, nt.b * sp.sqrt(1 + T**2)) - below.subs(nt.a, nt.b)
    met = [evaluate(expr, known | {T: sp.Integer(10) ** READ}, 20) for expr in (more, sp.diff(more, T) * T)]
    terms = LEADING * T ** (1 + nt.k) + NEXT * T**2
    pair = [side.subs(known).subs(T, sp.Integer(10) ** READ) - sp.Float(want, 20)
            for side, want in zip((terms, sp.diff(terms, T) * T), met, strict=True)]  # fmt: skip
    known |= sp.solve(pair, (LEADING, NEXT))
    known[JOINT] = equation(own, "t_1").subs(known)
    x = sp.Float(evaluate(equation(own, "x_0"), known, 20), 20)
    y = (
        equation(length, "y").subs(known).subs(X, x)
        if length.small == BENT
        else where(equation(length, "x"), SHARE, x, known)
    )
    t = float(y * known[JOINT])
    if suffix == "aF" and t > 1:
        assert "$t_0>1$ is raised to $2/(k+3)$" in own.remark
        y = sp.Float(t ** (2 / (k + 3)) / float(known[JOINT]), 20)
        x = (
            where(equation(length, "y"), X, y, known)
            if length.small == BENT
            else equation(length, "x").subs(known).subs(SHARE, y)
        )
    assert starts(name, suffix, load, k, monkeypatch) == pytest.approx([float(x)], rel=1e-6)


def test_below_a_vertical_flank_the_length_of_the_print_is_solved_for(monkeypatch: pytest.MonkeyPatch) -> None:
    for own in graded_unknowns(stored("sphere.fgm")):
        radius, like = equation(own, "a"), equation(own, "x")
        tip = np.array(2.0 if own.suffixes == ("ad",) else 3.0 + K)
        for t in (0.4, 3.0):
            x, at = number(like, t=t), (np.array([R]), (), tip, np.array(K))
            found = radius_at(monkeypatch, x, _graded_inverse.contact_below, *at)
            assert found == pytest.approx(number(radius, t=t), rel=1e-13, abs=0.0)
    for own in graded_unknowns(stored("sphere_tipped_cone.fgm")):
        if own.small == "a<b" and len(own.suffixes) == 2:
            printed = number(equation(own, "x"), a=0.9)
            assert float(_unknowns.up_to(np.array(R), np.array(K)).of(np.array(0.9))) == pytest.approx(
                printed, rel=1e-14
            )


def test_on_a_bump_the_length_of_the_print_is_solved_for(monkeypatch: pytest.MonkeyPatch) -> None:
    own = next(iter(graded_unknowns(stored("gaussian.fgm"))))
    unknown, share, last = (equation(own, left) for left in ("t", "x", "x_1"))
    end = 1.9
    for a in (0.3, 1.2, 1.8):
        t = number(unknown.subs(X, share).subs(LAST, last), a_1=end, a=a)
        bump = _unknowns.on_the_bump(np.array(R))
        found = radius_at(monkeypatch, t, _graded_inverse.radius_up_to, np.array([end]), (), bump)
        assert found == pytest.approx(a, rel=1e-12, abs=0.0)
