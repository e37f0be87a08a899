"""Scenes: one self-contained module with what is asked for, the same each time; no text in it is a command."""

from __future__ import annotations

import ast
import hashlib
import json
import math
import re
import subprocess
import sys
from pathlib import Path

import pytest
import sympy as sp
from scenes import EXAMPLES, NEEDLE, NO_PDF, composed_from, titles

from axicontact import materials
from axiderive.cli import main
from axiderive.physics import loads, normal, plane
from axiderive.scene import text
from axiderive.scene.medium import medium_values
from axiderive.scene.page import escaped


@pytest.fixture(scope="module")
def needle(tmp_path_factory) -> Path:
    """The files of the first example, written by the command."""
    folder = tmp_path_factory.mktemp("needle")
    scene = folder / "scene.toml"
    scene.write_text(NEEDLE + NO_PDF)
    assert main(["emit", str(scene)]) == 0
    return folder / "needle_on_gel"


def test_the_folder_holds_module_test_page_evidence_scene_and_manifest(needle):
    names = {path.relative_to(needle).as_posix() for path in needle.rglob("*") if path.is_file()}
    assert names == {
        "needle_on_gel.py", "test_needle_on_gel.py", "page.tex", "preamble.tex", "profiles/cone.tex", "evidence.json",
        "scene.toml", "MANIFEST.json",
    }  # fmt: skip
    manifest = json.loads((needle / "MANIFEST.json").read_text())
    assert manifest == {
        name: hashlib.sha256((needle / name).read_bytes()).hexdigest() for name in names - {"MANIFEST.json"}
    }


def test_the_module_is_short_and_needs_numpy_alone(needle):
    source = (needle / "needle_on_gel.py").read_text()
    assert len(source.splitlines()) <= 112
    assert len([line for line in source.splitlines() if line.strip()]) <= 84
    tree = ast.parse(source)
    imported = {node.module for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)}
    imported |= {alias.name for node in ast.walk(tree) if isinstance(node, ast.Import) for alias in node.names}
    assert imported == {"collections", "functools", "numpy"}
    assert max(map(len, source.splitlines())) <= 120


def test_the_module_holds_what_is_wanted_and_what_that_reaches(needle):
    tree = ast.parse((needle / "needle_on_gel.py").read_text())
    defined = {node.name for node in tree.body if isinstance(node, (ast.FunctionDef, ast.ClassDef))}
    defined |= {node.targets[0].id for node in tree.body if isinstance(node, ast.Assign)}
    public = {"depth", "force", "pressure", "displacement", "pull_off"}
    assert {node.name for node in tree.body if isinstance(node, ast.FunctionDef)} & public == public
    used = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load)}
    assert defined - used - public == set()


def test_the_page_holds_the_kind_of_contact_and_its_certificates_and_no_other(needle):
    page = (needle / "profiles" / "cone.tex").read_text()
    assert titles(page.encode()) == ["Normal contact", "Adhesive contact"]
    assert page.count("(certified)") > 15
    marks = set(re.findall(r"\\key\{([\w.]+)\}", page))
    assert {"d", "p", "adh.Dl", "adh.dm", "adh.aF"} <= marks
    assert not [mark for mark in marks if mark.startswith(("tan.", "fgm.", "vis."))]
    assert all(page.count("{" + word) == page.count("end{" + word) + page.count("begin{" + word)
               for word in ("tabular*}", "tikzpicture}", "minipage}"))  # fmt: skip
    assert r"N/m" in (needle / "page.tex").read_text()
    assert r"here $2666667$" in (needle / "page.tex").read_text()


IN_PYTHON = [path for path in sorted(EXAMPLES.glob("*.toml")) if "language" not in path.read_text()]


@pytest.mark.parametrize("path", IN_PYTHON, ids=lambda path: path.stem)
def test_no_rule_or_table_is_written_twice_or_for_nothing(path):
    """Each long number once, and rules of so many nodes as are asked for."""
    source = path.read_text()
    files = composed_from(source).files
    module = next(text.decode() for name, text in files.items() if name.endswith(".py") and "test_" not in name)
    numbers = re.findall(r"\d\.\d{12,}(?:e-\d+)?", module)
    assert len(numbers) == len(set(numbers))
    counts = {int(count) for count in re.findall(r"^    (\d+): \[$", module, re.MULTILINE)}
    rest = re.sub(r"_NODES = \{.*?\n\}", "", module, flags=re.DOTALL)
    assert all(re.search(rf"\b{count}\b", rest) for count in counts)
    assert "The same" not in module


