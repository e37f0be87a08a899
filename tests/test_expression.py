"""Expressions are data: what is read is exact, the rest is refused with position and next step, nothing is run."""

from __future__ import annotations

import random

import pytest
import sympy as sp

from axiderive import notation as nt
from axiderive.expression import ExpressionError, own_profile, read
from axiderive.notation import R, b, c, r, theta

GOLDEN = {
    "": "the expression is empty; write f(r), as r**2/(2*R)",
    "r**2)": "not an expression: unmatched ')'; write it as in Python, r**2/(2*R) + c*r**4\n  r**2)\n      ^",
    "r^2": "^ is no power here; write r**2\n  r^2\n   ^",
    "1 + r": "f(0) = 1, but a profile starts at its apex with f(0) = 0; subtract that value\n  1 + r\n  ^^^^^",
    "a*r": "a is a result or an argument of the generated functions; give the parameter another name\n  a*r\n  ^",
    "r.real": (
        "'r.real' (Attribute) has no place here; use names, numbers, + - * / ** and functions\n  r.real\n  ^^^^^^"
    ),
    "c*r**25": ("exponent 25 is outside -24 ... 24 in 12ths; use a parameter as r**n for others\n  c*r**25\n       ^^"),
    "cosq(r)": (
        "cosq is no function of an expression; did you mean cos?; there are Max, Piecewise, sqrt, exp, log, sin, "
        "cos, tan, sinh, cosh, tanh, asinh, atan\n  cosq(r)\n  ^^^^"
    ),
    "Max(0, b - r)": (
        "'b - r' is not r - b; write breaks as Max(0, r - b) with a parameter b\n  Max(0, b - r)\n  ^^^^^^^^^^^^^"
    ),
    "(r**24)**24": (
        "'(r**24)**24' holds r**576, whose exponent is too large or too fine; use exponents up to 24 in 12ths\n"
        "  (r**24)**24\n  ^^^^^^^^^^^"
    ),
    "log(r)": (
        "f has no value at r = 0, where a profile starts with f(0) = 0: powers of r below 0, log(r) and quotients by r "
        "have no place at the apex\n  log(r)\n  ^^^^^^"
    ),
    "Piecewise((r**2, r < b), (r, True))": (
        "f jumps by -b**2 + b at the break r = b; write pieces that agree there\n"
        "  Piecewise((r**2, r < b), (r, True))\n  ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^"
    ),
    "Max(0, r - 0.5)": (
        "'r - 0.5' is not r - b; write breaks as Max(0, r - b) with a parameter b; a number is named and given in a "
        "scene\n  Max(0, r - 0.5)\n  ^^^^^^^^^^^^^^^"
    ),
    "r/0": "the denominator is 0; divide by something else\n  r/0\n    ^",
}
HOSTILE = (
    "__import__('os').system('true')", "().__class__.__base__", "exec('1')", "(lambda: r)()", "[r for r in (1,)]",
    "r if r else r", "f'{r}'", "r := 3", "9**9**9**9", "((((2**24)**24)**24)**24)*r", "exp(exp(exp(1000)))*r",
    "(r + b + c + h)**24", "r" + "+r" * 300, "(" * 250 + "r" + ")" * 250, "-" * 300 + "r", "r\x00", "r\n+r", "\u03b1*r",
    "1e999*r", "0x10*r", "1j*r", "True*r", "r**r", "r**0.1234567", "tan(pi/2)*r", "log(0)*r", "sqrt(-1)*r", "import os",
    "lambda*r", "E_star*r", "np*r", "Max(r, 3)", "Max(0, r - b", "r[0]", "*r", "r,r", "...", "a" * 500,
)  # fmt: skip


@pytest.mark.parametrize("text", GOLDEN)
def test_a_refusal_names_value_rule_next_step_and_position(text):
    with pytest.raises(ExpressionError) as caught:
        own_profile(text)
    assert str(caught.value) == GOLDEN[text]


@pytest.mark.parametrize("text", HOSTILE)
def test_hostile_text_is_refused(text):
    with pytest.raises(ExpressionError):
        own_profile(text)


def test_numbers_stay_exact():
    assert read("0.1*r + 1e-3*r**2").tree == r / 10 + r**2 / 1000


def test_breaks_ascend_in_the_order_of_the_text():
    own = own_profile("r**2/(2*R) + c*Max(0, r - b)**2")
    assert [piece.upper for piece in own.profile.pieces] == [b, None]
    assert own.profile.pieces[0].expr == r**2 / (2 * R)
    assert sp.expand(own.profile.pieces[1].expr - r**2 / (2 * R) - c * (r - b) ** 2) == 0


@pytest.mark.parametrize(
    ("text", "units"),
    [
        ("r**2/(2*R) + c*r**4", ["m", "m^(-3)"]),
        ("A*r**n", ["m^(1 - n)", "1"]),
        ("Max(0, r - b)*tan(theta)", ["m", "rad"]),
        ("h*log(cosh(r/q))", ["m", "m"]),
    ],
)
def test_units_follow_from_f_being_a_length(text, units):
    own = own_profile(text)
    assert own.homogeneous
    assert [record.unit for record in own.notation] == units


