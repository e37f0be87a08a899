"""Programs in other languages give the numbers of the package."""

from __future__ import annotations

import inspect
import json
import math
import shutil
import subprocess
import tempfile
from collections.abc import Callable
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from test_agreement import FIELDS, NUMBERS, size
from test_interface import PARAMETERS

from axiderive.languages.c.file import File
from axiderive.languages.c.values import Number
from axiderive.languages.javascript import HELPERS, Script
from axiderive.languages.reach import NoProgramError, Package

CATALOGUE = Path(__file__).parent.parent / "catalogue"


def _node() -> str | None:
    """Node that knows what browsers of the last years know, and the script of the pages takes for granted."""
    found = shutil.which("node")
    said = found and subprocess.run([found, "--version"], capture_output=True, text=True, check=False).stdout
    return found if said and int(said.strip().lstrip("v").partition(".")[0]) >= 18 else None


NODE = _node()
GROUPS = ("normal", "adhesive", "tangential", "viscoelastic", "plane", "loads")
FEW = {"cone", "rounded_punch", "sphere_tipped_cone", "gaussian", "polynomial", "concave_power", "wedge", "hertzian"}
"""Profiles of the plain run: closed forms, rules, iterations, coefficients, a fixed edge."""
MORE = {
    **{"v": 0.3, "v_2": 0.2, "t_m": 1.1},
    **{"E": 1.4, "tau": 0.7, "eta": 0.6, "E_inf": 0.5, "E_1": 0.9, "alpha": 0.4, "t_0": 0.8, "t": 1.2},
    **{"P": 0.8, "x": 0.4, "r": 0.5, "L": 5.0, "e": 0.1, "p_0": 1.7, "s": 0.6, "b": 0.3, "theta": 0.3, "R": 2.0},
    **{"A": 0.7, "n": 2.6, "h": 0.2, "a": 0.9},
}
RARE, MOST = 2e-3, 8.0
"""The share of values that may differ by more than 4 units of the last place, and what none may exceed.

The functions of `math` differ in the last place, and a power of the time, or a difference of two parts, makes more of
that.
"""


@pytest.fixture(scope="module")
def package() -> Package:
    return Package({
        path.relative_to(CATALOGUE).as_posix(): path.read_text(encoding="utf-8")
        for path in (CATALOGUE / "axicontact").rglob("*.py")
    })  # fmt: skip


def drawn(name: str, function: Callable[..., Any], dice: np.random.Generator) -> tuple[dict[str, Any], dict[str, Any]]:
    """Fields about those of an example, the stick zone inside the contact, and the parameters by name."""
    known = MORE | NUMBERS | FIELDS | PARAMETERS.get(name, {})
    kinds = inspect.signature(function).parameters.values()
    named = {one.name: known[one.name] for one in kinds if one.kind is one.KEYWORD_ONLY}
    fields = {one.name: known[one.name] * dice.uniform(0.75, 1.2) for one in kinds if one.name not in named}
    if {"a", "c"} <= fields.keys():
        fields["c"] = min(fields["c"], 0.95 * fields["a"])
    return fields, named


Job = tuple[str, list[Any]]
"""The name of a program and its arguments."""


def in_javascript(package: Package, group: str, name: str) -> tuple[Callable[[str], list[str]], Callable[..., Any]]:
    """What takes a function along and says its arguments, and what runs jobs."""
    script = Script(package)

    def add(own: str) -> list[str]:
        script.add(f"{group}.{name}", own)
        return [one.arg for one in package.program(f"{group}.{name}", own)[1].args.args]

    def run(jobs: list[Job]) -> list[str]:
        names = {own: script.add(f"{group}.{name}", own) for own, _ in jobs}
        text = f"""{script.text()}
const known = {{ {", ".join(f"{own}: {there}" for own, there in names.items())} }};
for (const [name, given] of {json.dumps(jobs)}) console.log(String(known[name](...given)));
"""
        done = subprocess.run([str(NODE), "-"], input=text, capture_output=True, text=True, check=True, timeout=120)
        return done.stdout.replace("Infinity", "inf").split()

    return add, run


