"""The corpus of Abel integrals: the engine answers all of them, SymPy's integrate not."""

from __future__ import annotations

import re

import mpmath as mp
import pytest
import sympy as sp
from selected import drawn

from axiderive.cli import main
from axiderive.study.corpus import Attempt, agreement, corpus, integrate, solve, value

IDS = list(corpus())
FUNCTIONS = {"sqrt": mp.sqrt, "acos": mp.acos, "atanh": mp.atanh, "exp": mp.exp, "sin": mp.sin, "tan": mp.tan}


def test_the_corpus_is_complete():
    assert len(IDS) == 63


@pytest.mark.parametrize("name", drawn(IDS, 21, pytest.mark.slow))
def test_engine_answers(name):
    answer = solve(name)
    assert not answer.has(sp.Integral)
    assert answer.free_symbols <= {corpus()[name].symbols[s] for s in corpus()[name].point}
    assert agreement(name, value(name, answer)) >= 25


@pytest.mark.parametrize("name", ["parab_F", "round_p_in", "sph_w", "cos_F", "fgm_pow_w"])
def test_reference_is_the_integral_of_the_text(name):
    """One integral of each kind by quadrature here: a wrong reference would make a wrong answer right."""
    integral = corpus()[name]
    text = re.sub(r"(?<![\w.])(\d+)(?![\w.])", r"mpf(\1)", integral.integrand)

    def over_angle(u):
        with mp.workdps(160):  # nodes come as close to the ends as 1e-40: a**2 - r**2 loses 80 digits there
            names = {symbol: mp.mpf(number) for symbol, number in integral.point.items()} | FUNCTIONS
            lo, hi = (mp.mpf(names.get(end, 0)) for end in integral.limits)
            v = lo + (hi - lo) * mp.sin(u) ** 2
            return eval(text, {"mpf": mp.mpf}, names | {integral.variable: v}) * (hi - lo) * mp.sin(2 * u)

    with mp.workdps(40):
        number = mp.quad(over_angle, [0, mp.pi / 4, mp.pi / 2])
    assert agreement(name, number) >= 28


def test_an_answer_with_another_break_is_refused():
    """The comparison must see a wrong answer: b for 0.99 b in a closed form."""
    integral = corpus()["tcone_p_in"]
    b = integral.symbols["b"]
    assert agreement("tcone_p_in", value("tcone_p_in", solve("tcone_p_in").subs(b, b * sp.Rational(99, 100)))) < 3


def test_command_prints_rows_and_totals(capsys):
    assert main(["study", "corpus", "cone_p", "fgm_flat_w"]) == 0
    rows = capsys.readouterr().out.splitlines()
    assert [row.split()[0] for row in rows[:2]] == ["cone_p", "fgm_flat_w"]
    assert "2 of 2 within 15 digits" in rows[2]


def test_command_names_the_nearest_integral(capsys):
    assert main(["study", "corpus", "cone_q"]) == 2
    assert "did you mean 'cone_" in capsys.readouterr().err


def test_sympy_beside_the_engine():
    assert integrate(corpus()["parab_F"], limit=60).verdict == "ok"


def test_sympy_is_stopped_when_its_time_is_up():
    assert integrate(corpus()["tcone_p_in"], limit=0.2) == Attempt("timeout", 0.2)
