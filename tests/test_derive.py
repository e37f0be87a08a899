"""Profiles of one's own: closed and certified in the normal form, by measured rules outside it."""

from __future__ import annotations

import os
import random
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest
import sympy as sp
from own_profiles import AGREEMENT, ALL, ROUNDING, RULES, answer_to, errors_of, module_of
from scenes import NO_PDF, composed_from
from selected import few

from axiderive import notation as nt
from axiderive.build.pool import Beside, LimitError, limited
from axiderive.cli import main
from axiderive.code.normal import module as written
from axiderive.expression import own_profile, undetermined
from axiderive.expression.answer import Route, derived
from axiderive.expression.definition import Definition, definition, quantity
from axiderive.notation import R, a, b, theta
from axiderive.physics import normal
from axiderive.physics.medium import HOMOGENEOUS
from axiderive.scene.compose import composed
from axiderive.scene.interface import NORMAL
from axiderive.scene.reading import Scene


@pytest.mark.parametrize(
    "text",
    few(
        ["r**2/(2*R) + c*r**4", "Max(0, r - b)*tan(theta)", "A*r**n", "R - sqrt(R**2 - r**2)"],
        ["Max(0, r - b)*tan(theta)", "A*r**n", "R - sqrt(R**2 - r**2)"],
        pytest.mark.slow,
    ),
)
def test_the_normal_form_is_closed_and_certified(text):
    answer = answer_to(text)
    assert answer.route is Route.NORMAL_FORM
    for suffix in ("d", "F", "p", "w"):
        assert answer.status(suffix) == "closed, certified"
    assert answer.comparisons
    assert answer.worst < AGREEMENT


def test_the_cone_is_the_cone():
    answer = answer_to("r*tan(theta)")
    assert answer.entries["d"].cases[0].expr == sp.pi * a * sp.tan(theta) / 2
    assert answer.validity.exact


def test_outside_the_normal_form_the_pressure_is_an_integral_of_an_integral():
    answer = answer_to("h*log(cosh(r/q))")
    assert answer.route is Route.INTEGRALS
    assert {answer.status(suffix) for suffix in ("d", "F", "w")} == {"one regular integral"}
    assert answer.status("p") == "one regular integral over g'(t), itself an integral"
    result = module_of("h*log(cosh(r/q))")
    assert any(line.startswith("form") and "values by generated rules" in line for line in result.lines)


@pytest.mark.parametrize(
    ("text", "single"),
    few(
        [
            ("r**2/sqrt(r**2 + q**2)", ""),
            ("R/3*((1 + r**2/R**2)**(3/2) - 1) + c*r**6", ""),
            ("h - h/(1 + c*r**2)", "p"),
            ("R*(1 - (1 - r**2/R**2)**(3/2))", "pw"),
            ("q*r**2/(R**2 - r**2)", "pw"),
        ],
        [("r**2/sqrt(r**2 + q**2)", ""), ("q*r**2/(R**2 - r**2)", "pw")],
        pytest.mark.slow,
    ),
)
def test_algebraic_profiles_are_found_by_undetermined_coefficients(text, single):
    """Proved by the certificate and within 1e-20 of the definition; the rest is one integral over a closed g'."""
    answer = answer_to(text)
    assert answer.route is Route.COEFFICIENTS
    for suffix in ("d", "F", "p", "w"):
        assert answer.status(suffix) == ("one regular integral" if suffix in single else "closed, certified")
    assert {c.suffix for c in answer.comparisons} >= {"d", "F", "p"}
    assert answer.worst < AGREEMENT
    assert "undetermined coefficients" in answer.told


@pytest.mark.parametrize("text", ["r**2*(r**2 + q**2)**(1/3)", "h*r**3/(r + q)", "r**2*sqrt(1 + c*r**2 + h*r**4)"])
def test_other_algebraic_profiles_stay_integrals(text):
    own = own_profile(text)
    with nt.extended(own.notation):
        assert derived(own.profile, HOMOGENEOUS).route is Route.INTEGRALS


