"""Scenes: one self-contained module with what is asked for; all problems at once; nothing outside the folder."""

from __future__ import annotations

import ast
import hashlib
import json
import math
import random
import re
import subprocess
import sys
import time
from pathlib import Path

import pytest

from axiderive.cli import main
from axiderive.exits import CommandError
from axiderive.scene import reading, sources, text
from axiderive.scene.commands import _request as request_of
from axiderive.scene.compose import Result, composed
from axiderive.scene.page import escaped
from axiderive.scene.text import SceneError

EXAMPLES = Path(__file__).parents[1] / "examples"
NEEDLE = (EXAMPLES / "needle_on_gel.toml").read_text()
NO_PDF = '\n[output]\nformats = ["python", "tex", "json"]\n'


OUTSIDE = "h*(1 - 1/cosh(r/q))"


def composed_from(source: str) -> Result:
    return composed(request_of(reading.read(text.parse("scene", source.encode())), source))


def problems(source: str) -> str:
    with pytest.raises(SceneError) as caught:
        reading.read(text.parse("scene.toml", source.encode()))
    return str(caught.value)


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
    assert len(source.splitlines()) <= 104
    assert len([line for line in source.splitlines() if line.strip()]) <= 79
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


def test_the_page_holds_the_kind_of_contact_and_its_evidence_and_no_other(needle):
    page = (needle / "profiles" / "cone.tex").read_text()
    titles = re.findall(r"^\\sect.*\{([^{}]*)\}$", page, re.MULTILINE)
    assert titles == ["Normal contact", "Adhesive contact", "Derivation", "Evidence", "Sources"]
    marks = set(re.findall(r"\\own\{([\w.]+)\}", page))
    assert {"d", "p", "adh.Dl", "adh.dm", "adh.aF"} <= marks
    assert not [mark for mark in marks if mark.startswith(("tan.", "fgm.", "vis."))]
    assert all(page.count("{" + word) == page.count("end{" + word) + page.count("begin{" + word)
               for word in ("tabular*}", "tikzpicture}", "minipage}"))  # fmt: skip
    assert r"N/m" in (needle / "page.tex").read_text()
    assert r"here $2666667$" in (needle / "page.tex").read_text()


@pytest.mark.parametrize("path", sorted(EXAMPLES.glob("*.toml")), ids=lambda path: path.stem)
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
    assert done.stdout == "18 values agree\n"


def test_the_test_fails_for_a_wrong_module(needle, tmp_path):
    """A constant changed by 1e-9 is found."""
    for name in ("needle_on_gel.py", "test_needle_on_gel.py"):
        (tmp_path / name).write_text((needle / name).read_text())
    module = tmp_path / "needle_on_gel.py"
    module.write_text(module.read_text().replace("dgamma = 0.05 ", "dgamma = 0.0500000001 "))
    done = subprocess.run([sys.executable, "test_needle_on_gel.py"], cwd=tmp_path, capture_output=True, check=False)
    assert done.returncode == 1


def test_the_same_scene_gives_the_same_bytes():
    assert composed_from(NEEDLE + NO_PDF).files == composed_from(NEEDLE + NO_PDF).files


def test_a_scene_of_the_catalogue_takes_less_than_two_seconds():
    composed_from(NEEDLE + NO_PDF)
    start = time.process_time()
    composed_from(NEEDLE + NO_PDF)
    assert time.process_time() - start < 2.0


def test_free_parameters_stay_keywords_and_are_checked():
    source = 'profile = "cone"\n[want]\nquantities = ["force"]' + NO_PDF
    space: dict[str, object] = {}
    exec(composed_from(source).files["scene.py"].decode(), space)
    force = space["force"]
    assert force(1.0, theta=0.1, E_star=2.0) == pytest.approx(0.31521, rel=1e-4)
    with pytest.raises(ValueError, match="theta = 2.0 is outside"):
        force(1.0, theta=2.0, E_star=2.0)


