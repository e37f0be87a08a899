"""The form in which formulas are printed: the same value, in the form that is read best; labels and cut curves."""

from __future__ import annotations

import pytest
import sympy as sp

from axiderive.figures.axes import labelled
from axiderive.figures.plots import TOP, cut
from axiderive.notation import A, E_star, R, a, c, d, k, mu, r
from axiderive.print.formula import Printer
from axiderive.print.terms import tidied

CASES = {
    r"\bigl[(k+1) d R\bigr]^{(k+3)/2}": (sp.sqrt(R) * sp.sqrt(d) * sp.sqrt(k + 1)) ** (k + 3),
    r"\biggl(\frac{\sqrt{2} a}{R}\biggr)^{k+3}": (sp.sqrt(2) * a / R) ** (k + 3),
    r"(k+1) a^{2}+2 r^{2}": a**2 * k + a**2 + 2 * r**2,
    r"\tfrac{64}{15} \, \mu E^{*} A \, (a^{5}-c^{5})": mu * (
        sp.Rational(64, 15) * A * E_star * a**5 - sp.Rational(64, 15) * A * E_star * c**5
    ),
}  # fmt: skip


@pytest.mark.parametrize("wanted", CASES)
def test_a_formula_keeps_its_value_in_the_form_that_is_read_best(wanted: str) -> None:
    found = tidied(CASES[wanted])
    values = {s: sp.Rational(7 + 2 * i, 5 + i) for i, s in enumerate(sorted(found.free_symbols, key=str))}
    assert abs(sp.N((found / CASES[wanted]).subs(values), 30) - 1) < 1e-25
    assert Printer((c, a))(found) == wanted


def test_a_curve_towards_a_sharp_edge_is_cut_where_it_leaves_the_frame() -> None:
    def flat(x: float) -> float:
        return 0.5 / (1 - x) ** 0.5

    (x, y) = cut([(x, flat(x)) for x in (0.5, 0.9, 0.99)])[-1]
    assert y == TOP
    assert flat(x) == pytest.approx(TOP, rel=1e-12, abs=0.0)


def test_the_label_of_the_middle_curve_lies_on_it_where_there_is_room_for_half_of_it_only() -> None:
    family = [[(x / 50, slope * x / 50) for x in range(51)] for slope in (0.4, 0.7, 1.0)]
    placed = labelled(family, 1, "0", [], 0.36)
    assert placed.anchor == "center"
    assert placed.x > 0.8