def test_a_wrong_coefficient_is_not_certified(monkeypatch):
    """Coefficients that fail the conditions come through the solver: the proof refuses them, and integrals are left."""
    right = undetermined.solved

    def wrong(*arguments):
        first, *others = right(*arguments)
        return [2 * first, *others]

    monkeypatch.setattr(undetermined, "solved", wrong)
    own = own_profile("r**2/sqrt(r**2 + q**2)")
    with nt.extended(own.notation):
        assert derived(own.profile, HOMOGENEOUS).route is Route.INTEGRALS


def test_a_new_polynomial_profile_is_derived_and_compared_once(monkeypatch):
    """What takes time: measured 1.0 s in all with one derivation and eight integrals of the definition, twice."""
    calls = []

    def counted(cls, name):
        plain = getattr(cls, name)

        def call(*arguments, **more):
            calls.append(name)
            return plain(*arguments, **more)

        monkeypatch.setattr(cls, name, call)

    counted(normal, "derive")
    counted(Definition, "_over_angle")
    module_of("r**2/(2*R) + q*r**6", names=list(NORMAL.physics.wanted))
    assert calls.count("derive") <= 2
    assert calls.count("_over_angle") <= 24


MIXED = "A*r**(n + 1) + c*r", "h*(1 - exp(-r/s)) + c*r**(1/3)"


@pytest.mark.parametrize("text", few(MIXED, MIXED[:1], pytest.mark.slow))
def test_mixtures_of_the_normal_form_are_certified_and_emitted(text):
    """Factors like a**(n - 1) are finite at a = 0 only together; measured 1e-15 for the rules over the profile."""
    answer = answer_to(text)
    assert answer.route is Route.NORMAL_FORM
    assert {answer.status(suffix) for suffix in ("d", "F")} == {"closed, certified"}
    assert answer.worst < AGREEMENT
    assert max(errors_of(module_of(text))) < RULES


RULED = "h*log(cosh(r/q))", "c*r**(3/2) + q*r**2", "c*Max(0, r - b)**(3/2) + q*r**2"


@pytest.mark.parametrize("text", few(RULED, RULED[2:], pytest.mark.slow))
def test_rules_over_the_profile_hold_whatever_the_contact_is_to_its_lengths(text):
    """Measured 7e-16 at most for radii from 1e-3 to 1e4 of the lengths of seventeen profiles."""
    profile, space = own_profile(text).profile, {}
    exec(module_of(text, {}, ["depth", "force", "pressure", "displacement"]).files["own.py"], space)
    known = dict.fromkeys(profile.parameters, sp.S.One)
    own, given = definition(profile, known), {str(p): 1.0 for p in profile.parameters}
    for radius in (1e-3, 1e3):
        for name, suffix, r, modulus in (
            ("depth", "d", None, {}), ("force", "F", None, {"E_star": 1.0}),
            ("pressure", "p", 0.4 * radius, {"E_star": 1.0}), ("displacement", "w", 1.5 * radius, {}),
        ):  # fmt: skip
            fields = (radius,) if r is None else (r, radius)
            assert space[name](*fields, **given, **modulus) == pytest.approx(
                float(quantity(own, profile, suffix, sp.Float(radius), r and sp.Float(r))), rel=RULES
            )


def test_a_force_takes_up_what_the_rounded_radius_lost():
    """F is 2 E* b d next to a flat face, to the share d/b; through the radius alone it loses 4e-5 at the last depth."""
    space, given = {}, {"c": 1.0, "b": 1.0, "E_star": 1.0}
    exec(module_of("c*Max(0, r - b)**(3/2)", names=["force_from_depth", "depth_from_force"]).files["own.py"], space)
    for depth in (1e-8, 1e-10, 1e-12):
        force = space["force_from_depth"](depth, **given)
        assert force == pytest.approx(2.0 * depth, rel=depth, abs=0.0)
        assert space["depth_from_force"](force, **given) == pytest.approx(depth, rel=1e-15, abs=0.0)