def test_the_test_runs_with_plain_python_outside_the_checkout(needle):
    done = subprocess.run(
        [sys.executable, "test_needle_on_gel.py"], cwd=needle, env={}, capture_output=True, text=True, check=True
    )
    assert done.stdout == "24 values agree\n"


def test_the_test_fails_for_a_wrong_module(needle, tmp_path):
    """A constant changed by 1e-9 is found."""
    for name in ("needle_on_gel.py", "test_needle_on_gel.py"):
        (tmp_path / name).write_text((needle / name).read_text())
    module = tmp_path / "needle_on_gel.py"
    module.write_text(module.read_text().replace("dgamma = 0.05 ", "dgamma = 0.0500000001 "))
    done = subprocess.run([sys.executable, "test_needle_on_gel.py"], cwd=tmp_path, capture_output=True, check=False)
    assert done.returncode == 1


def test_a_scene_of_the_catalogue_derives_nothing_and_gives_the_same_bytes(needle, monkeypatch):
    """Formulas and modules are those that are stored; what SymPy is slow at is not called."""

    def refused(*arguments: object, **more: object) -> object:
        message = "a stored scene is not derived"
        raise AssertionError(message)

    for module in (normal, plane, loads):
        monkeypatch.setattr(module, "derive", refused)
    for name in ("integrate", "simplify", "limit", "solve"):
        monkeypatch.setattr(sp, name, refused)
    files = composed_from(NEEDLE + NO_PDF).files
    assert files == {name: (needle / name).read_bytes() for name in files}
    assert "profiles/cone.tex" in files


def test_free_parameters_stay_keywords_and_are_checked():
    source = 'profile = "cone"\n[want]\nquantities = ["force"]' + NO_PDF
    space: dict[str, object] = {}
    exec(composed_from(source).files["scene.py"].decode(), space)
    force = space["force"]
    assert force(1.0, theta=0.1, E_star=2.0) == pytest.approx(0.31521, rel=1e-4)
    with pytest.raises(ValueError, match="theta = 2.0 is outside"):
        force(1.0, theta=2.0, E_star=2.0)


def test_nothing_in_a_title_is_a_command_of_latex_or_python():
    assert escaped(r"\input{/etc/passwd} $x$ 100% #1 a_b ~^&") == (
        r"\textbackslash{}input\{/etc/passwd\} \$x\$ 100\% \#1 a\_b \textasciitilde{}\textasciicircum{}\&"
    )
    source = NEEDLE.replace("Blunt needle on a silicone gel", r"\\write18{x} ''' \" + __import__('os')")
    module = composed_from(source + NO_PDF).files["needle_on_gel.py"].decode()
    tree = ast.parse(module)
    assert ast.get_docstring(tree).startswith("/write18{x}")
    assert "__import__" not in {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)}


UNITS_AND_INFINITY = """
import needle_on_gel as module, numpy as np

class Quantity:
    units, magnitude = "mm", 1.0
    def __array__(self, dtype=None, copy=None):
        return np.asarray(self.magnitude, dtype)
    def __float__(self):
        return self.magnitude

for given in (Quantity(), [Quantity()], [[1.0], [Quantity()]], np.ma.array([1.0])):
    for call in (lambda: module.force(given), lambda: module.pressure(1e-4, given)):
        try:
            call()
        except TypeError as error:
            assert "a = " in str(error) and "is no bare number; give a.to('m').magnitude" in str(error), error
        else:
            raise AssertionError(given)
assert module.pressure(np.inf, 1e-4) == module.displacement(np.inf, 1e-4) == 0.0
assert module.displacement([1e-5, np.inf], 1e-4)[1] == 0.0
assert np.isnan(module.pressure(-np.inf, 1e-4)) and np.isnan(module.pressure(np.inf, -1.0))
print("as in the catalogue")
"""


def test_units_are_refused_and_fields_vanish_far_away(needle):
    """As in the modules of the catalogue; the displacement at an infinite radius was NaN."""
    command = [sys.executable, "-W", "error", "-c", UNITS_AND_INFINITY]
    run = subprocess.run(command, cwd=needle, capture_output=True, text=True, check=False)
    assert run.stdout == "as in the catalogue\n", run.stderr


def test_the_moduli_of_a_half_space_are_those_of_the_materials() -> None:
    found = medium_values(text.parse("s", b'profile = "cone"\n[medium]\nE = "3 GPa"\nnu = 0.4\n'))
    assert found["E_star"] == pytest.approx(materials.effective_modulus(3e9, 0.4, math.inf, 0.3), rel=1e-15)
    assert found["G_star"] == pytest.approx(materials.effective_shear_modulus(3e9, 0.4, math.inf, 0.3), rel=1e-15)