def test_bare_numbers_carry_units():
    assert not own_profile("r + r**2").homogeneous


def test_the_notation_returns_to_what_it_was():
    before = nt.describe("c")
    with nt.extended(own_profile("c*r**4").notation):
        assert nt.describe("c").unit == "m^(-3)"
    assert nt.describe("c") is before
    assert nt.describe("theta").symbol == theta


# fuzzing: the grammar makes deep and odd trees, the mutation breaks texts that were good
LEAVES = ("r", "b", "R", "c", "theta", "n", "2", "0.5", "1e-3", "pi", "0", "a", "x", "(", "", "'r'", "10**9", "b1")
FORMS = (
    "({}+{})", "({}-{})", "{}*{}", "{}/{}", "{}**{}", "Max(0, {}-{})", "sqrt({})*{}", "exp(-{})*{}", "cos({})-{}",
    "tan({})*{}", "-{}+{}", "({})**2/({})", "log({})*{}", "Max({}, {})", "{}({})", "{}.{}", "{} if {} else r",
)  # fmt: skip
GOOD = ("r**2/(2*R) + c*r**4", "Max(0, r - b)*tan(theta)", "R - sqrt(R**2 - r**2)", "h*(1 - exp(-r**2/s**2))")


def random_text(source: random.Random) -> str:
    if source.random() < 0.4:
        text = bytearray(source.choice(GOOD).encode())
        for _ in range(source.randint(1, 6)):
            place = source.randrange(len(text) + 1)
            kind = source.randrange(3)
            if kind == 0:
                text[place:place] = bytes([source.randrange(256)])
            elif kind == 1:
                del text[place : place + source.randint(1, 4)]
            else:
                text[place : place + 1] = source.choice(GOOD).encode()[: source.randint(1, 12)]
        return text.decode(errors="replace")
    return _tree(source, source.randint(0, 6))


def _tree(source: random.Random, depth: int) -> str:
    if depth == 0:
        return source.choice(LEAVES)
    return source.choice(FORMS).format(*(_tree(source, source.randint(0, depth - 1)) for _ in range(2)))


def read_or_refused(seed: int) -> None:
    text = random_text(random.Random(seed))
    try:
        own = own_profile(text)
    except ExpressionError as error:
        assert error.plain
        assert len(str(error)) < 600
        return
    assert own.profile.pieces
    assert {s.name for p in own.profile.pieces for s in p.expr.free_symbols} <= {"r", *map(str, own.profile.parameters)}


def test_random_text_is_read_or_refused():
    for seed in range(400):
        read_or_refused(seed)


@pytest.mark.slow
def test_much_random_text_is_read_or_refused():
    for seed in range(400, 8000):
        read_or_refused(seed)


@pytest.mark.parametrize(
    ("source", "step"),
    [
        ("x**2", "x would be a parameter; write r for x"),
        ("b", "b would be a parameter; write the height"),
        ("f(r) = r**2", "right of its ="),
        ("2r**2", "write 2*r"),
        ("r**2/2R", "write 2*R"),
        ("0,5*r**2", "decimals have a point"),
        ("ln(1 + r)", "write log(...)"),
        ("abs(r)", "where abs(r) is r"),
        ("max(0, r - b)", "write Max(0, r - b)"),
        ("np.sqrt(r)", "write sqrt(...) alone"),
        ("r*tan(20)", "write tan(20*pi/180)"),
        ("r*tan(20 deg)", "deg is a unit"),
        ("r*tan(20*deg)", "deg is a unit"),
        ("r**2/(2*5mm)", "mm is a unit"),
        ("r if r < b else 0", "Piecewise"),
        ("(r - b)**n", "write Max(0, r - b)"),
        ("sqrt(sin(r/q)**2)", "whose slope jumps"),
    ],
)
def test_what_newcomers_write_is_answered_with_what_to_write(source, step):
    with pytest.raises(ExpressionError) as caught:
        own_profile(source)
    assert step in str(caught.value)


def test_an_inclination_in_degrees_is_read_once_it_says_so():
    assert own_profile("r*tan(20*pi/180)").profile.pieces[0].expr.subs(r, 1).evalf() == sp.tan(sp.pi / 9).evalf()


@pytest.mark.parametrize(
    ("name", "meaning"),
    [("nan", "no number"), ("NaN", "no number"), ("oo", "infinity"), ("inf", "infinity"), ("I", "the imaginary unit")],
)
def test_what_is_no_real_number_is_no_parameter(name, meaning):
    """As parameters they were derived, for nan > 0 and I > 0."""
    with pytest.raises(ExpressionError, match=f"{name} stands for {meaning}, but f.r. is real and finite; write a"):
        own_profile(f"{name}*r**2")


@pytest.mark.parametrize("name", ["L", "N"])
def test_letters_of_lengths_are_free(name):
    own = own_profile(f"r**2/(2*{name})")
    assert [
        (symbol.name, record.unit) for symbol, record in zip(own.profile.parameters, own.notation, strict=True)
    ] == [(name, "m")]