def test_a_force_that_would_lose_digits_is_not_emitted_in_closed_form():
    profile = own_profile("c*Max(0, r - b)**3").profile
    with pytest.raises(ValueError, match="loses digits; emit it by"):
        written(normal.derive(profile))


def random_expression(source: random.Random, breaks: int) -> str:
    """A polynomial of degree up to 5 with positive coefficients, and more of it beyond each break."""

    def polynomial(variable: str) -> str:
        degrees = source.sample(range(1, 6), source.randint(1, 3))
        return " + ".join(f"{source.randint(1, 9)}/{source.randint(1, 9)}*{variable}**{n}" for n in sorted(degrees))

    parts = [] if breaks and source.random() < 0.3 else [polynomial("r")]
    parts += [polynomial(f"Max(0, r - b{i + 1})") for i in range(breaks)]
    return " + ".join(parts)


def held_out(seed: int) -> None:
    text = random_expression(random.Random(seed), seed % 3)
    answer = answer_to(text)
    assert answer.route is Route.NORMAL_FORM
    assert all(answer.certificates[suffix].proved for suffix in ("d", "F", "p", "w")), text
    assert answer.worst < AGREEMENT, text
    own = own_profile(text)
    request = Scene(
        "own", "Own", own=own, kind=NORMAL, quantities=ALL, values={"E_star": 2.0}, module="own.py", formats=("json",)
    )
    errors = errors_of(composed(request, answer))
    assert errors
    assert max(errors) < ROUNDING, (text, errors)


@pytest.mark.slow
@pytest.mark.parametrize("seed", [0, 1])
def test_a_random_piecewise_polynomial_is_derived_certified_and_emitted(seed):
    held_out(seed)


@pytest.mark.sweep
@pytest.mark.parametrize("seed", range(2, 202))
def test_many_random_piecewise_polynomials(seed):
    held_out(seed)


@pytest.mark.parametrize("text", ["q*r**3", pytest.param("q*r**2 + c*Max(0, r - b)**2", marks=pytest.mark.slow)])
def test_the_written_test_runs_with_plain_python(text: str, tmp_path: Path, capsys):
    assert main(["derive", "--out", str(tmp_path), "--", text]) == 0
    assert "closed, certified" in capsys.readouterr().out
    done = subprocess.run(
        [sys.executable, "-I", "-c", f"import sys; sys.path.insert(0, {str(tmp_path)!r}); import test_own_profile as t;"
         " t.test_values(); print('axicontact' in sys.modules, 'sympy' in sys.modules)"],
        capture_output=True, text=True, check=True, cwd=tmp_path,
    )  # fmt: skip
    assert done.stdout == "False False\n"
    lines = (tmp_path / "own_profile.py").read_text().splitlines()
    assert [line for line in lines if line.startswith(("import", "from"))] == [
        "from functools import partial, wraps",
        "import numpy as np",
    ]


def test_the_graded_half_space_prints_its_own_formulas(capsys):
    assert main(["derive", "--k", "1/3", "--", "r**2/(2*R)"]) == 0
    out = capsys.readouterr().out
    assert "d = 3*a**2/(4*R)" in out
    assert out.count("closed, certified") == 4


@pytest.mark.parametrize("arguments", [["--k", "2", "--", "r**2"], ["--", "q*x*r"], ["--", "__import__('os')"]])
def test_a_bad_command_ends_with_code_2_and_no_traceback(arguments, capsys):
    assert main(["derive", *arguments]) == 2
    err = capsys.readouterr().err
    assert err.startswith("axicontact: ")
    assert "Traceback" not in err


def _forever() -> None:
    while True:
        pass


def _greedy() -> int:
    return len(bytearray(2**31))


