"""The hand-written part of the package: nodes, special functions, rules and the root finder."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path
from typing import Any

import mpmath as mp
import numpy as np
import pytest
from stored_book import kernels

import axicontact
from axicontact._runtime import inverse as roots
from axicontact._runtime.nodes import gauss_legendre
from axicontact._runtime.shapes import across as breaks
from axicontact._runtime.shapes import arcs
from axicontact._runtime.shapes.powers import power_displacement, power_pressure, power_punches
from axicontact._runtime.special import arctan_gap, dawson, gamma_ratio, struve_h0, struve_h1, tanh_gap
from axiderive.code import tables as certified
from axiderive.code.module import PLACE, runtime_sources
from axiderive.code.programs import FOLDER
from axiderive.code.tables import bounds, kernels_source

EPS = np.finfo(float).eps
FOUR_ULP, SIXTEEN_ULP = 4 * EPS, 16 * EPS


def test_the_package_holds_the_files_of_the_engine() -> None:
    """And what is generated beside them; in the root of the package there is no module of the run time but one."""
    root, wanted = Path(axicontact.__file__).parent, runtime_sources()
    assert {path: (root / path).read_text() for path in wanted} == wanted
    found = {path.relative_to(root).as_posix() for path in (root / PLACE).rglob("*.py")}
    generated = {f"{PLACE}/{name}.py" for name in ("intervals", "kernels", "nodes", "symbols")}
    assert found == {path for path in wanted if path.startswith(PLACE)} | generated
    assert {path.name for path in root.glob("_*")} - {"__pycache__"} == {PLACE, FOLDER, "__init__.py"}


def test_the_run_time_works_where_it_stands() -> None:
    """In the engine, with nothing of the catalogue but what is generated: of a change no build is needed to see it."""
    code = """
import sys, importlib, pkgutil, numpy
import axicontact._runtime as package, axiderive.runtime as own
own.__path__.append(*package.__path__)
found = {one.name for one in pkgutil.walk_packages(own.__path__, own.__name__ + ".")}
for name in sorted(found):
    importlib.import_module(name)
from axiderive.runtime.interface import elementwise
from axiderive.runtime.integrals import difference_root
def _root(r, a):
    return difference_root(a, r)
