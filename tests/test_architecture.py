"""The structure of the engine in figures: each may only get better, and a change that does lowers it here."""

from __future__ import annotations

import ast
import re
from collections import Counter, defaultdict
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

import axiderive

ENGINE = Path(axiderive.__file__).parent
ROOMS = (
    *("exits", "notation", "letters", "entry", "profiles", "abel", "physics", "oracle", "proof", "checks"),
    *("stable", "code", "languages", "store", "print", "rows", "figures", "worked", "book", "web"),
    *("readback", "verifier"),
    *("chapter11", "build", "expression", "scene", "study", "commands", "cli"),
)
"""From the vocabulary to the command line: a room imports only what stands before it."""
VIEWS = {("entry", "profiles"), ("entry", "book")}
"""What an entry asks for inside a function or for a type alone: its profile's type, and its formula in Jupyter."""
LINES, FILES = 58059, 301
"""Of what the first edition could do, with the ways it is run; 334 of them, in files that are older, are ramps and ways
back of profiles that are no powers, 105 the work of adhesion from a pull-off force, 90 scenes with words and layers,
229 the greatest pressure on the axis and under spheres, 89 scenes in which a cohesive zone breaks, 41 programs of two
results and a prover that reads a formula once, 45 text of formulas that is made once and partial builds that report no
difference, 48 springs over plain numbers, points inside of a level, places of kernels that are derived with them and a
greatest pressure that is an integral."""
LATER = (
    *("physics/subsurface", "proof/rules/subsurface", "oracle/subsurface", "checks/subsurface", "code/subsurface"),
    *("runtime/subsurface/", "stable/fields", "rows/fields", "readback/fields", "figures/contours"),
    *("abel/field_moments", "languages/", "study/languages", "web/calculator", "scene/translation"),
    *("physics/torsion", "runtime/physics/torsion", "runtime/physics/retraction", "scene/fields", "scene/relaxing"),
    *("physics/consequences/", "code/bodies/consequences", "runtime/shapes/energy", "runtime/shapes/load_within"),
    *("physics/cohesive", "code/physics/cohesive", "runtime/physics/cohesive"),
    "code/physics/separation",
    *("physics/layer", "oracle/layer", "checks/layer", "code/physics/layer", "runtime/physics/layer"),
    *("rows/layer", "readback/layer", "scene/layered"),
)
"""What came since, counted by itself: fields below the surface; torsion; cohesive zones; layers; a way back; load
within a radius and energy; the work of adhesion from a pull-off force; other languages and calculators."""
WHOLE = 69088
"""Lines with all of that; 3 of them refuse a scene without a program before anything is integrated, 261 are closed
forms and shorter rules of fields, 112 states of cohesive zones that know how they go on, weighed where asked."""
FULL = {"physics": 17}
"""Folders with more than 15 files: each physics is one, whatever else they rest on."""
PHYSICS = {"normal", "adhesive", "tangential", "viscoelastic", "plane", "graded", "loads", "materials", "detachment"}
NAMED, KINDS = 5, 8
"""Comparisons with the name of a physics, and with a kind of contact."""
LITERALS, LITERAL_FILES = 1246, 107
"""Keys of quantities as literals, and files that have some."""
RUNTIME = ("", "shapes", "physics", "graded", "subsurface")
"""Folders of the run time: one imports only what stands before it, and `arrays` only what stands in the root."""
SUFFIXES = {
    *("d", "F", "p", "w", "k", "pm", "ad", "aF", "Fd", "dF", "rz", "dmin", "Fmin", "Dl", "ac", "Fc", "dc", "am", "Fm"),
    *("dm", "tau", "u", "us", "c", "P", "s", "aP", "xz", "Pmin", "phi", "cw", "rp", "pp", "Fr", "U"),
}
"""Keys of quantities."""


@cache
def sources() -> dict[str, ast.Module]:
    """The modules of the engine by dotted name; the runtime, which is copied into the catalogue, apart."""
    found = {}
    for path in sorted(ENGINE.rglob("*.py")):
        parts = path.relative_to(ENGINE).with_suffix("").parts
        if "runtime" not in parts:
            found[".".join(part for part in parts if part != "__init__")] = ast.parse(path.read_bytes())
    return found


@cache
def nodes() -> dict[str, dict[type, list[Any]]]:
    """All parts of each module by their kind, found in one walk."""
    found: dict[str, dict[type, list[Any]]] = {}
    for name, tree in sources().items():
        own = found[name] = defaultdict(list)
        for node in ast.walk(tree):
            own[type(node)].append(node)
    return found


def imported(name: str, *, inside: bool) -> Iterator[str]:
    """What a module imports of the engine: at its top, or inside its functions too."""
    parts = name.split(".")
    package = parts if (ENGINE.joinpath(*parts) / "__init__.py").is_file() else parts[:-1]
    for node in nodes()[name][ast.ImportFrom] if inside else _at_top(sources()[name]):
        if isinstance(node, ast.ImportFrom) and node.level:
            base = [*package[: len(package) - node.level + 1], *(node.module or "").split(".")]
            for alias in node.names:
                own = ".".join(part for part in [*base, alias.name] if part)
                yield own if own in sources() else ".".join(filter(None, base))