def test_work_that_takes_too_long_is_stopped():
    with pytest.raises(LimitError, match="stopped after 0.2 s"):
        limited(_forever, seconds=0.2)


def test_work_that_takes_too_much_memory_is_stopped():
    with pytest.raises(Exception, match="more than 1024 MB"):
        limited(_greedy, megabytes=1024)


def _telling(say) -> str:
    say("first")
    return "last"


def test_work_tells_something_before_it_ends():
    heard: list[str] = []
    assert limited(_telling, hear=heard.append) == "last"
    assert heard == ["first"]


def _failing() -> None:
    message = "seen"
    raise ValueError(message)


def _dying(first: int) -> int:
    if os.getpid() != first:
        os.kill(os.getpid(), signal.SIGKILL)
    return 7


def test_what_is_worked_on_beside_comes_back_or_fails_as_it_would_here():
    assert Beside(divmod, 7, 2).result() == (3, 1)
    with pytest.raises(ValueError, match="seen"):
        Beside(_failing).result()
    assert Beside(_dying, os.getpid()).result() == 7


def test_what_nobody_asks_for_is_ended():
    unasked = Beside(_forever)
    process = unasked._process
    del unasked
    if process:
        with pytest.raises(ProcessLookupError):
            os.kill(process, 0)


def _with_another(say: Callable[[int], None]) -> None:
    # which takes no time of the processor, of which there is a limit of its own
    another = Beside(time.sleep, 60)
    say(another._process)
    _forever()


def test_work_that_is_stopped_takes_with_it_what_it_began():
    begun: list[int] = []
    with pytest.raises(LimitError):
        limited(_with_another, hear=begun.append, seconds=0.5)
    stat = Path(f"/proc/{begun[0]}/stat")
    deadline = time.monotonic() + 20
    while begun[0] and stat.exists() and stat.read_text().split()[2] != "Z":
        assert time.monotonic() < deadline
        time.sleep(0.05)


def test_symbols_of_the_notation_are_used():
    assert own_profile("r**2/(2*R) + r*b/R").profile.parameters == (R, b)


ROOTS = "sqrt(r**2 + 2*r*s)", "sqrt(r*s)*sqrt(1 + r/s)", "sqrt(r*s + sqrt(r**3*s))"


@pytest.mark.parametrize("text", few(ROOTS, ROOTS[2:], pytest.mark.slow))
def test_a_root_that_vanishes_at_the_tip_is_reached(text):
    """The rule stopped where f' = sqrt(s/(2 r)) had 5e-11 of the depth left; and no such integrand is regular."""
    answer = answer_to(text)
    assert answer.status("d") == "one integral, infinite but integrable at one end"
    assert answer.status("F") == "one regular integral"
    (told,) = [line for line in module_of(text).lines if line.startswith("module")]
    assert float(told.split("worst ")[1].split()[0]) < 1e-13, told


WITH_E = "exp(exp(exp(r))) - exp(exp(1))", "exp(1)*r**2"


@pytest.mark.parametrize("text", few(WITH_E, WITH_E[1:], pytest.mark.slow))
def test_the_number_e_is_emitted(text):
    """It ended in a KeyError."""
    assert answer_to(text).status("F") in ("one regular integral", "closed, certified")
    assert any(line.startswith("module") for line in module_of(text).lines)


@pytest.mark.parametrize("physics", ["normal = true", "adhesive = { dgamma = 0.1 }", "tangential = { mu = 0.3 }"])
def test_scenes_with_the_letters_of_lengths(physics):
    """L and N are letters of the notation too, of the plane problem and of the sum over a polynomial."""
    values = "[parameters]\nL = 2.0\n[medium]\nE = 1.0\nnu = 0.3\n"
    source = f'name = "scene"\nprofile = "r**2/(2*L) + r**4/N**3"\n{values}[physics]\n{physics}{NO_PDF}'
    result = composed_from(source)
    module = result.files["scene.py"].decode()
    assert "L = 2.0  # " in module
    assert "*, N)" in module