print(len(found), elementwise(_root, 3.0, 5.0), elementwise(_root, numpy.full(2, 3e200), 5e200))
print(sorted(name for name in sys.modules if name.startswith("axicontact.")))
"""
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert not run.stderr, run.stderr
    found, number, *array = run.stdout.splitlines()[0].split(maxsplit=2)
    assert int(found) >= 40
    assert (number, array) == ("4.0", ["[4.e+200 4.e+200]"])
    assert run.stdout.splitlines()[1] == "['axicontact._runtime']"


@pytest.mark.parametrize("count", [16, 24, 32, 64])
def test_nodes_integrate_polynomials(count: int) -> None:
    x, w = gauss_legendre(count)
    assert len(x) == count
    for power in (0, 1, 7, 2 * count - 1):
        assert np.sum(w * x**power) == pytest.approx(1 / (power + 1), rel=SIXTEEN_ULP, abs=0.0)


def test_nodes_are_those_of_arb_to_the_last_bit() -> None:
    x, w = gauss_legendre(32)
    for (node, weight), got, factor in zip(certified.gauss_legendre(32)[:16], x, w, strict=False):
        assert (node, weight) == (got, factor)


@pytest.mark.parametrize(
    ("function", "reference", "arguments", "tolerance"),
    [
        (arctan_gap, lambda x: x - mp.atan(x), np.geomspace(1e-8, 1e6, 60), FOUR_ULP),
        (lambda y: tanh_gap(y, np.tanh(y)), lambda y: y - mp.tanh(y), np.geomspace(1e-8, 40.0, 60), FOUR_ULP),
        (gamma_ratio, lambda x: mp.gamma(x + 0.5) / mp.gamma(x), np.geomspace(1e-6, 1e6, 60), FOUR_ULP),
        (dawson, lambda x: mp.exp(-x * x) * mp.erfi(x) * mp.sqrt(mp.pi) / 2, np.linspace(1e-3, 1.5625, 60), FOUR_ULP),
    ],
)
def test_functions_of_one_sign(function: object, reference: object, arguments: np.ndarray, tolerance: float) -> None:
    got = function(arguments)  # type: ignore[operator]
    with mp.workdps(60):
        for x, value in zip(arguments, got, strict=True):
            wanted = reference(mp.mpf(x))  # type: ignore[operator]
            assert abs(mp.mpf(value) - wanted) <= tolerance * abs(wanted), (x, value, wanted)


@pytest.mark.parametrize(("order", "function"), [(0, struve_h0), (1, struve_h1)])
def test_struve_functions(order: int, function: object) -> None:
    """H_0 has zeros, so its error is measured against its envelope sqrt(2/(pi z)); 3.5 EPS on 1200 points."""
    arguments = np.concatenate([np.geomspace(1e-6, 4.0, 40), np.geomspace(np.nextafter(4.0, 5.0), 1e4, 60)])
    got = function(arguments)  # type: ignore[operator]
    for z, value in zip(arguments, got, strict=True):
        wanted = mp.struveh(order, mp.mpf(z))
        scale = max(abs(wanted), mp.sqrt(2 / (mp.pi * z)) if z > 1 else 0)
        assert abs(value - wanted) <= 4 * EPS * scale, (z, value, wanted)


def test_strips_of_an_arc_against_their_definition() -> None:
    """On both sides of the end of the kernel, next to the edge, at the centre and for an arc of almost a quarter."""
    for size in (1e-6, 0.3, 0.6, 0.69, 0.71, 0.9, 1.0 - 1e-9):
        r = size * np.array([0.0, 1e-9, 0.2, 0.7, 0.95, 1.0 - 1e-7])
        with np.errstate(all="ignore"):
            got = arcs.arc_strips(r, np.full_like(r, size), np.ones_like(r))
        for x, value in zip(r, got, strict=True):
            with mp.workdps(40):
                a, y = mp.mpf(size), mp.mpf(x)
                reach, below = mp.sqrt((a - y) * (a + y)), 1 + mp.sqrt((1 - y) * (1 + y))
                wanted = chi((a + reach) / below) - chi((a - reach) / below)
            assert abs(value - wanted) <= 6 * EPS * wanted, (size, x, value, wanted)


def chi(x: mp.mpf) -> mp.mpf:
    return mp.re(mp.polylog(2, x) - mp.polylog(2, -x)) / 2


def test_power_integrals_against_their_definitions() -> None:
    for n in (0.5, 1.0, 2.5, 12.0):
        for ratio in (1e-3, 0.4, 0.99):
            one, r = np.array([1.0]), np.array([ratio])
            with mp.workdps(30):
                inside = mp.quad(lambda v: (ratio * mp.cosh(v)) ** (n - 1), [0, mp.acosh(1 / mp.mpf(ratio))])  # noqa: B023
                angle = mp.asin(mp.mpf(ratio))
                punches = mp.quad(lambda p: (mp.sin(p) / ratio) ** n, [0, angle / 100, angle])  # noqa: B023
            with np.errstate(all="ignore"):  # as `elementwise` sees to: unused branches divide by zero
                pressure, sunk, outside = (
                    power_pressure(r, one, n),
                    power_punches(one, r, n),
                    power_displacement(one, r, n),
                )
            assert pressure[0] == pytest.approx(float(inside), rel=SIXTEEN_ULP, abs=0.0)
            assert sunk[0] == pytest.approx(float(punches), rel=SIXTEEN_ULP, abs=0.0)
            assert outside[0] == pytest.approx(float(angle - punches), rel=SIXTEEN_ULP, abs=0.0)


def test_inverse_keeps_to_the_bracket_where_newton_overshoots() -> None:
    """A curve whose slope jumps: Newton alone cycles between the two sides."""

    def curve(t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        steep = t > 1.0
        return np.where(steep, t**9, t), np.where(steep, 9.0, 1.0)

    value = np.array([1e-8, 0.999, 1.0, 1.001, 7.0, 1e9])
    root = roots.inverse(curve, value, np.full(6, 1e3), (1.0, 9.0))
    np.testing.assert_allclose(root, np.where(value > 1, value ** (1 / 9), value), rtol=SIXTEEN_ULP)


def test_domains_are_read_off_the_notation() -> None:
    assert bounds("0 < theta < pi/2") == ("0.0", "1.5707963267948966", "")
    assert bounds("R > 0") == ("0.0", "inf", "")
    assert bounds("dgamma >= 0") == ("0.0", "inf", "low")
    assert bounds("-1 < nu <= 1/2") == ("-1.0", "0.5", "high")
    with pytest.raises(ValueError, match="not an interval"):
        bounds("0 <= c <= a")


def test_a_root_across_an_infinite_slope_takes_few_steps() -> None:
    """Next to the corner of a capped paraboloid too, where Newton's iteration in the radius took 120 steps."""
    calls = []

    def curve(a: np.ndarray, root: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        calls.append(a)
        return a * (a + 3.0 * root), 2.0 * a * a + 3.0 * a * root + np.where(a > 1.0, 3.0 * a * a * (a / root), 0.0)

    radii = np.array([1e-3, 0.999, 1.0 - 1e-14, 1.0 + 1e-14, 1.0 + 1e-9, 1.001, 2.0, 1e3])
    for a in (*radii[:, None], radii):
        calls.clear()
        with np.errstate(all="ignore"):
            value = curve(a, np.sqrt(np.maximum(a - 1.0, 0.0) * (a + 1.0)))[0]
            across = breaks.inverse_across(curve, value, 1.0, 2.0)
            assert len(calls) <= 2 + 6, (a, len(calls))
            beyond = breaks.inverse_beyond(curve, value, 1.0, 2.0, leaving=(1.0, 2.0))
        np.testing.assert_allclose(across, a, rtol=4 * EPS)
        np.testing.assert_allclose(beyond, a, rtol=4 * EPS)


QUICK = (
    "ARCTAN_GAP",
    "LEGENDRE_CHI",
    "ROOT_GAP",
    "TANH_GAP",
    "DAWSON",
    "STRUVE_0",
    "STRUVE_1",
    "GAMMA_RATIO",
    "OUTSIDE_2",
    "OUTSIDE_6",
)
"""Kernels that are fitted in a second; all of them take six."""


def test_some_kernels_of_the_catalogue_are_what_a_fit_gives(monkeypatch: pytest.MonkeyPatch) -> None:
    """Every other test takes them from there; with a rational kernel, a polynomial and what starts from a value."""
    for table in ("KERNELS", "STARTS"):
        monkeypatch.setattr(
            certified, table, {name: own for name, own in getattr(certified, table).items() if name in QUICK}
        )
    head, *fitted = kernels_source.__wrapped__().rstrip().split("\n\n# ")
    # behind them stand the places of the arcs
    assert len(fitted) == len(QUICK) + 1
    assert kernels().startswith(head)
    assert set(fitted) <= set(kernels().rstrip().split("\n\n# "))


@pytest.mark.slow
def test_the_kernels_of_the_catalogue_are_what_a_fit_gives() -> None:
    assert kernels_source() == kernels()


def test_every_kernel_of_the_catalogue_is_its_function() -> None:
    """To a unit of a double, or of the result of which the kernel is a share; 0.97 units are measured next to zero."""
    found: dict[str, Any] = {}
    exec(kernels(), found)
    peak, end, bend = (found.pop(name) for name in ("ARC_PEAK", "ARC_END", "ARC_BEND"))
    assert {name for name in found if name.isupper()} == {*certified.KERNELS, *certified.STARTS}
    with mp.workdps(40):
        assert abs(mp.diff(certified.arc_level, peak)) < EPS
        assert abs(certified.arc_level(certified.arc_peak() + end) / bend - 1) < EPS
        for name, (_, function, end, *start) in {**certified.KERNELS, **certified.STARTS}.items():
            top, bottom, *rest = found[name]
            assert rest == [float(value) for value in start]
            for share in ("0.013", "0.37", "0.71", "0.98"):
                v = mp.mpf(end) * mp.mpf(share)
                value = mp.polyval(top[::-1], v) / mp.polyval(bottom[::-1], v)
                whole = start[0] + v * value if start else value
                assert abs(whole / function(v) - 1) < EPS, (name, share)
