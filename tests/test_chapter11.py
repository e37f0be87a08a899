"""The 110 equations of chapter 11: the misprinted ones are found, no other is flagged, and an altered one is caught."""

from __future__ import annotations

import ast
import inspect
import json
import re
import textwrap
from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from typing import Any

import mpmath as mp
import pytest
from selected import drawn, few
from stored_book import CATALOGUE

from axiderive import cli
from axiderive.build import pool
from axiderive.chapter11 import equation as chapter
from axiderive.chapter11.equation import Draw, Formula
from axiderive.chapter11.errata import REMARKS, agreement
from axiderive.chapter11.first_principles import Step, steps
from axiderive.print.words import NAMES, typeset

MISPRINTED = {66, 88, 102, 106, 110}
DIGITS = 30
SECTIONS = {
    "flat punch": range(1, 16),
    "normal": range(16, 30),
    "adhesive": range(30, 32),
    "graded punch": range(32, 48),
    "graded": range(48, 62),
    "graded adhesive": range(62, 67),
    "tangential": range(67, 81),
    "special functions": range(81, 100),
    "Föppl and Schubert": range(100, 111),
}


def assert_verdicts(rows: list[chapter.Row]) -> None:
    wrong = [row for row in rows if row.verdict != ("misprint" if row.number in MISPRINTED else "OK")]
    assert not wrong, "\n" + chapter.table(wrong)
    assert min(row.digits() for row in rows) >= DIGITS


def test_every_equation_has_a_check() -> None:
    assert list(chapter.equations()) == list(range(1, 111))
    assert {n for n, equation in chapter.equations().items() if equation.corrected} == MISPRINTED


@pytest.mark.parametrize("section", few(SECTIONS, ["adhesive", "graded adhesive"]))
def test_section(section: str) -> None:
    assert_verdicts(list(chapter.run(SECTIONS[section], DIGITS, seed=1, draws=1)))


@pytest.mark.slow
@pytest.mark.parametrize("section", few(SECTIONS, ["normal", "graded adhesive", "tangential"]))
def test_section_with_other_draws(section: str) -> None:
    """One that neither the build nor the plain run draws."""
    assert_verdicts(list(chapter.run(SECTIONS[section], DIGITS, seed=2, draws=1)))


def test_more_digits_are_reached_on_demand() -> None:
    """The rules of quadrature scale with the precision."""
    rows = list(chapter.run([4, 24, 42, 68, 83], digits=55, seed=3, draws=1))
    assert all(row.verdict == "OK" for row in rows), "\n" + chapter.table(rows)


def test_rows_do_not_depend_on_the_number_of_processes() -> None:
    numbers = [5, 88, 102]
    apart = chapter.run(numbers, draws=1, runner=partial(pool.run, jobs=2, ordered=True))
    assert list(apart) == list(chapter.run(numbers, draws=1))


def test_only_misprinted_rows_bear_the_word() -> None:
    rows = list(chapter.run([5, 64, 66, 87, 88, 102, 103], draws=1))
    lines = chapter.table(rows).splitlines()[1:]
    assert [row.number for row, line in zip(rows, lines, strict=True) if "misprint" in line] == [66, 88, 102]


def test_command_prints_the_table(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    rows = list(chapter.run([5, 66], draws=1))
    monkeypatch.setattr(chapter, "run", lambda **options: iter(rows))
    assert cli.main(["check", "chapter"]) == 0
    printed = capsys.readouterr().out
    assert chapter.table(rows) in printed
    assert "2 equations, 1 to be corrected, 0 failures" in printed
    monkeypatch.setattr(chapter, "run", lambda **options: iter([replace(rows[0], verdict="fails")]))
    assert cli.main(["check", "chapter"]) == 1


def test_an_unknown_number_is_refused() -> None:
    with pytest.raises(ValueError, match=r"no equation \(11\.111\)"):
        list(chapter.run([111]))


def test_a_correction_of_a_correct_equation_fails() -> None:
    equation = chapter.equations()[5]
    assert chapter.check(replace(equation, corrected=equation.formula), draws=1).verdict == "fails"


def test_errata_are_the_misprints_and_the_remarks() -> None:
    """Those of the catalogue: `test_catalogue` asks by digest whether they were made by this engine."""
    found = json.loads((CATALOGUE / "evidence" / "chapter11.json").read_bytes())["errata"]
    misprints = found[: len(MISPRINTED)]
    assert [e["place"] for e in misprints] == [f"(11.{n})" for n in sorted(MISPRINTED)]
    assert all(e["printed"] != e["right"] and e["reason"] and e["evidence"] for e in misprints)
    assert len(found) == len(MISPRINTED) + len(REMARKS)


@pytest.mark.parametrize("remark", [r for r in REMARKS if r.check], ids=lambda r: r.place)
def test_remarks_hold(remark: Any) -> None:
    assert agreement(remark, DIGITS, seed=5) >= DIGITS


# A check that cannot fail proves nothing: every operator, sign and number of the printed formulas is altered in turn.

OPERATORS = {ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult}
PRECISION_ONLY = {"max", "float", "workdps", "_terms"}
"""Calls that say how to integrate or sum, not what."""
RULES = {"around": 1, "across": 1, "weighted": 3, "singular": 3, "panels": 3}
"""Rules of quadrature, and how many of their arguments are part of the formula: the integrand, the ends."""


def _sites(node: ast.AST) -> Iterator[ast.AST]:
    """The nodes of a formula that can be altered, without those that only steer a quadrature."""
    alterable = (
        (isinstance(node, ast.BinOp) and type(node.op) in OPERATORS)
        or (isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub))
        or (isinstance(node, ast.Constant) and type(node.value) is int)
    )
    if alterable:
        yield node
    for part in _parts(node):
        yield from _sites(part)


