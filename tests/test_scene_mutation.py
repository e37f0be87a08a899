"""The test that goes with a module notices a wrong rule: every operator of the physics is exchanged once."""

from __future__ import annotations

import ast
import itertools
import sys
import types
from collections.abc import Iterator

import pytest

from axiderive.scene import reading, text
from axiderive.scene.compose import composed

QUANTITIES = '["depth", "force", "pressure", "displacement", "mean_pressure", "stiffness"]'
SCENES = {
    "outside the normal form": (
        'profile = "h*log(cosh(r/q)) + c*Max(0, r - b)*sqrt(r)"\n',
        f"[want]\nquantities = {QUANTITIES}\n",
    ),
    "breaks": ('profile = "q*r**3 + c*Max(0, r - b)**2"\n', f"[want]\nquantities = {QUANTITIES}\n"),
    "partial slip": (
        'profile = "h*log(cosh(r/q)) + s*Max(0, r - b)*sqrt(r)"\n',
        '[physics]\ntangential = true\n[want]\nquantities = ["tangential_force", "traction", "stick_radius"]\n',
    ),
}
EXCHANGED = {ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult, ast.Pow: ast.Mult}
CHECKED = (
    "depth", "force", "pressure", "displacement", "steepness", "growth", "bend", "profile", "tangential_force",
    "traction", "pressure_integral", "mean_pressure",
)  # fmt: skip
"""Functions in which no operator may be wrong; an iteration finds its root by a wrong step too."""


def files_of(source: tuple[str, str]) -> tuple[str, str]:
    whole = "".join(source) + '[output]\nformats = ["python"]\n'
    files = composed(reading.read(text.parse("scene", whole.encode()))).files
    return files["scene.py"].decode(), files["test_scene.py"].decode()


def _exchangeable(node: ast.AST) -> bool:
    return isinstance(node, ast.BinOp) and type(node.op) in EXCHANGED


def mutants(source: str, every: int) -> Iterator[tuple[str, str]]:
    """The function and the text of the module for every exchanged operator, or for one of so many."""
    number = itertools.count()
    for function in (n for n in ast.parse(source).body if isinstance(n, ast.FunctionDef)):
        if not function.name.lstrip("_").startswith(CHECKED):
            continue
        count = sum(_exchangeable(n) for n in ast.walk(function))
        for i in (i for i in range(count) if next(number) % every == 0):
            tree = ast.parse(source)
            own = next(n for n in tree.body if isinstance(n, ast.FunctionDef) and n.name == function.name)
            node = [n for n in ast.walk(own) if isinstance(n, ast.BinOp) and _exchangeable(n)][i]
            before = ast.unparse(node)
            if before in ("sliding + 0.0 * c", "0.0 * c"):  # carries a NaN and nothing else
                continue
            node.op = EXCHANGED[type(node.op)]()
            yield f"{function.name}: {before}", ast.unparse(tree)


def passes(module_text: str, test_text: str, monkeypatch: pytest.MonkeyPatch) -> bool:
    module = types.ModuleType("scene")
    exec(compile(module_text, "scene.py", "exec"), module.__dict__)
    monkeypatch.setitem(sys.modules, "scene", module)
    space: dict[str, object] = {"__name__": "test_scene"}
    exec(compile(test_text, "test_scene.py", "exec"), space)
    try:
        space["test_values"]()
    except (AssertionError, ArithmeticError, ValueError, TypeError):
        return False
    return True


CASES = [
    *(pytest.param(SCENES[name], 6, id=f"some of {name}") for name in ("outside the normal form", "breaks")),
    *(pytest.param(source, 1, id=name, marks=pytest.mark.slow) for name, source in SCENES.items()),
]


@pytest.mark.parametrize(("source", "every"), CASES)
def test_no_exchanged_operator_survives(source, every, monkeypatch):
    module, test = files_of(source)
    assert passes(module, test, monkeypatch)
    tried = list(mutants(module, every))
    assert len(tried) > 10
    survivors = [what for what, wrong in tried if passes(wrong, test, monkeypatch)]
    assert not survivors, survivors
