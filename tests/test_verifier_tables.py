"""The tables of the second prover against mpmath: derivatives, and functions through the member of their family."""

from __future__ import annotations

import re
import time
from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from typing import Any

import mpmath as mp
import pytest
from false_entries import below, derived, record

from axiderive.abel import masters
from axiderive.verifier.field import Element, Field
from axiderive.verifier.problem import Problem
from axiderive.verifier.reading import UnknownError, definition, tree
from axiderive.verifier.theory import FUNCTIONS, THEORY, statements

VALUES = {
    "a": "1.7",
    "b": "0.9",
    "r": "0.4",
    "R": "2.3",
    "n": "2.6",
    "k": "0.3",
    "j": "1.2",
    "theta": "0.4",
    "pi": mp.pi,
}
ORDER = (("r", "b"), ("b", "a"), ("a", "R"))
NUMERIC: dict[str, Any] = {
    "elliptic_f": lambda x, m: mp.ellipf(mp.asin(x), m),
    "elliptic_e": lambda x, m: mp.ellipe(mp.asin(x), m),
    "elliptic_k": mp.ellipk,
    "complete_e": mp.ellipe,
    **{master.__name__: master.numeric for master in masters.MASTERS},
}
FORMULAS = [
    "asin(b/a)", "acos(b/a)", "sqrt(a/b)", "atan(a/b)", "atanh(b/a)", "acosh(a/b)", "asinh(a/b)", "log(a/b)",
    "Dawson(a/b)", "LegendreChi2(b/a)", "ArctanIntegral(a/b)", "C0(b, r, a)", "elliptic_f(b/a, r**2/b**2)",
    "elliptic_e(b/a, r**2/b**2)", "elliptic_k(b**2/a**2)", "complete_e(b**2/a**2)",
    "sinh(asinh(a/b)/3)", "exp(-a**2/b**2)", "gamma(n/2 + 3)", "gamma((1 + k)/2)",
    "gamma(5/2)", "cos(pi*k/2)",
    "sin(a/b)", "cos(a/b)", "(a**2 - b**2)**((k - 1)/2)*(8*a*b)**(n/3)", "(a**2 - 2*a*b + b**2)**(1/2)",
    "CapMoment(k, b, R, a)", "Xi(a, b, r)", "Eta(a, b, r)",
    *(f"IncompleteBeta(b**2/a**2, {p}, {q})" for p in ("1/2", "(1 + k)/2", "(5 + k)/2", "n/2 + 3") for q in
      ("1/2", "0", "1", "2", "-k/2", "(1 - k)/2", "(5 - k)/2", "-3/2 - k/2")),
    *(f"StruveH({order}, a/b)" for order in ("0", "1", "-1", "2", "k/2", "k/2 + 2", "k/2 - 2")),
    *(f"Kummer({p}, {c}, -a**2/b**2)" for p in (1, 2) for c in ("3/2", "(3 + k)/2", "(7 + k)/2")),
    *(f"Hypergeometric(1/2, {q}, {c}, {z})" for q in (1, 2) for c in ("(3 + k)/2", "(5 + k)/2") for z in
      ("b**2/a**2", "-a**2/b**2")),
]  # fmt: skip


def direct(formula: Any, values: dict[str, Any]) -> Any:
    match formula:
        case str():
            return values[formula]
        case int() | Fraction():
            return mp.mpf(formula.numerator) / formula.denominator
        case ("Add", *terms):
            return mp.fsum(direct(term, values) for term in terms)
        case ("Mul", *factors):
            return mp.fprod(direct(factor, values) for factor in factors)
        case ("Pow", base, exponent):
            return direct(base, values) ** direct(exponent, values)
    head, *arguments = formula
    return NUMERIC.get(head, getattr(mp, head, None))(*(direct(argument, values) for argument in arguments))


def through(x: Element, values: dict[str, Any]) -> Any:
    """The number an element stands for."""

    def number(poly: Any) -> Any:
        terms = (
            mp.mpf(int(c.p)) / int(c.q) * mp.fprod(one(i) ** int(m) for i, m in enumerate(powers) if m)
            for powers, c in poly.terms()
        )
        return mp.fsum(terms)

    def one(index: int) -> Any:
        head, *rest = x.field.kind[index]
        if head == "symbol":
            return values[rest[0]]
        if head == "power":
            return number(rest[0]) ** through(rest[1], values)
        return NUMERIC.get(head, getattr(mp, head, None))(*(through(argument, values) for argument in rest[0]))

    return number(x.num) / number(x.den)


def field() -> Field:
    # exponents in twelfths from the start: nothing here begins again
    class Twelfths(dict[str, int]):
        def setdefault(self, key: str, default: int = 1) -> int:
            return 12

    return Field(ORDER, Twelfths(), time.process_time() + 60)


