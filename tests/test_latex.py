"""Printed formulas: as a person would write them, and equal to what they were printed from."""

from __future__ import annotations

import dataclasses
import random
import re

import mpmath as mp
import pytest
import sympy as sp

from axiderive import notation as nt
from axiderive.contact.normal import derive
from axiderive.contact.systems import BY_NAME, Problem, problem, problems
from axiderive.emit.blocks import rows_of
from axiderive.emit.latex import entry_latex, latex
from axiderive.emit.printed import holds
from axiderive.emit.readback import read
from axiderive.emit.reading import integrates, worst_residual
from axiderive.emit.rows import Region, Row, row
from axiderive.emit.width import width
from axiderive.entry import Entry
from axiderive.profiles import load

READ_BACK = mp.mpf(10) ** -20
"""A printed row agrees with its entry to twenty digits or it does not agree."""

E, F, a, b, d, r, R, theta = nt.E_star, nt.F, nt.a, nt.b, nt.d, nt.r, nt.R, nt.theta
INTEGRALS = {"sphere_tipped_cone", "wavy_paraboloid"}
"""Profiles whose read-back integrates for many seconds."""


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
    ],
)
def test_print(expr: sp.Expr, chain: tuple[sp.Symbol, ...], wanted: str) -> None:
    assert latex(expr, chain) == wanted


def test_seventh_root_of_a_large_number_becomes_a_power_that_can_be_read() -> None:
    entry = derive(load("sextic"))["dF"]
    assert entry_latex(entry) == r"d=\tfrac{1}{20} \sqrt[7]{A \, \Bigl(\frac{70 F_{\mathrm N}}{3 E^{*}}\Bigr)^{6}}"


def test_a_sum_of_fields_does_not_start_with_a_minus() -> None:
    """The largest coefficient decides about plain polynomials only."""
    text = row(derive(load("concave_quartic"))["p"]).regions[0].tex
    assert text.startswith(r"p(r)=\frac{E^{*}}{\pi}")


def test_cases_have_the_variable_on_the_left() -> None:
    text = entry_latex(derive(load("sphere"))["w"])
    assert text.startswith(r"w(r)=\begin{cases}")
    assert r"& a\le r< R \\" in text
    assert r"& r> R\end{cases}" in text


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
        (r"\sum_{j=1}^{3} j^{2}", 14),
        (r"F_{\mathrm N} x", 6),
    ],
)
def test_reading(tex: str, value: float | str) -> None:
    env = {"x": mp.mpf(3), "E*": mp.mpf(7), "F_N": mp.mpf(2)}
    want = mp.mpf(value) if not isinstance(value, str) else sp.sympify(value).evalf(20)
    assert abs(read(tex)[0].members[0](env) - want) < 1e-14


@pytest.mark.parametrize("tex", [r"\frac{a", r"a)", r"\sqrt{}", r"a+", r"\mathrm{F} x"])
def test_what_cannot_be_read_is_an_error(tex: str) -> None:
    with pytest.raises(SyntaxError):
        read(tex)


def test_reading_a_row_with_definitions_and_a_range() -> None:
    statements = read(r"w=s+\psi,\qquad s=\sqrt{r^{2}-a^{2}},\quad \psi=\arcsin \frac{a}{r}")
    assert [statement.members[0].name for statement in statements] == ["w", "s", "psi"]
    env = {"a": mp.mpf(1), "r": mp.mpf(2), "R": mp.mpf(3)}
    assert holds(r"a\le r< R", env)
    assert holds("r> a", env)
    assert not holds(r"a\le r,\; R< r", env)


def test_names_that_mean_two_things_are_told_apart() -> None:
    """chi_2, Ti_2 and C_0 are functions; a bare letter before a bracket is a factor."""
    env = {"a": mp.mpf(2), "b": mp.mpf(3)}
    assert read(r"a (b+1)")[0].members[0](env) == 8
    assert abs(read(r"\chi_{2}(1/2)")[0].members[0](env) - mp.mpf("0.5153252594967")) < 1e-3


def _rows(key: str) -> tuple[list[Row], dict[str, Entry], dict[str, Entry]]:
    """Rows of a problem, its entries, and those of the normal contact that its rules refer to."""
    own = problem(key)
    graded = own.system.name.startswith("graded")
    normal = Problem(BY_NAME["graded.normal" if graded else "normal"], own.name)
    entries = own.derive()
    base = normal.derive() if own.system.rests_on else entries
    return rows_of(own.system, entries, {normal.key: base, key: entries}, own.name), entries, base


QUICK = [p.key for p in problems() if p.system.name == "normal" and p.name not in INTEGRALS] + [
    "cone.adh", "paraboloid.fgm", "paraboloid.fgm.adh", "power_law.adh", "power_law.fgm.tan", "polynomial.tan",
    "truncated_cone.adh", "truncated_cone.tan", "rounded_punch.adh", "sphere.vis", "cone.vis",
    "power_law.vis", "capped_cylinder.fgm", "capped_cylinder.vis", "concave_quartic.adh", "flat_punch.fgm.adh",
    *(p.key for p in problems() if p.system.pool.prefix), "materials",
]  # fmt: skip
"""Every homogeneous normal contact, and of the other systems what brings every kind of row."""


