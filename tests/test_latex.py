"""Printed formulas: as a person would write them, and equal to what they were printed from."""

from __future__ import annotations

import re

import mpmath as mp
import pytest
import sympy as sp
from stored_book import on_pages, rows, stored

from axiderive import notation as nt
from axiderive.physics.normal import derive
from axiderive.physics.systems import problems
from axiderive.print.box import width
from axiderive.print.formula import Printer
from axiderive.profiles import load
from axiderive.readback.claims import holds
from axiderive.readback.grammar import read
from axiderive.rows.row import ROOM, row

E, F, a, b, d, r, R, theta = nt.E_star, nt.F, nt.a, nt.b, nt.d, nt.r, nt.R, nt.theta
INTEGRALS = {"sphere_tipped_cone", "wavy_paraboloid"}
"""Profiles whose long rows take seconds to print."""


@pytest.mark.parametrize(
    ("expr", "chain", "wanted"),
    [
        (sp.pi * E * a**2 * sp.tan(theta) / 2, (), r"\tfrac{\pi}{2} \, E^{*} a^{2} \tan \theta"),
        (sp.sqrt(R) * sp.sqrt(d), (), r"\sqrt{d R}"),
        (4 * E * sp.sqrt(R) * d ** sp.Rational(3, 2) / 3, (), r"\tfrac{4}{3} \, E^{*} \sqrt{d^{3} R}"),
        (sp.cbrt(6 * F * R / E) / 2, (), r"\sqrt[3]{\frac{3 F_{\mathrm N} R}{4 E^{*}}}"),
        (sp.sqrt(R - b) * sp.sqrt(R + b), (), r"\sqrt{R^{2}-b^{2}}"),
        (-(-2 * a**2 + r**2), (), r"2 a^{2}-r^{2}"),
        (1 / ((r - a) * (a + r)), (a, r), r"\frac{1}{r^{2}-a^{2}}"),
        (sp.sqrt(r**2 - a**2) - r + a * sp.asin(a / r), (a, r), r"a \arcsin \frac{a}{r}+\sqrt{r^{2}-a^{2}}-r"),
        (sp.elliptic_f(theta, r**2 / b**2), (), r"\mathrm{F}\bigl(\theta,\tfrac{r}{b}\bigr)"),
        (E**2 * sp.tan(theta) ** 3, (), r"E^{*2} \tan^{3} \theta"),
        (sp.gamma((nt.n + 1) / 2), (), r"\Gamma\bigl(\tfrac{n+1}{2}\bigr)"),
        ((nt.k + 1) * (a + r * nt.k), (), r"(k+1) \, (a+r k)"),
        (sp.cos(sp.pi * nt.k / 2), (), r"\cos \tfrac{\pi k}{2}"),
        (a ** ((1 - nt.k) / 2), (), "a^{(1-k)/2}"),
        (
            (F**4 * (nt.k + 1) ** 8 / (256 * E**4)) ** (1 / (nt.k + 5)),
            (),
            r"\Bigl[\frac{(k+1)^{2} F_{\mathrm N}}{4 E^{*}}\Bigr]^{4/(k+5)}",
        ),
        ((F**4 / (3 * E**4)) ** (1 / (nt.k + 5)), (), r"\Bigl(\frac{F_{\mathrm N}^{4}}{3 E^{*4}}\Bigr)^{1/(k+5)}"),
        (sp.sinh(F / b) ** 2, (), r"\sinh^{2} \frac{F_{\mathrm N}}{b}"),
        (1 / sp.sinh(theta), (), r"\frac{1}{\sinh \theta}"),
        (
            sp.sinh(sp.asinh(F * (sp.log((a + b) * r + R) + 1) / b) / 3) ** 2,
            (),
            r"\sinh^{2}\Bigl[\tfrac{1}{3} \, \operatorname{arsinh}\Bigl(\frac{F_{\mathrm N}}{b} \, "
            r"\bigl\{1+\ln\bigl[r \, (a+b)+R\bigr]\bigr\}\Bigr)\Bigr]",
        ),
    ],
)
def test_print(expr: sp.Expr, chain: tuple[sp.Symbol, ...], wanted: str) -> None:
    assert Printer(chain)(expr) == wanted


def test_seventh_root_of_a_large_number_becomes_a_power_that_can_be_read() -> None:
    entry = derive(load("sextic"))["dF"]
    (region,) = row(entry).regions
    assert region.tex == r"d=\tfrac{1}{20} \sqrt[7]{A \, \Bigl(\frac{70 F_{\mathrm N}}{3 E^{*}}\Bigr)^{6}}"