def _at_top(node: ast.AST) -> Iterator[ast.AST]:
    """What runs when a module is imported."""
    yield node
    if isinstance(node, ast.If) and isinstance(node.test, ast.Name) and node.test.id == "TYPE_CHECKING":
        return
    if isinstance(node, ast.FunctionDef | ast.expr):
        return
    for child in ast.iter_child_nodes(node):
        yield from _at_top(child)


def room(name: str) -> str:
    return name.partition(".")[0]


def test_rooms_import_in_one_direction():
    known = {room(name) for name in sources() if name}
    assert known == set(ROOMS)
    back = {
        (name, other)
        for name in sources() if name
        for other in imported(name, inside=True)
        if other and ROOMS.index(room(other)) > ROOMS.index(room(name)) and (room(name), room(other)) not in VIEWS
    }  # fmt: skip
    assert not back


def test_no_circle_of_modules():
    """Every module can be put behind all it imports at its top."""
    pending = {name: {other for other in imported(name, inside=False) if other != name} for name in sources()}
    while pending:
        ready = {name for name, needs in pending.items() if not needs & pending.keys()}
        assert ready, f"these import each other: {sorted(pending)}"
        pending = {name: needs for name, needs in pending.items() if name not in ready}


def folders_imported(path: Path) -> set[str]:
    """The folders of which a file of the run time imports something at its top; its own is no other."""
    own, found = path.parent.relative_to(ENGINE / "runtime").as_posix().strip("."), set[str]()
    for node in ast.parse(path.read_bytes()).body:
        if isinstance(node, ast.ImportFrom) and node.level:
            said = (node.module or "").rpartition(".")[0]
            found.add(own if node.level == 1 and own else said)
    return found - {own}


def test_folders_of_the_run_time_import_in_one_direction():
    files = [path for path in (ENGINE / "runtime").rglob("*.py") if path.name != "expressions.py"]
    assert {path.parent.name for path in files} == {"runtime", "arrays", *RUNTIME[1:]}
    for path in files:
        own = path.parent.relative_to(ENGINE / "runtime").as_posix().strip(".")
        before = {""} if own == "arrays" else {*RUNTIME[: RUNTIME.index(own)]}
        assert folders_imported(path) <= before, path


def test_files_and_lines():
    files = [path for path in ENGINE.rglob("*.py") if "__pycache__" not in path.parts]
    lines = {path.relative_to(ENGINE).as_posix(): len(path.read_bytes().splitlines()) for path in files}
    assert all(any(name.startswith(own) for name in lines) for own in LATER)
    first = {name: count for name, count in lines.items() if not name.startswith(LATER)}
    assert len(first) <= FILES
    assert sum(first.values()) <= LINES
    assert sum(lines.values()) <= WHOLE
    count = Counter(path.parent.relative_to(ENGINE).as_posix() for path in files)
    assert {folder: number for folder, number in count.items() if number > FULL.get(folder, 15)} == {}


def comparisons(values: set[str]) -> int:
    """How often something is compared with one of some words, or asked whether it begins with one."""
    found = 0
    for own in nodes().values():
        for node in (*own[ast.Compare], *own[ast.Call]):
            words: list[ast.AST] = []
            if isinstance(node, ast.Compare):
                words = [node.left, *node.comparators]
            elif isinstance(node.func, ast.Attribute):
                words = [*node.args] if node.func.attr in ("startswith", "endswith", "removeprefix") else []
            texts = {one.value for word in words for one in ast.walk(word) if isinstance(one, ast.Constant)}
            found += any(isinstance(text, str) and text.strip(".") in values for text in texts)
    return found


def test_nobody_compares_names_of_physics():
    assert comparisons(PHYSICS) <= NAMED


def test_nobody_compares_kinds_of_contact():
    assert comparisons({"complete", "compact"}) <= KINDS


def test_keys_of_quantities_are_not_typed():
    count = {
        name: sum(node.value in SUFFIXES for node in own[ast.Constant])
        for name, own in nodes().items()
        if room(name) != "physics"
    }
    assert sum(count.values()) <= LITERALS
    assert sum(map(bool, count.values())) <= LITERAL_FILES


def test_public_functions_say_what_they_return():
    missing = [
        f"{name}.{node.name}"
        for name, tree in sources().items()
        for scope in (tree, *(one for one in tree.body if isinstance(one, ast.ClassDef)))
        for node in scope.body
        if isinstance(node, ast.FunctionDef | ast.ClassDef) and not node.name.startswith("_")
        if ast.get_docstring(node) is None
    ]
    assert not missing


def test_the_guides_name_files_and_tables_that_are_there():
    """Each `TABLE` of a file, and each file of a room, that CONTRIBUTING or the page on the house sends a reader to."""
    root = ENGINE.parents[1]
    text = (root / "CONTRIBUTING.md").read_text() + (root / "docs" / "architecture.md").read_text()
    named = set(re.findall(r"`((?:\w+/)+\w+\.py)`", text))
    places = (ENGINE, root, root / "catalogue", root / "catalogue" / "axicontact")
    assert len(named) > 40
    assert not [name for name in named if not any((place / name).is_file() for place in places)]
    tables = re.findall(
        r"`([A-Z_]{4,})`(?:,\s| and\s|\s)*(?:`[A-Z_]+`(?:,\s| and\s|\s))*of\s+`((?:\w+/)+\w+\.py)`", text
    )
    assert len(tables) > 4
    assert not [(t, name) for t, name in tables if not re.search(rf"^{t}\b", (ENGINE / name).read_text(), re.MULTILINE)]