@pytest.mark.parametrize(
    "source",
    [
        'profile = "q*r**2 + c*r**4"\n[parameters]\nq = 3\nc = "2 mm^-3"\n[physics]\nadhesive = { dgamma = 0.1 }\n',
        'profile = "q*r**2 + Max(0, r - b)*tan(theta)"\n[parameters]\nb = 0.002\n[physics]\nadhesive = true\n',
        'profile = "rounded_punch"\n[parameters]\nR = "2 mm"\nb = "5 mm"\n[physics]\ntangential = { mu = 0.2 }\n',
        'profile = "concave_paraboloid"\n[medium]\nE_star = "2 GPa"\n',
        'profile = "cone"\n[parameters]\ntheta = "10 deg"\n[medium]\nkind = "power_law"\nH = 1e6\nk = 0.3\n',
        f'profile = "{OUTSIDE}"\n[parameters]\nh = 1e-3\nq = 0.01\n[physics]\nadhesive = {{ dgamma = 0.1 }}\n',
        f'profile = "{OUTSIDE}"\n[parameters]\nh = 1e-3\nq = 0.01\n[physics]\ntangential = true\n',
        'profile = "r**2/(2*R) + c*r**4"\n[medium]\nkind = "power_law"\nk = 0.3\n',
    ],
    ids=[
        "expression with adhesion",
        "break and free parameters",
        "tangential",
        "complete",
        "graded",
        "adhesive outside the normal form",
        "tangential outside the normal form",
        "graded expression",
    ],  # fmt: skip
)
def test_other_combinations(source):
    result = composed_from(source + NO_PDF)
    assert "values agree with the definition" in result.lines[-1]
    compile(result.files["test_scene.py"], "test_scene.py", "exec")


LAWS = {
    "maxwell": 'E = "2 MPa", tau = "3 s"',
    "kelvin_voigt": 'E = "2 MPa", eta = "4 MPa s"',
    "standard_solid": 'E_inf = "1 MPa", E_1 = "2 MPa", tau = "3 s"',
    "power_creep": 'E = "2 MPa", alpha = 0.25, t_0 = "1 min"',
}


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("profile", ["cone", "truncated_cone"])
def test_viscoelastic_scenes_agree_with_the_convolution(profile, law):
    """The values are convolutions of the elastic quadrature; measured 8e-16 at worst."""
    material = f'viscoelastic = {{ model = "{law}", {LAWS[law]} }}'
    result = composed_from(f'profile = "{profile}"\n[physics]\n{material}' + NO_PDF)
    evidence = json.loads(result.files["evidence.json"])
    errors = {name: float(error) for name, error in evidence["module against 20-digit quadrature"].items()}
    assert set(errors) == {"step_force", "step_load_radius"} | ({"ramp_force"} if profile == "cone" else set())
    assert max(errors.values()) < 1e-14
    module = result.files["scene.py"].decode()
    assert "def step_force(t, d" in module
    assert not [other for other in LAWS if f"_{other}(" in module and other != law]
    titles = re.findall(r"^\\sect.*\{([^{}]*)\}$", result.files[f"profiles/{profile}.tex"].decode(), re.MULTILINE)
    assert "Viscoelastic half-space" in titles
    assert "Adhesive contact" not in titles


def test_a_wrong_relaxation_does_not_pass(monkeypatch):
    module = sources.stored("viscoelastic/cone.py")
    assert module is not None
    monkeypatch.setattr(
        sources, "_viscoelastic", lambda name: module.replace("ramp_maxwell(t, 2.0", "ramp_maxwell(t, 1.0")
    )
    with pytest.raises(ArithmeticError, match="ramp_force"):
        composed_from('profile = "cone"\n[physics]\nviscoelastic = { model = "maxwell" }' + NO_PDF)


def test_the_worked_example_is_at_the_force_that_was_asked_for():
    """The state stands in the docstring; every function is tested there; the force found again is the one given."""
    files = composed_from(NEEDLE + NO_PDF).files
    docstring = ast.get_docstring(ast.parse(files["needle_on_gel.py"].decode()))
    assert "at F = 0.05 N it is a = 0.0003205988 m" in docstring
    space: dict[str, object] = {}
    exec(files["needle_on_gel.py"].decode(), space)
    assert space["force"](0.000320598788133061) == pytest.approx(0.05, rel=1e-12)
    assert files["test_needle_on_gel.py"].decode().count("0.000320598788133061") == 6


