"""The formulas of the docstrings, over every module of the catalogue: no name that a reader would have to guess."""

from __future__ import annotations

import ast
import re
from functools import cache
from pathlib import Path

import axicontact
from axiderive.store.index import load

ROOT = Path(axicontact.__file__).parent
PACKAGES = sorted({path.parent.relative_to(ROOT) for path in ROOT.rglob("*.py")})
ELEMENTARY = {
    "sqrt", "exp", "log", "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "asinh", "acosh", "atanh",
    "abs", "sign", "max", "gamma", "Integral", "Derivative", "Sum",
}  # fmt: skip
FIELDS = {"f", "g", "a", "d", "F", "p", "E"}
"""Functions that the text itself defines, or that the docstring of their own entry does."""


@cache
def formulas(path: Path) -> list[tuple[str, str]]:
    """Name and the text above the parameters of every public function that has some."""
    functions = [node for node in ast.parse(path.read_text()).body if isinstance(node, ast.FunctionDef)]
    texts = [(node.name, ast.get_docstring(node) or "") for node in functions if not node.name.startswith("_")]
    return [(name, text) for name, text in texts if "\nParameters\n" in text]


def test_every_function_of_a_formula_is_known_or_explained() -> None:
    unknown = [
        f"{package}/{path.stem}.{function}: {name}"
        for package in PACKAGES
        for path in sorted((ROOT / package).glob("*.py"))
        for function, whole in formulas(path)
        for text in [whole.partition("\nParameters\n")[0]]
        for name in re.findall(r"\b(\w+)\(", text.partition("\nwith ")[0])
        if name not in ELEMENTARY | FIELDS
        and not re.search(rf"^with {name}[:(]", text, re.MULTILINE)
        # what an equation is for, and its kernel, stand in the notes
        and not re.search(rf"\b{name}\([a-z, ]+\)\s+(=|is)\s", whole.partition("\nNotes\n")[2])
        and not (name.startswith("elliptic_") and "with elliptic integrals of the parameter" in text)
    ]
    assert unknown == []


def test_there_are_formulas_to_read() -> None:
    found = [name for path in ROOT.rglob("*.py") for name, text in formulas(path) if " = " in text]
    assert len(found) > 1000


def test_a_stick_radius_beyond_a_break_is_not_defined_by_the_tip() -> None:
    """What `show` and the docstring of a long equation print holds on both sides of the break."""
    rows = {row["key"]: row for row in load().entries if row["key"].endswith(".tan.c") and len(row["cases"]) > 1}
    assert {"rounded_cone.tan.c", "sphere_tipped_cone.fgm.tan.c"} <= rows.keys()
    assert {row["definition"] for row in rows.values()} == {"mu*(F(a) - F(c)) = F_x"}
