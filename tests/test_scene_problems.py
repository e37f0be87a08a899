"""Scenes with mistakes: all problems at once, with what to do; random ones are read or refused."""

from __future__ import annotations

import random
import re
from pathlib import Path

import pytest
from scenes import BAD, EXAMPLES, NEEDLE, OUTSIDE, problems, random_scene

from axiderive.cli import main
from axiderive.exits import CommandError
from axiderive.scene import reading, text
from axiderive.scene.compose import composed
from axiderive.scene.text import SceneError

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
scene.toml:14: nu = 0.7 is outside -1 < nu <= 1/2; change the value
    14 | nu = 0.7
scene.toml:17: dgamma: unit 'mJ' in '50 mJ' is unknown; did you mean 'mJ/m^2'?
    17 | adhesive   = { dgamma = "50 mJ" }
scene.toml:19: adhesive and tangential and plane together are not derived; emit three scenes, one with each
    19 | plane      = true
scene.toml:22: unknown quantity 'depht' of adhesive; did you mean 'depth'?
    22 | quantities = ["depht"]
scene.toml:25: folder '../elsewhere' leaves the place of the scene; use a name below it, or --out DIR
    25 | folder = "../elsewhere"
10 problems in the scene; nothing was written"""


def test_all_problems_come_at_once_with_line_value_rule_and_suggestion():
    assert problems(BAD) == GOLDEN


@pytest.mark.parametrize(
    ("source", "message"),
    [
        ('profile = "kone"', "unknown profile 'kone'; did you mean 'cone'?"),
        ('[profile]\nkind = "kone"\n[want]\nat = { F = "1 N" }', "1 problem in the scene"),
        ("[profile]\nkind = 3", "the profile must be a text, not int"),
        ("", "the scene names no profile"),
        ('profile = "cone', "is a quote or a bracket missing?"),
        ('profile = "1 + r"', "f(0) = 1"),
        ('profile = "sphere_tipped_cone"\n[parameters]\nR = 1.0\ntheta = "120 deg"', "is outside 0 < theta < pi/2"),
        ('profile = "capped_cylinder"\n[physics]\nadhesive = true', "the nearest is normal = true"),
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
        (
            'profile = "r**2"\n[medium]\nkind = "power_law"\n[physics]\nviscoelastic = { model = "maxwell" }',
            "viscoelastic on a graded half-space is not derived",
        ),
        (
            'profile = "capped_cylinder"\n[physics]\nviscoelastic = { model = "maxwell" }\n'
            '[want]\nquantities = ["ramp_force"]',
            "unknown quantity 'ramp_force'",
        ),
        ('profile = "cone"\n[physics]\nplane = true', "cone is a round profile; write normal = true in place of plane"),
        ('profile = "ecentric_punch"\n[physics]\nplane = true', "did you mean 'eccentric_punch'?"),
        ('profile = "r**2"\n[physics]\nplane = true', "the catalogue holds; the nearest is normal = true"),
        ('profile = "wedge"\n[physics]\nplane = { x = 1 }', "write plane = true"),
        ('profile = "wedge"\n[medium]\nkind = "power_law"\n[physics]\nplane = true', 'is kind = "homogeneous"'),
        ('profile = "wedge"\n[physics]\nplane = true\n[want]\nquantities = ["force"]', "there are profile, load"),
        ('profile = "cone"\n[output]\nformats = ["exe"]', "unknown format 'exe'"),
        ('profile = "cone"\n[want]\nat = { F = "50 mN" }', "freeze theta, E_star too"),
        ('profile = "cone"\n[want]\nat = { p = 1 }', "at names one field of the contact"),
        ('profile = "cone"\n[want]\nat = { F = "50 mm" }', "F must be a force, but '50 mm' is a length"),
        (f'profile = "{OUTSIDE}"\n[medium]\nkind = "power_law"', "there are rules for sums of powers of r"),
        ('name = "class"\nprofile = "cone"', "module 'class.py' cannot be imported, class is a word of Python"),
        ('name = "axicontact"\nprofile = "cone"', "would hide the axicontact of others; choose another name"),
        ('profile = "cone"\n[output]\nmodule = "Numpy.py"', "would hide the numpy of others"),
        ('name = "random"\nprofile = "cone"', "would hide the random of others"),
        ('profile = "R - sqrt(R**2 - r**2"', "'(' was never closed"),
    ],
)
def test_a_problem_says_what_to_do(source, message):
    found = problems(source)
    assert message in found
    assert re.match(r"scene\.toml:\d+: ", found) or not source


@pytest.mark.parametrize(
    ("name", "module"), [("接触", "scene.py"), ("Nädel", "Nadel.py"), ("4 µm", "scene_4_m.py"), ("???", "scene.py")]
)
def test_any_name_has_a_module(name, module):
    """One without ASCII letters ended in a KeyError."""
    found = reading.read(text.parse("scene", f'name = "{name}"\nprofile = "cone"'.encode()))
    assert found.module == module


def test_a_file_too_large_for_a_scene_is_not_read():
    text.parse("s", b"#" * text.LARGEST)
    with pytest.raises(SceneError, match="s: 100001 bytes are no scene, at most 100000 are read"):
        text.parse("s", b"#" * (text.LARGEST + 1))


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


@pytest.mark.parametrize("path", sorted(EXAMPLES.glob("*.toml")), ids=lambda path: path.stem)
def test_the_examples_are_scenes(path):
    scene = reading.read(text.load(path))
    assert scene.values
    assert not {p.name for p in scene.profile.parameters} - set(scene.values)


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


def test_a_parameter_is_not_the_radius_of_stick() -> None:
    scene = 'profile = "q*r**2 + c*r**4"\n[physics]\ntangential = true\n[want]\nquantities = ["traction"]\n'
    request = reading.read(text.parse("scene", scene.encode()))
    with pytest.raises(CommandError, match="c is the radius of stick"):
        composed(request)


@pytest.mark.parametrize(
    ("source", "step"),
    [
        ('profile = "sphere"\nE = "2 GPa"\n', "write it below [medium]"),
        ('profile = "sphere"\nR = "2 mm"\n', "write it below [parameters]"),
        ('profile = "cone"\nquantities = ["force"]\n', "write it below [want]"),
        ('profile = "cone"\n[material]\nnu = 0.3\n', "did you mean 'medium'?"),
        ('profile = "cone"\n[want]\nquantities = ["F"]\n', "did you mean 'force'?"),
        ('profile = "sphere"\n[parameters]\nR = "2,5 mm"\n', "write '2.5 mm'"),
        ('profile = "cone"\n[parameters]\ntheta = "20 grad"\n', "did you mean 'deg'?"),
        ('profile = "cone"\n[medium]\nE_star = "20 N/mm^2"\n', "did you mean 'MPa'?"),
        ('profile = "cone"\n[medium]\nE_star = "20 gpa"\n', "did you mean 'GPa'?"),
        ('profile = "cone"\n[physics]\nadhesive = 0.05\n', "write adhesive = { dgamma = ... }"),
    ],
)
def test_what_newcomers_write_is_answered_with_what_to_write(source, step):
    assert step in problems(source)


def test_a_mark_of_byte_order_is_no_part_of_a_scene():
    assert reading.read(text.parse("scene", b'\xef\xbb\xbfprofile = "cone"\n')).profile.name == "cone"