def in_c(package: Package, group: str, name: str) -> tuple[Callable[[str], list[str]], Callable[..., Any]]:
    """The same by the compiler of the machine; a polynomial has its coefficients one by one."""
    file = File(package)
    coefficients = PARAMETERS.get(name, {}).get("A", ())
    known = {"A": tuple(Number("A") for _ in coefficients)} if name == "polynomial" else {}

    def add(own: str) -> list[str]:
        file.add(f"{group}.{name}", own, f"own_{own}", known)
        return [one.arg for one in package.program(f"{group}.{name}", own)[1].args.args]

    def run(jobs: list[Job]) -> list[str]:
        flat = [(own, [x for one in given for x in (one if isinstance(one, list | tuple) else [one])])
                for own, given in jobs]  # fmt: skip
        counts = {own: len(given) for own, given in flat}
        cases = "".join(
            f'  if (!strcmp(name, "{own}")) return own_{own}({", ".join(f"x[{n}]" for n in range(count))});\n'
            for own, count in counts.items()
        )
        text = f"""{file.text()}
#include <stdio.h>
#include <string.h>
static double called(const char *name, const double *x) {{
{cases}  return *x;
}}
int main(void) {{
  char name[80];
  double x[20];
  int count, place;
  while (scanf("%79s %d", name, &count) == 2) {{
    for (place = 0; place < count; place++) if (scanf("%lf", x + place) != 1) return 1;
    printf("%.17g\\n", called(name, x));
  }}
  return 0;
}}
"""
        lines = "\n".join(f"{own} {len(given)} {' '.join(map(repr, given))}" for own, given in flat)
        with tempfile.TemporaryDirectory() as folder:
            program = Path(folder) / "program"
            command = ["cc", "-std=c99", "-Wall", "-Werror", "-O2", "-x", "c", "-", "-o", str(program), "-lm"]
            made = subprocess.run(command, input=text, capture_output=True, text=True, check=False, timeout=300)
            assert not made.returncode, made.stderr[:2000]
            done = subprocess.run([str(program)], input=lines, capture_output=True, text=True, check=True, timeout=120)
        return done.stdout.split()

    return add, run


LANGUAGES = {"javascript": in_javascript, "c": in_c}
needs_node = pytest.mark.skipif(NODE is None, reason="no node 18 or later: apt-get install nodejs")
needs_cc = pytest.mark.skipif(shutil.which("cc") is None, reason="no C compiler: apt-get install gcc libc6-dev")
SPOKEN = [pytest.param("javascript", marks=needs_node), pytest.param("c", marks=needs_cc)]


def compared(
    package: Package, language: str, group: str, name: str, count: int
) -> list[tuple[str, float, float, float]]:
    """Of drawn arguments: the function, its value here and there, and the size that errors are measured by."""
    module, jobs = import_module(f"axicontact.{group}.{name}"), []
    add, run = LANGUAGES[language](package, group, name)
    dice, found = np.random.default_rng(5), []
    for own in module.__all__:
        function = getattr(module, own)
        if inspect.signature(function).return_annotation == "PeakPressure":
            continue
        try:
            order = add(own)
        except NoProgramError:
            continue
        for _ in range(count):
            fields, named = drawn(name, function, dice)
            here = float(function(*fields.values(), **named))
            parted = float(np.max(size(f"{name}.{own}", group, list(fields), named, *fields.values())))
            found.append((f"{group}.{name}.{own}", here, max(abs(here), parted)))
            given = fields | named
            jobs.append((own, [given[one] for one in order]))
    there = list(map(float, run(jobs)))
    assert len(there) == len(found)
    return [(own, here, value, scale) for (own, here, scale), value in zip(found, there, strict=True)]


@pytest.mark.parametrize("group", GROUPS)
@pytest.mark.parametrize("language", SPOKEN)
@pytest.mark.parametrize("count", [8, pytest.param(400, marks=pytest.mark.slow)])
def test_programs_give_the_numbers_of_the_package(package: Package, language: str, group: str, count: int) -> None:
    names = [own for own in import_module(f"axicontact.{group}").__all__ if count > 8 or own in FEW]
    rows, beyond, total = [], 0, 0
    for name in names:
        for own, here, there, scale in compared(package, language, group, name, count):
            total += 1
            if here == there or (math.isnan(here) and math.isnan(there)):
                continue
            error = abs(here - there) / np.spacing(scale)
            beyond += not error <= 4.0
            if not error <= MOST:
                rows.append(f"{own}: {there!r} for {here!r}, {error:.3g} units")
    assert total >= count
    assert not rows, "\n".join(rows)
    assert beyond <= RARE * total + 1, f"{beyond} of {total} values differ by more than 4 units"


@pytest.mark.skipif(NODE is None, reason="no node 18 or later: apt-get install nodejs")
@pytest.mark.parametrize("name", ["gamma", "lgamma", "fsum", "frexp", "nextafter"])
def test_what_javascript_lacks_is_that_of_python(name: str) -> None:
    dice = np.random.default_rng(2)
    own = {"gamma": dice.uniform(0.6, 160.0, 200), "lgamma": dice.uniform(100.0, 1e4, 200)}
    drawn_ones = own.get(name, 10.0 ** dice.uniform(-300.0, 300.0, 200) * dice.choice([-1.0, 1.0], 200)).tolist()
    calls = {
        "fsum": [[drawn_ones[start : start + 20]] for start in range(0, 200, 20)],
        "nextafter": [[x, x * factor] for x, factor in zip(drawn_ones, (0.5, 2.0) * 100, strict=True)],
    }.get(name, [[x] for x in drawn_ones])
    text = f"{HELPERS.read_text()}\nconsole.log(JSON.stringify({json.dumps(calls)}.map((x) => math.{name}(...x))));"
    done = subprocess.run([str(NODE), "-"], input=text, capture_output=True, text=True, check=True, timeout=60)
    there = np.array(json.loads(done.stdout), float)
    here = np.array([getattr(math, name)(*given) for given in calls], float)
    assert (
        np.abs(here - there)
        <= (4.0 if name == "gamma" else 2.0 if name == "lgamma" else 0.0) * np.spacing(np.abs(here))
    ).all()