@pytest.mark.parametrize("load", ['{ d = "0.1 um" }', '{ F = "-1 N" }'])
def test_a_worked_example_without_a_contact_is_refused(load):
    source = NEEDLE.replace('{ F = "50 mN" }', load).replace('"50 mJ/m^2"', '"5 mJ/m^2"')
    if "F" in load:
        with pytest.raises(CommandError, match="no contact radius carries F = -1; change want.at"):
            composed_from(source + NO_PDF)
    else:
        assert composed_from(source + NO_PDF).files


def test_the_inverses_of_a_contact_that_is_compact_up_to_a_radius_end_there():
    """g(a) = a**2/R - 8/3 c a**4 has its largest value at a**2 = 3/(16 c R); beyond that depth there is no contact."""
    source = 'profile = "r**2/(2*R) - c*r**4"\n[want]\nquantities = ["depth", "radius_from_depth"]\n'
    with pytest.raises(CommandError, match="how far the contact is compact depends on R, c"):
        composed_from(source + NO_PDF)
    space: dict[str, object] = {}
    exec(composed_from(source + "[parameters]\nR = 1.0\nc = 1.0\n" + NO_PDF).files["scene.py"].decode(), space)
    reach = (3 / 16) ** 0.5
    assert space["radius_from_depth"](space["depth"](0.9 * reach)) == pytest.approx(0.9 * reach, rel=1e-12)
    assert math.isnan(space["radius_from_depth"](1.01 * space["depth"](reach)))


READ_BACK = b"read back from this source"


@pytest.mark.parametrize("profile", ["cone", "c*r**4", "r**2/sqrt(r**2 + q**2)", OUTSIDE])
def test_only_pages_of_the_catalogue_say_that_they_were_read_back(profile):
    preamble = composed_from(f'profile = "{profile}"\n' + NO_PDF).files["preamble.tex"]
    assert (READ_BACK in preamble) == (profile == "cone")


def test_a_page_is_written_outside_the_normal_form():
    source = f'profile = "{OUTSIDE}"\n' + NO_PDF
    page = composed_from(source).files["profiles/own_profile.tex"].decode()
    assert r"\int_{0}^{\sqrt{a^{2}-r^{2}}}\frac{g'(t)}{t}" in page
    assert page.count(r"\int") == 5


BAD = """\
name = "bad"
colour = "red"

[profil]
kind = "cone"

[profile]
kind  = "cone"
theta = 8
tehta = 1

[medium]
E  = "2 mm"
nu = 0.7

[physics]
adhesive   = { dgamma = "50 mJ" }
tangential = { mu = 0.3 }
plane      = true

[want]
quantities = ["depht"]

[output]
folder = "../elsewhere"
"""
GOLDEN = """\
scene.toml:2: unknown key 'colour'; there are name, title, profile, parameters, medium, physics, want, output
     2 | colour = "red"
scene.toml:4: unknown section 'profil'; did you mean 'profile'?
     4 | [profil]
scene.toml:9: theta = 8 is outside 0 < theta < pi/2; degrees need a unit: theta = "8 deg"
     9 | theta = 8
scene.toml:10: unknown parameter of cone 'tehta'; did you mean 'theta'?
    10 | tehta = 1
scene.toml:13: E must be a pressure, but '2 mm' is a length; write '5 MPa'
    13 | E  = "2 mm"
scene.toml:14: nu = 0.7 is outside -1 < nu <= 0.5; 0.5 is an incompressible half space
    14 | nu = 0.7
scene.toml:17: dgamma: unit 'mJ' in '50 mJ' is unknown; did you mean 'mJ/m^2'?
    17 | adhesive   = { dgamma = "50 mJ" }
scene.toml:18: adhesive and tangential together are not derived; emit two scenes, one with each
    18 | tangential = { mu = 0.3 }
scene.toml:19: plane is not emitted for scenes yet; the nearest is adhesive = { dgamma = "50 mJ/m^2" } or normal = true
    19 | plane      = true
scene.toml:22: unknown quantity 'depht' of adhesive; did you mean 'depth'?
    22 | quantities = ["depht"]
scene.toml:25: folder '../elsewhere' leaves the place of the scene; use a name below it, or --out DIR
    25 | folder = "../elsewhere"
11 problems in the scene; nothing was written"""