def _parts(node: ast.AST) -> list[ast.AST]:
    called = getattr(node.func, "id", getattr(node.func, "attr", "")) if isinstance(node, ast.Call) else ""
    if called in PRECISION_ONLY:
        return []
    if isinstance(node, ast.Call) and called in RULES:
        return list(node.args[: RULES[called]])
    return [part for part in ast.iter_child_nodes(node) if not isinstance(part, ast.keyword)]


def _texts(number: int) -> tuple[dict[str, Any], list[str]]:
    """The names a formula uses, its text as an assignment to `formula`, and those of its module's private functions."""
    check = chapter.equations()[number].check
    called = (node for node in ast.walk(ast.parse(inspect.getsource(check))) if isinstance(node, ast.Call))
    call = next(node for node in called if ast.unparse(node.func) == "equation" and _number(node) == number)
    node = next((word.value for word in call.keywords if word.arg == "corrected"), call.args[1])
    known = check.__globals__
    text = f"formula = {ast.unparse(node)}"
    if isinstance(node, ast.Name):
        text = f"{textwrap.dedent(inspect.getsource(known[node.id]))}\n{text}"
    names = {node.id for node in ast.walk(ast.parse(text)) if isinstance(node, ast.Name) and node.id.startswith("_")}
    helpers = (known[name] for name in sorted(names - {"_", "_terms"}))
    return known, [text, *(inspect.getsource(one) for one in helpers if one.__module__ == check.__module__)]


def _number(call: ast.Call) -> Any:
    return ast.literal_eval(call.args[0])


def mutants(number: int) -> Iterator[tuple[str, Formula]]:
    """Every formula that differs from the one of an equation in one operator, sign or integer."""
    known, texts = _texts(number)
    for part in texts:
        for index in range(len(list(_sites(ast.parse(part))))):
            tree = ast.parse(part)
            node = list(_sites(tree))[index]
            if isinstance(node, ast.BinOp):
                node.op = OPERATORS[type(node.op)]()
            elif isinstance(node, ast.UnaryOp):
                node.op = ast.UAdd()
            elif isinstance(node, ast.Constant):
                node.value += 1
            namespace = dict(known)
            exec(compile(texts[0], "<formula>", "exec"), namespace)
            exec(compile(tree, "<mutant>", "exec"), namespace)
            yield ast.unparse(tree), namespace["formula"]


def survives(number: int, formula: Formula) -> bool:
    """Whether the check of an equation takes another formula for right."""
    equation = chapter.equations()[number]
    try:
        with mp.workdps(DIGITS + chapter.GUARD):
            values = equation.check(Draw("altered", first=False), formula)
            if any(x.relative() > mp.mpf(10) ** -DIGITS for x in values):
                return False
        return chapter.evaluate(equation, formula, DIGITS, seed=6, draws=1).digits() >= DIGITS
    except (ArithmeticError, AttributeError, TypeError, ValueError):
        return False  # a root of a negative number, a division by zero


CHEAP = (
    3, 5, 7, 9, 12, 13, 15, 21, 24, 32, 36, 38, 40, 42, 45, 58, 64, 74, 75,
    79, 81, 84, 85, 90, 92, 96, 102, 103, 108,
)  # fmt: skip


@pytest.mark.parametrize("number", drawn(CHEAP, 8, pytest.mark.slow))
def test_altered_equation_is_flagged(number: int) -> None:
    survivors = [text for text, formula in mutants(number) if survives(number, formula)]
    assert not survivors, "\n\n".join(survivors)


OTHERS = sorted({*range(1, 111)} - {*CHEAP})


@pytest.mark.parametrize(
    "number", [pytest.param(n, marks=pytest.mark.slow if n in OTHERS[::3] else pytest.mark.sweep) for n in OTHERS]
)
def test_every_altered_equation_is_flagged(number: int) -> None:
    test_altered_equation_is_flagged(number)


@pytest.mark.parametrize("step", drawn(steps(), 9, pytest.mark.slow), ids=lambda step: f"{step.equations} {step.claim}")
def test_first_principles(step: Step) -> None:
    """Exact, and not because everything is taken to vanish."""
    assert step.holds()
    assert not replace(step, right=3 * step.right + 1).holds()


def test_what_is_set_of_the_chapter_is_what_was_transcribed() -> None:
    """Every text goes back to its transcription, blanks, brackets and braces apart."""
    record = json.loads((CATALOGUE / "evidence" / "chapter11.json").read_bytes())
    texts = [row["title"] for row in record["rows"]] + [step["claim"] for step in record["steps"]]
    texts += [text for erratum in record["errata"] for text in erratum.values()]
    for text in texts:
        assert _bare(_untyped(typeset(text))) == _bare(text)
    assert sum(r"\(" in typeset(text) for text in texts) > 80
    assert typeset("a radius r <= a, a^2") == r"a radius \(r \le a\), \(a^{2}\)"


def _untyped(tex: str) -> str:
    tex = tex.replace(r"\sqrt", "sqrt").replace(r"\int", "int").replace(r"\pm", "+-").replace(r"\,", "", 0)
    tex = tex.replace(r"\lvert ", "abs(").replace(r"\rvert", ")").replace("--", "-")
    for name, printed in sorted(NAMES.items(), key=lambda item: -len(item[1])):
        tex = tex.replace(printed, name)
    return tex.replace(r"\,", "").replace(r"\(", "").replace(r"\)", "")


def _bare(text: str) -> str:
    return re.sub(r"[\s(){}]", "", text)