@pytest.mark.parametrize("key", QUICK)
def test_every_row_says_what_its_entry_is(key: str) -> None:
    rows, entries, base = _rows(key)
    for one in rows:
        if not integrates(one, base):
            assert worst_residual(one, entries, count=1, base=base) < READ_BACK, one.key


@pytest.mark.sweep
@pytest.mark.parametrize("key", [p.key for p in problems()])
def test_every_row_of_the_book_says_what_its_entry_is(key: str) -> None:
    rows, entries, base = _rows(key)
    for one in rows:
        assert worst_residual(one, entries, count=1, seed=29, base=base) < READ_BACK, one.key


@pytest.mark.parametrize("key", QUICK)
def test_rows_hold_every_entry_and_fit_their_line(key: str) -> None:
    rows, entries, _ = _rows(key)
    assert {entry.key for one in rows for entry in (one.entry, *one.also)} == {e.key for e in entries.values()}
    for one in rows:
        for region in one.regions:
            assert region.tex.count("{") == region.tex.count("}")
            assert not re.search(r"\\left(?![a-z])", region.tex)
            assert all(width(line) < 375 for line in region.lines), one.key


MUTATED = ("cone", "sphere", "power_law", "truncated_paraboloid", "hyperboloid", "concave_quartic", "capped_cylinder")
SWAPS = {
    "+": "-", "-": "+", r"\arcsin": r"\arccos", r"\arccos": r"\arcsin", r"\arctan": r"\arcsin", r"\tan": r"\sin",
    "artanh": "arsinh", "arcosh": "arsinh", "a": "r", "r": "a", "b": "a", "R": "a", "d": "a", "A": "h", "n": "a",
    "s": "a", r"\pi": "3", r"\kappa": "a", r"\psi": "a", "F": "E", "E": "F", r"\sqrt": r"\sin", "q": "a", r"\ell": "a",
}  # fmt: skip
TOKEN = re.compile(r"\\[A-Za-z]+|artanh|arcosh|\d|[A-Za-z]|[+\-]")
LAYOUT = re.compile(
    r"\\(?:begin|end)\{[^}]*\}(?:\[t\])?|\\\\\[[^\]]*\]|\\[Bb]ig[lr]|\\q?quad|\\enspace|\\mathrm|\\operatorname"
)


def _mutants(tex: str, rng: random.Random, count: int) -> list[str]:
    """The text with one token changed, behind the first equals sign and outside the layout."""
    start = tex.index("=") + 1
    layout = [match.span() for match in LAYOUT.finditer(tex)]
    places = [
        match
        for match in TOKEN.finditer(tex, start)
        if not any(lo <= match.start() < hi for lo, hi in layout) and (match[0] in SWAPS or match[0].isdigit())
    ]
    found = []
    for match in rng.sample(places, min(count, len(places))):
        new = str((int(match[0]) + 1) % 10 or 1) if match[0].isdigit() else SWAPS[match[0]]
        glue = " " if new[-1:].isalpha() and tex[match.end() : match.end() + 1].isalpha() else ""
        found.append(tex[: match.start()] + new + glue + tex[match.end() :])
    return found


def _survives(
    one: Row, region: Region, mutant: str, entries: dict[str, Entry], base: dict[str, Entry] | None = None
) -> bool:
    changed = tuple(dataclasses.replace(r, lines=(mutant,)) if r is region else r for r in one.regions)
    try:
        return bool(worst_residual(dataclasses.replace(one, regions=changed), entries, count=3, base=base) < READ_BACK)
    except (SyntaxError, LookupError, ValueError, TypeError, ArithmeticError, RecursionError, mp.libmp.NoConvergence):
        return False


SUPERPOSED = (
    "cone.adh", "paraboloid.fgm", "cone.fgm.adh", "power_law.adh", "cone.tan", "cone.vis", "sphere.vis",
    "plane.parabola", "plane.rounded_wedge", "loads.uniform", "materials",
)  # fmt: skip


@pytest.mark.parametrize("key", SUPERPOSED)
def test_a_misprint_of_a_rule_does_not_survive(key: str) -> None:
    """The same for the other kinds of contact: formulas, equations to be solved and rules of superposition."""
    rng = random.Random(f"misprints {key}")
    rows, entries, base = _rows(key)
    survivors = []
    for one in rows:
        for region in one.regions:
            mutants = _mutants(region.tex, rng, 3)
            survivors += [
                f"{one.key}: {m}" for m in mutants if m != region.tex and _survives(one, region, m, entries, base)
            ]
    assert survivors == []


@pytest.mark.parametrize("name", MUTATED)
def test_a_misprint_does_not_survive(name: str) -> None:
    """One token of a formula row changed: sign, digit, function or symbol."""
    rng = random.Random(f"misprints {name}")
    entries = derive(load(name))
    tried, survivors = 0, []
    for suffix in ("d", "F", "p", "w", "aF", "dF"):
        if suffix not in entries or row(entries[suffix]).kind != "formula":
            continue
        one = row(entries[suffix])
        for region in one.regions:
            mutants = _mutants(region.tex, rng, 6)
            tried += len(mutants)
            survivors += [f"{one.key}: {m}" for m in mutants if m != region.tex and _survives(one, region, m, entries)]
    assert tried >= 15
    assert survivors == []