def test_what_has_no_program_is_refused(package: Package) -> None:
    """And leaves the file as it was."""
    script = Script(package)
    script.add("normal.cone", "force")
    before = script.text()
    with pytest.raises(NoProgramError, match=r"adhesive\.cone\.pull_off has no program"):
        script.add("adhesive.cone", "pull_off")
    with pytest.raises(NoProgramError, match="no counterpart"):
        script.add("adhesive.gaussian", "radius_from_depth")
    assert script.text() == before


LACKING = {("adhesive", own) for own in ("pull_off", "retraction", "radius_from_depth", "radius_from_force")} | {
    ("tangential", "traction"), ("loads", "displacement"), ("normal", "pressure"), ("adhesive", "pressure"),
}  # fmt: skip
"""Several numbers, what all profiles share, branches that are looked for on a grid, and integrals over integrals."""
MISSING = {"c": (21, 71), "javascript": (23, 74)}
"""How many of these there are, of few profiles and of all."""


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("every", [False, pytest.param(True, marks=pytest.mark.slow)])
def test_what_is_a_program_is_one_in_other_languages(package: Package, language: str, every: bool) -> None:
    missing = []
    for group in GROUPS:
        for name in import_module(f"axicontact.{group}").__all__:
            if not (every or name in FEW):
                continue
            add, _ = LANGUAGES[language](package, group, name)
            for own in import_module(f"axicontact.{group}.{name}").__all__:
                try:
                    add(own)
                except NoProgramError:
                    missing.append((group, own))
    assert set(missing) <= LACKING
    assert len(missing) == MISSING[language][every]


SMALL = """
from math import exp, sqrt
from ..._runtime.plain import MATH as np


def swapped(x, y):
    try:
        for _ in range(40):
            x, y = (y, 0.5 * (x + y))
            if abs(x - y) < 1e-3:
                break
        return x - 2.0 * y
    except ArithmeticError:
        return None


def searched(x, y):
    try:
        def curve(t):
            return (t * t * y + shift, 2.0 * t * y)

        shift = exp(-x)
        t = 1.0
        for step in range(60):
            value, slope = curve(t)
            before, t = (t, t - (value - x - shift) / slope)
            if step > 50 or abs(t - before) <= 1e-15 * t:
                return t if y > 0.5 else -t
        return t
    except ArithmeticError:
        return None


def chosen(x, y):
    try:
        least, most = (x, y) if x < y else (y, x)
        total = [sqrt(least * k) for k in range(1, 4)]
        found = 0.0
        for own in total[::-1]:
            if own > most:
                continue_with = 2.0
            else:
                continue_with = 0.5
            found = found * continue_with + own
            if found > 3.0:
                break
        return found if not (least > 0.3) & (most > 0.9) else np.maximum(found, least // 1.0 if False else most)
    except ArithmeticError:
        return None
"""


@needs_cc
@pytest.mark.parametrize("name", ["swapped", "searched", "chosen"])
def test_statements_mean_in_c_what_they_mean_in_python(package: Package, name: str, tmp_path: Path) -> None:
    """Assignments side by side, loops that are left, results at several places, functions within functions."""
    there = Package({**package.texts, "axicontact/_programs/normal/small.py": SMALL})
    file = File(there)
    file.add("normal.small", name, name)
    rows = "".join(f'  printf("%.17g\\n", {name}({x!r}, {y!r}));\n' for x, y in POINTS)
    (tmp_path / "small.c").write_text(f"{file.text()}\n#include <stdio.h>\nint main(void)\n{{\n{rows}  return 0;\n}}\n")
    command = ["cc", "-std=c99", "-Wall", "-Werror", "-O2", "small.c", "-o", "small", "-lm"]
    subprocess.run(command, cwd=tmp_path, check=True, timeout=60)
    done = subprocess.run([str(tmp_path / "small")], capture_output=True, text=True, check=True)
    space: dict[str, Any] = {}
    exec(SMALL.replace("from ..._runtime.plain", "from axicontact._runtime.plain"), space)
    assert [float(line) for line in done.stdout.split()] == [space[name](x, y) for x, y in POINTS]


POINTS = [(0.2, 0.7), (0.7, 0.2), (1.3, 0.4), (0.4, 1.3), (2.5, 2.0), (0.05, 0.9)]