def test_all_problems_come_at_once_with_line_value_rule_and_suggestion():
    assert problems(BAD) == GOLDEN


@pytest.mark.parametrize(
    ("source", "message"),
    [
        ('profile = "kone"', "unknown profile 'kone'; did you mean 'cone'?"),
        ("[profile]\nkind = 3", "the profile must be a text, not int"),
        ("", "the scene names no profile"),
        ('profile = "cone', "is a quote or a bracket missing?"),
        ('profile = "1 + r"', "f(0) = 1"),
        ('profile = "sphere_tipped_cone"\n[parameters]\nR = 1.0\ntheta = "120 deg"', "is outside 0 < theta < pi/2"),
        ('profile = "flat_punch"\n[physics]\nadhesive = true', "the nearest is normal = true"),
        ('profile = "polynomial"', "write it as an expression"),
        ('profile = "cone"\n[medium]\nE = 1', "nu is missing"),
        ('profile = "cone"\n[output]\nmodule = "../x.py"', "module must be the name of a file"),
        ('profile = "cone"\n[parameters]\ntheta = true', "must be a number or a text with a unit, not bool"),
        ('profile = "cone"\n[parameters]\ntheta = inf', "no finite number"),
        ('profile = "cone"\n[parameters]\ntheta = "8 mm"', "theta must be an angle, but '8 mm' is a length"),
        ('profile = "cone"\nparameters.theta = 8', "degrees need a unit"),
        ('profile = { kind = "cone", theta = 8 }', "degrees need a unit"),
        ('profile = "cone"\n[medium]\nkind = "layered"', "unknown medium 'layered'"),
        ('profile = "cone"\n[medium]\nkind = "power_law"\nk = 1.2', "k = 1.2 is outside -1 < k < 1"),
        ('profile = "cone"\n[medium]\nc0 = 1', "unknown key in [medium] 'c0'"),
        ('profile = "cone"\n[physics]\nviscoelastic = { model = "kelvin" }', "did you mean 'kelvin_voigt'?"),
        ('profile = "cone"\n[physics]\nviscoelastic = true', "viscoelastic needs a model out of maxwell"),
        ('profile = "cone"\n[physics]\nviscoelastic = { model = "maxwell", tau = "3 mm" }', "must be a time"),
        ('profile = "cone"\n[physics]\nviscoelastic = { model = "maxwell", eta = 1 }', "unknown key 'eta'"),
        ('profile = "cone"\n[medium]\nE_star = 1\n[physics]\nviscoelastic = { model = "maxwell" }', "leave [medium]"),
        ('profile = "r**2"\n[physics]\nviscoelastic = { model = "maxwell" }', "profiles of the catalogue"),
        (
            'profile = "sphere"\n[physics]\nviscoelastic = { model = "maxwell" }\n[want]\nquantities = ["ramp_force"]',
            "unknown quantity 'ramp_force'",
        ),
        ('profile = "cone"\n[physics]\nplane = true', "plane is not emitted"),
        ('profile = "cone"\n[output]\nformats = ["exe"]', "formats must be a list out of python"),
        ('profile = "cone"\n[want]\nat = { F = "50 mN" }', "freeze theta, E_star too"),
        ('profile = "cone"\n[want]\nat = { p = 1 }', "at names one field of the contact"),
        ('profile = "cone"\n[want]\nat = { F = "50 mm" }', "F must be a force, but '50 mm' is a length"),
        (f'profile = "{OUTSIDE}"\n[medium]\nkind = "power_law"', "the nearest are sums of powers of r"),
        ('profile = "R - sqrt(R**2 - r**2"', "'(' was never closed"),
    ],
)
def test_a_problem_says_what_to_do(source, message):
    found = problems(source)
    assert message in found
    assert re.match(r"scene\.toml:\d+: ", found) or not source


def test_bytes_that_are_no_text_are_refused():
    with pytest.raises(SceneError, match="is no UTF-8"):
        text.parse("s", b'profile = "\xff"')