def test_a_sum_of_fields_does_not_start_with_a_minus() -> None:
    """The largest coefficient decides about plain polynomials only."""
    text = row(derive(load("concave_quartic"))["p"]).regions[0].tex
    assert text.startswith(r"p(r)=\frac{E^{*}}{\pi}")


def test_cases_have_the_variable_on_the_left() -> None:
    near, far = row(derive(load("sphere"))["w"]).regions
    assert near.lines[0].startswith(r"w(r)=")
    assert (near.condition, far.condition) == (r"a\le r< R", "r> R")


@pytest.mark.parametrize(
    ("tex", "value"),
    [
        (r"\frac12 x", 1.5),
        (r"\tfrac{1}{2}\,x^{2}-1", 3.5),
        (r"\sin x \cos x", "sin(3)*cos(3)"),
        (r"\sqrt[3]{9 x}", 3),
        (r"x/(x+1)", 0.75),
        (r"E^{*2}", 49),
        (r"\tan^{2} x", "tan(3)**2"),
        (r"\int_{0}^{x} t\,\mathrm{d}t", 4.5),
        (r"\int_0^x\frac{\mathrm dt}{t+1}", "log(4)"),
        (r"2\mathrm e^{-x^2}", "2*exp(-9)"),
        (r"\sum_{j=1}^{3} j^{2}", 14),
        (r"F_{\mathrm N} x", 6),
    ],
)
def test_reading(tex: str, value: float | str) -> None:
    env = {"x": mp.mpf(3), "E*": mp.mpf(7), "F_N": mp.mpf(2)}
    want = mp.mpf(value) if not isinstance(value, str) else sp.sympify(value).evalf(20)
    assert abs(read(tex)[0].members[0](env) - want) < 1e-14


@pytest.mark.parametrize("tex", [r"\frac{a", r"a)", r"\sqrt{}", r"a+", r"\mathrm{F} x", r"\int_0^1 t"])
def test_what_cannot_be_read_is_an_error(tex: str) -> None:
    with pytest.raises(SyntaxError):
        read(tex)


def test_reading_a_row_with_definitions_and_a_range() -> None:
    statements = read(r"w=s+\psi,\qquad s=\sqrt{r^{2}-a^{2}},\quad \psi=\arcsin \frac{a}{r}")
    assert [statement.members[0].name for statement in statements] == ["w", "s", "psi"]
    env = {"a": mp.mpf(1), "r": mp.mpf(2), "R": mp.mpf(3)}
    assert holds(r"a\le r< R", env)
    assert holds("r> a", env)
    assert holds(r"2\ge n", {"n": 2})
    assert holds(r"1< n\le 2", {"n": 2})
    assert not holds("1< n< 2", {"n": 2})
    assert not holds("n> 2", {"n": 2})
    assert not holds(r"a\le r,\; R< r", env)


def test_names_that_mean_two_things_are_told_apart() -> None:
    """chi_2, Ti_2 and C_0 are functions; a bare letter before a bracket is a factor."""
    env = {"a": mp.mpf(2), "b": mp.mpf(3)}
    assert read(r"a (b+1)")[0].members[0](env) == 8
    series = mp.nsum(lambda i: mp.mpf(1) / 2 ** (2 * i + 1) / (2 * i + 1) ** 2, [0, mp.inf])
    assert abs(read(r"\chi_{2}(1/2)")[0].members[0](env) - series) < 1e-14


QUICK = [p.key for p in problems() if p.system.name == "normal" and p.name not in INTEGRALS] + [
    "cone.adh", "paraboloid.fgm", "paraboloid.fgm.adh", "power_law.adh", "power_law.fgm.tan", "polynomial.tan",
    "truncated_cone.adh", "truncated_cone.tan", "rounded_punch.adh", "sphere.vis", "cone.vis",
    "power_law.vis", "capped_cylinder.fgm", "capped_cylinder.vis", "concave_quartic.adh", "flat_punch.fgm.adh",
    *(p.key for p in problems() if p.system.pool.prefix), "materials",
]  # fmt: skip
"""Every homogeneous normal contact, and of the other systems what brings every kind of row."""


@pytest.mark.parametrize("key", QUICK)
def test_rows_hold_every_entry_and_fit_their_line(key: str) -> None:
    assert {e.key for one in rows(key) for e in (one.entry, *one.also)} == {e.key for e in on_pages(stored(key))}
    for one in rows(key):
        for region in one.regions:
            assert region.tex.count("{") == region.tex.count("}")
            assert not re.search(r"\\left(?![a-z])", region.tex)
            assert all(width(line) <= ROOM for line in region.lines), one.key
