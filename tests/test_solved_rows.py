"""What the inverses without a root of their own are solved for, in print and in the modules."""

from __future__ import annotations

import random
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
import sympy as sp
from misprints import misprints
from stored_book import CATALOGUE, stored
from test_evaluated_physics import as_read, passes, rows_of

from axicontact import _graded_inverse, _unknowns
from axiderive import notation as nt
from axiderive.contact.systems import problem
from axiderive.emit.readback.further import wrong
from axiderive.emit.unknowns import LAST, NAMES, SHARP, X, graded_unknowns, unknowns

ROWS = [
    (key, row)
    for key in ("polynomial", "wavy_paraboloid", "gaussian", "hyperboloid", "truncated_paraboloid.fgm",
                "rounded_punch.fgm", "ellipsoid.fgm", "hyperboloid.fgm", "wavy_paraboloid.fgm",
                "sphere_tipped_cone.fgm", "gaussian.fgm")
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
        ("hyperboloid", "np.full_like(d, b / 1000)"), ("hyperboloid.fgm", "d, 1.5 * b,"), ("polynomial.fgm", "d, 1.0,"),
        ("wavy_paraboloid.fgm", "d, 1.5 * wavelength,"), ("gaussian", "largest = 1.5019752682686114 * s *"),
        ("wavy_paraboloid", "unit = wavelength / (2 * np.pi)"),
        ("polynomial", "(np.log(F / term) / (j + 1) for j, term in enumerate(alone, 1))"),
    ):  # fmt: skip
        assert text in source(key)
    (first,) = (own.equations for own in unknowns(stored("gaussian")))
    assert [equation.right for equation in first] == [r"\frac{a_1}{1+t}", r"1.5019752682686114\,s"]


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


EDGED = {"truncated_cone": (1.0, 1.0), "truncated_paraboloid": (1.0, 2.0), "rounded_punch": (3.0, 2.0)}


@pytest.mark.parametrize("name", EDGED)
def test_beyond_an_edge_the_length_of_the_print_is_solved_for(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    assert float(SHARP) == _unknowns.SHARP
    first, last = EDGED[name]
    for own in graded_unknowns(stored(f"{name}.fgm")):
        _, radius, length = (equation.value for equation in own.equations)
        ends = np.array(first + K), np.array(last + (1.0 + K if own.suffixes == ("aF",) else 0.0))
        assert f"({first} + k, {last + 1.0 if own.suffixes == ('aF',) else last}" in source(f"{name}.fgm")
        for x in (0.6, 2.3):
            printed = number(radius, t=number(length, x=x))
            found = radius_at(monkeypatch, x, _graded_inverse.radius_beyond, np.array([R]), (), ends)
            assert found == pytest.approx(printed, rel=1e-14)


def test_below_a_vertical_flank_the_length_of_the_print_is_solved_for(monkeypatch: pytest.MonkeyPatch) -> None:
    for own in graded_unknowns(stored("sphere.fgm")):
        _, radius, like = (equation.value for equation in own.equations)
        tip = np.array(2.0 if own.suffixes == ("ad",) else 3.0 + K)
        for t in (0.4, 3.0):
            x, at = number(like, t=t), (np.array([R]), (), tip, np.array(K))
            found = radius_at(monkeypatch, x, _graded_inverse.radius_below, *at)
            assert found == pytest.approx(number(radius, t=t), rel=1e-13)
    for own in graded_unknowns(stored("sphere_tipped_cone.fgm")):
        if own.letter == "x":
            printed = number(own.equations[0].value, a=0.9)
            assert float(_unknowns.up_to(np.array(R), np.array(K)).of(np.array(0.9))) == pytest.approx(
                printed, rel=1e-14
            )


def test_on_a_bump_the_length_of_the_print_is_solved_for(monkeypatch: pytest.MonkeyPatch) -> None:
    (own,) = graded_unknowns(stored("gaussian.fgm"))
    unknown, share, last, _ = (equation.value for equation in own.equations)
    end = 1.9
    for a in (0.3, 1.2, 1.8):
        t = number(unknown.subs(X, share).subs(LAST, last), a_1=end, a=a)
        bump = _unknowns.on_the_bump(np.array(R))
        found = radius_at(monkeypatch, t, _graded_inverse.radius_up_to, np.array([end]), (), bump)
        assert found == pytest.approx(a, rel=1e-12)