def test_a_folder_through_a_link_is_refused(tmp_path, capsys):
    elsewhere = tmp_path / "elsewhere"
    (tmp_path / "scenes").mkdir()
    elsewhere.mkdir()
    (tmp_path / "scenes" / "out").symlink_to(elsewhere)
    scene = tmp_path / "scenes" / "scene.toml"
    scene.write_text('profile = "cone"\n[output]\nfolder = "out"\n')
    assert main(["emit", str(scene)]) == 2
    assert "leads out of" in capsys.readouterr().err
    assert not list(elsewhere.iterdir())


def test_a_dry_run_writes_nothing(tmp_path, capsys):
    scene = tmp_path / "scene.toml"
    scene.write_text(NEEDLE)
    assert main(["emit", "--dry-run", str(scene)]) == 0
    assert "frozen      theta = 0.13962634015954636, E_star = 2666666.6666666665" in capsys.readouterr().out
    assert [path.name for path in tmp_path.iterdir()] == ["scene.toml"]


def test_nothing_in_a_title_is_a_command_of_latex_or_python():
    assert escaped(r"\input{/etc/passwd} $x$ 100% #1 a_b ~^&") == (
        r"\textbackslash{}input\{/etc/passwd\} \$x\$ 100\% \#1 a\_b \textasciitilde{}\textasciicircum{}\&"
    )
    source = NEEDLE.replace("Blunt needle on a silicone gel", r"\\write18{x} ''' \" + __import__('os')")
    module = composed_from(source + NO_PDF).files["needle_on_gel.py"].decode()
    tree = ast.parse(module)
    assert ast.get_docstring(tree).startswith("/write18{x}")
    assert "__import__" not in {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)}


@pytest.mark.parametrize("path", sorted(EXAMPLES.glob("*.toml")), ids=lambda path: path.stem)
def test_the_examples_are_scenes(path):
    scene = reading.read(text.load(path))
    assert scene.values
    assert not {p.name for p in scene.profile.parameters} - set(scene.values)


# fuzzing
LINES = (
    'profile = "cone"', 'profile = "r**2/(2*R)"', "[profile]", 'kind = "sphere"', 'kind = "kone"', 'R = "2 mm"',
    'theta = "8 deg"', "theta = 8", 'R = "2 kg"', "[medium]", 'E = "2 GPa"', "nu = 0.3", "nu = 3", 'kind = "power_law"',
    "k = 2", "H = 1e6", "[physics]", "normal = true", 'adhesive = { dgamma = "50 mJ/m^2" }', "adhesive = 3",
    "adhesive = { x = [1, 2] }", "tangential = { mu = -1 }", "plane = true", "[want]",
    'viscoelastic = { model = "maxwell" }', "viscoelastic = true", "viscoelastic = { model = [], tau = {} }",
    'viscoelastic = { model = "power_creep", alpha = 2, t_0 = "1 h" }', 'quantities = ["depth"]',
    "quantities = 3", "quantities = [[1]]", "[output]", 'folder = "../../x"', 'module = "a/b.py"', 'formats = ["exe"]',
    "[[profile]]", 'title = "\\\\x"', "name = 1979-05-27", "[parameters]", "E_star = nan", "[a.b.c]", "x.y = 1",
    'expression = "Max(0, r - b)"', "formats = {}", "folder = 3", "kind = []", "R = {}", 'name = "\u0000"',
)  # fmt: skip


def random_scene(source: random.Random) -> bytes:
    if source.random() < 0.5:
        return "\n".join(source.choice(LINES) for _ in range(source.randint(1, 14))).encode()
    data = bytearray(source.choice((NEEDLE, BAD)).encode())
    for _ in range(source.randint(1, 8)):
        place = source.randrange(len(data))
        data[place : place + source.randint(0, 3)] = bytes(source.randrange(256) for _ in range(source.randint(0, 3)))
    return bytes(data)


def scene_or_problems(seed: int) -> None:
    try:
        scene = reading.read(text.parse("scene", random_scene(random.Random(seed))))
    except SceneError as error:
        assert str(error)
        return
    assert scene.profile is not None
    assert ".." not in Path(scene.folder).parts
    assert "/" not in scene.module


def test_random_scenes_are_read_or_refused():
    for seed in range(300):
        scene_or_problems(seed)


@pytest.mark.slow
def test_many_random_scenes_are_read_or_refused():
    for seed in range(300, 5000):
        scene_or_problems(seed)