@pytest.mark.parametrize("formula", FORMULAS)
def test_value_and_derivatives(formula: str) -> None:
    with mp.workdps(40):
        values = {name: mp.mpf(value) for name, value in VALUES.items()} | {"exp": mp.e}
        own = field()
        element, wanted = own.read(tree(formula)), direct(tree(formula), values)
        assert mp.almosteq(through(element, values), wanted, rel_eps=mp.mpf(10) ** -25)
        slope = through(own.slope(element, "a"), values)
        numeric = mp.diff(lambda a: direct(tree(formula), values | {"a": a}), values["a"], h=mp.mpf(10) ** -12)
        assert abs(slope - numeric) < mp.mpf(10) ** -9 * max(1, abs(slope))


def test_every_function_of_the_table_is_compared() -> None:
    assert {head for head in FUNCTIONS if not any(f"{head}(" in formula for formula in FORMULAS)} <= {"tan"}


def test_every_section_says_what_is_meant_and_what_is_shown() -> None:
    for section in THEORY.sections.values():
        assert section.all("defined"), section.suffix
        assert section.all("show"), section.suffix
        assert all(statements(text) for text in section.all("show")), section.suffix


def test_definitions_are_told_apart() -> None:
    texts = {
        text for section in THEORY.sections.values() for word in ("defined", "graded") for text in section.all(word)
    }
    assert len({definition(text) for text in texts}) == len(texts) > 70
    assert all(definition(altered) != definition(text) for text in texts for altered in _altered(text))


def _altered(text: str) -> Iterator[str]:
    """The equation with one number, one letter or one sign changed at a time."""
    for found in re.finditer(r"\d+|\b[a-zA-Z]\w*\b|[+]| - |[*](?![*])", text):
        put = {"+": "-", " - ": " + ", "*": "+"}.get(found[0], f"{found[0]}7" if found[0] != "0" else "7")
        yield text[: found.start()] + put + text[found.end() :]


def test_a_definition_is_read_in_both_notations() -> None:
    stored = (
        "Equality(Symbol('d', positive=True), Mul(Rational(-1, 2), Pow(Symbol('k', real=True), Rational(-1, 2)), "
        "Derivative(Function('f')(Symbol('r', positive=True)), Tuple(Symbol('r', positive=True), Integer(1)))))"
    )
    assert definition(stored) == definition("Eq(d, -Derivative(f(r), r)/(2*sqrt(k)))")
    assert definition(stored) != definition("Eq(d, Derivative(f(r), r)/(2*sqrt(k)))")


WORDS = ("analytic", "nowhere negative")
"""What a statement says without another side."""
CHANGED = ("flat_punch.adh", "cone.adh", "paraboloid.tan", "paraboloid.tor", "flat_punch.tor", "materials")
LONG = (
    "cone",
    "capped_cylinder",
    "concave_paraboloid",
    "power_law",
    "rounded_punch",
    "cone.vis",
    "cone.sub",
    "concave_paraboloid.sub",
    "plane.eccentric_punch",
)


@pytest.mark.parametrize("key", [*CHANGED, *(pytest.param(key, marks=pytest.mark.slow) for key in LONG)])
def test_no_statement_holds_with_another_side_or_sign(key: str) -> None:
    """What a line of the table says is looked at: altered, it refuses the true formula."""
    plain = below(key)
    problem = Problem(record(key, derived(key)), Problem(plain) if plain else None)
    for suffix in problem.records:
        if problem.prove(suffix):
            continue
        proof, orders = problem.proof(suffix), problem.proof(suffix).domains()
        true = proof.asked
        for line in true:
            changed = replace(line, text=_changed(line.text))
            assert changed != line or line.text.partition(" is ")[2].partition(" with ")[0] in WORDS
            if changed != line and any(proof.holds(line.conditions, domain) for domain, _ in orders):
                proof.asked = [changed if other is line else other for other in true]
                problem.end = time.process_time() + 60
                with pytest.raises(UnknownError, match="vanish|sign"):
                    proof.run()
        proof.asked = true


def _changed(text: str) -> str:
    """The statement with one more than twice a side, or with the other sign."""
    text, *values = re.split("(?= with | given )", text)
    side = r"1 + 2*(\1) = \2" if " = at(" in text else r"\1 = 1 + 2*(\2)"
    for verb, put in (
        (" = ", side), (" by ", r"\1 by 2*(\2)"), (" integral of ", r"\1 integral of 2*(\2)"),
        (" > ", r"\1 < \2"), (" < ", r"\1 > \2"), (" <= ", r"\1 > \2"), (" >= ", r"\1 < \2"),
    ):  # fmt: skip
        if verb in text:
            text = re.sub(f"^(.*){verb}(.*?)(?= from |$)", put, text)
            break
    return "".join([text, *values])
