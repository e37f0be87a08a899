"""Scenes in C and JavaScript: the module has the values of the definitions, in a program of its own."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import pytest
from scenes import composed_from, problems

from axiderive.exits import CommandError
from axiderive.languages.c.file import HELPERS
from axiderive.scene.compose import Result

FORMATS = '[output]\nlanguage = "{}"\nformats = ["{}"]\n'
CONE = 'profile = "cone"\n[parameters]\ntheta = "30 deg"\n[medium]\nE = "3 GPa"\nnu = 0.3\n'
FREE = 'profile = "rounded_punch"\n[parameters]\nb = "1 mm"\n[physics]\ntangential = { mu = 0.3 }\n'
STRIP = 'profile = "wedge"\n[physics]\nplane = true\n[want]\nquantities = ["pressure", "slope", "load"]\n'
RULED = 'profile = "gaussian"\n[want]\nquantities = ["pressure", "radius_from_force", "force_from_depth"]\n'
HELD = 'profile = "cone"\n[physics]\nadhesive = true\n[want]\nquantities = ["force", "pull_off"]\n'
OWN = 'profile = "r**2/(2*R) + q*r**4"\n[want]\nquantities = ["force", "pressure", "radius_from_force"]\n'
GRADED = 'profile = "sphere"\n[medium]\nkind = "power_law"\n[want]\nquantities = ["force", "pressure"]\n'
SCENES = {"frozen": CONE, "free": FREE, "both sides": STRIP, "rules": RULED, "several results": HELD, "expression": OWN,
          "graded": GRADED}  # fmt: skip
TOOLS = {"c": "cc", "javascript": "node"}


def run(result: Result, folder: Path, language: str) -> subprocess.CompletedProcess[str]:
    """What the test of the module prints."""
    for name, content in result.files.items():
        (folder / name).write_bytes(content)
    command = ["node", "test_scene.js"]
    if language == "c":
        made = ["cc", "-std=c99", "-Wall", "-Werror", "-O2", "test_scene.c", "-o", "test", "-lm"]
        subprocess.run(made, cwd=folder, check=True, capture_output=True, timeout=120)
        command = ["./test"]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False, timeout=60)


@pytest.mark.parametrize("language", TOOLS)
@pytest.mark.parametrize("kind", SCENES)
def test_the_module_has_the_values_of_the_definitions(language, kind, tmp_path):
    if shutil.which(TOOLS[language]) is None:
        pytest.skip(f"no {TOOLS[language]} here")
    result = composed_from(SCENES[kind] + FORMATS.format(language, language))
    done = run(result, tmp_path, language)
    assert done.returncode == 0, done.stdout + done.stderr
    assert re.fullmatch(r"\d+ values agree\n", done.stdout)
    assert int(done.stdout.split()[0]) >= 6


def test_a_wrong_module_fails_its_test(tmp_path):
    if shutil.which("cc") is None:
        pytest.skip("no cc here")
    result = composed_from(CONE + FORMATS.format("c", "c"))
    text = result.files["scene.c"].decode()
    assert "2.0 * atan(" in text
    files = {**result.files, "scene.c": text.replace("2.0 * atan(", "2.0000001 * atan(").encode()}
    done = run(Result(files, ()), tmp_path, "c")
    assert done.returncode == 1
    assert "displacement(" in done.stdout
    assert "in place of" in done.stdout


def test_a_file_holds_what_its_functions_need():
    text = composed_from(CONE + FORMATS.format("c", "c")).files["scene.c"].decode()
    assert "struct sum" in HELPERS.read_text()
    for left_out in ("struct sum", "NODES", "minimum", "E_star"):
        assert left_out not in text
    assert "double pressure(double r, double a)" in text


BELOW = CONE + '[physics]\nsubsurface = true\n[want]\nquantities = ["stress"]\n'
SHEET = CONE.replace("nu = 0.3", 'nu = 0.3\n[physics]\nlayer = { thickness = "2 mm" }')


@pytest.mark.parametrize("language", TOOLS)
@pytest.mark.parametrize(
    ("source", "told"),
    [
        (BELOW, "stress: .* one: pressure of normal contact"),
        (
            SHEET,
            "depth, force, pressure: .* one: depth of normal contact, force of normal contact, pressure of "
            "normal contact",
        ),  # fmt: skip
    ],
)
def test_what_has_no_program_names_the_nearest_that_has_one(language, source, told):
    with pytest.raises(CommandError, match=f"{told}$"):
        composed_from(source + FORMATS.format(language, language))


def test_bad_languages():
    assert 'language must be one of python, c, javascript, not \'fortran\'' in problems(
        CONE + '[output]\nlanguage = "fortran"\n'
    )  # fmt: skip
    assert "as 'needle.c', not 'needle.py'" in problems(CONE + '[output]\nlanguage = "c"\nmodule = "needle.py"\n')
    assert "unknown format 'python'" in problems(CONE + '[output]\nlanguage = "c"\nformats = ["python"]\n')
