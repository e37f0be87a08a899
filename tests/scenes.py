"""What the tests of scenes share: the examples, a scene with every kind of mistake, random scenes."""

from __future__ import annotations

import random
import re
import subprocess
import sys
from pathlib import Path

import pytest

from axiderive.scene import reading, text
from axiderive.scene.compose import Result, composed
from axiderive.scene.linker import library
from axiderive.scene.text import SceneError

EXAMPLES = Path(__file__).parents[1] / "examples"
NEEDLE = (EXAMPLES / "needle_on_gel.toml").read_text()
NO_PDF = '\n[output]\nformats = ["python", "tex", "json"]\n'


OUTSIDE = "h*(1 - 1/cosh(r/q))"


def composed_from(source: str) -> Result:
    return composed(reading.read(text.parse("scene", source.encode())))


def problems(source: str) -> str:
    with pytest.raises(SceneError) as caught:
        reading.read(text.parse("scene.toml", source.encode()))
    return str(caught.value)


def run_plainly(result: Result, folder: Path) -> str:
    """Write the files; what the test of the module prints, run by plain Python with nothing else to import from."""
    for name, content in result.files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
    command = [sys.executable, "-W", "error", "test_scene.py"]
    return subprocess.run(command, cwd=folder, env={}, capture_output=True, text=True, check=True).stdout


def exchanged(monkeypatch: pytest.MonkeyPatch, path: str, right: str, wrong: str) -> None:
    """Another line in a stored module of the catalogue, by the path of its file."""
    text = library.catalogue_text

    def changed(own: str) -> str | None:
        found = text(own)
        if own != path:
            return found
        assert found is not None
        assert right in found
        return found.replace(right, wrong)

    monkeypatch.setattr(library, "catalogue_text", changed)


def titles(page: bytes) -> list[str]:
    """Sections of a page."""
    return re.findall(r"^\\sect.*\{([^{}]*)\}$", page.decode(), re.MULTILINE)


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

LINES = (
    'profile = "cone"', 'profile = "r**2/(2*R)"', "[profile]", 'kind = "sphere"', 'kind = "kone"', 'R = "2 mm"',
    'theta = "8 deg"', "theta = 8", 'R = "2 kg"', "[medium]", 'E = "2 GPa"', "nu = 0.3", "nu = 3", 'kind = "power_law"',
    "k = 2", "H = 1e6", "[physics]", "normal = true", 'adhesive = { dgamma = "50 mJ/m^2" }', "adhesive = 3",
    "adhesive = { x = [1, 2] }", "tangential = { mu = -1 }", "plane = true", "loads = true", 'kind = "wedge"', "[want]",
    'viscoelastic = { model = "maxwell" }', "viscoelastic = true", "viscoelastic = { model = [], tau = {} }",
    'viscoelastic = { model = "power_creep", alpha = 2, t_0 = "1 h" }', 'quantities = ["depth"]',
    "quantities = 3", "quantities = [[1]]", "[output]", 'folder = "../../x"', 'module = "a/b.py"', 'formats = ["exe"]',
    "[[profile]]", 'title = "\\\\x"', "name = 1979-05-27", "[parameters]", "E_star = nan", "[a.b.c]", "x.y = 1",
    'expression = "Max(0, r - b)"', "formats = {}", "folder = 3", "kind = []", "R = {}", 'name = "\u0000"',
    'kind = "eccentric_punch"', 'e = "-3 mm"', "e = 1e300", 'a = "5 mm"', 'kind = "power"', "s = -0.999", "s = -2",
    'kind = "flat_punch"', 'kind = "capped_cylinder"', 'kind = "concave_power"', "n = 1.5", 'kind = "wavy_paraboloid"',
    'wavelength = "1 um"', 'h = "1 nm"', 'quantities = ["pull_off", "minimum_depth", "stiffness", "contact_width"]',
)  # fmt: skip


VALUES = (
    "1e-3", "0.3", "2", "-1", "0", "nan", "inf", "true", "[]", "{}", '""', '"2 mm"', '"8 deg"', '"1 GPa"', '"3 s"',
    '"0.5"', '"1e400 m"', '"2 mm^-3"', '"- 1 m"', "1e-320", "1979-05-27",
)  # fmt: skip
GOOD = {
    "theta": '"8 deg"', "R": '"2 mm"', "b": '"1 mm"', "a": '"3 mm"', "e": '"-1 mm"', "n": "2.5", "h": '"1 um"',
    "s": "0.3", "q": "40", "c": "1e5", "E": '"2 MPa"', "nu": "0.3", "E_star": '"2 MPa"', "G_star": '"1 MPa"',
    "H": "1e6", "k": "0.3", "H_x": "1e6", "wavelength": '"1 mm"',
}  # fmt: skip
PROFILES = {
    '"cone"': ("theta",), '"sphere"': ("R",), '"flat_punch"': ("a",), '"eccentric_punch"': ("a", "e"),
    '"q*r**2"': ("q",), '"power"': ("a", "s"), '"concave_power"': ("a", "h", "n"),
    '"wavy_paraboloid"': ("R", "h", "wavelength"),
    '"truncated_cone"': ("theta", "b"), '"capped_cylinder"': ("a", "R"), '"wedge"': ("theta",), '"uniform"': ("a",),
    '"Max(0, r - b)*tan(theta)"': ("b", "theta"), f'"{OUTSIDE}"': ("h", "q"), '"r**2/(2*R) + c*r**4"': ("R", "c"),
    '"kone"': (), '"r**"': (), "3": (), '"{kind}"': (),
}  # fmt: skip
TABLES = {
    "medium": ('kind = "homogeneous"', 'kind = "power_law"', "E", "nu", "E_star", "G_star", "H", "k", "H_x", "tehta"),
    "physics": (
        "normal = true", "adhesive = true", 'adhesive = { dgamma = "50 mJ/m^2" }', "adhesive = { dgamma = 0 }",
        "tangential = { mu = 0.3 }", "plane = true", "loads = true", 'viscoelastic = { model = "maxwell" }',
        "viscoelastic = true", 'viscoelastic = { model = "power_creep", alpha = 0.3 }', "adhesive = false",
        "subsurface = true", "subsurface = { nu = 0.3, mu = 0 }",
    ),
    "want": (
        'quantities = ["depth"]', 'quantities = ["force", "pressure"]', 'quantities = ["pull_off"]',
        'quantities = ["tilt", "contact_width"]', 'at = { F = "50 mN" }', "at = { a = 1e-3 }", "at = { p = 1 }", "at",
    ),
    "output": ('folder = "x/y"', 'module = "m.py"', "formats = []", 'formats = ["exe"]', "folder", "module"),
}  # fmt: skip


def structured(source: random.Random) -> bytes:
    """A scene that is TOML, with values that mostly suit their keys and keys that mostly suit the profile."""
    profile = source.choice(list(PROFILES))
    lines = [f"profile = {profile}"]
    for section in source.sample(["parameters", *TABLES], source.randint(0, 3)):
        known = PROFILES[profile] if section == "parameters" else TABLES[section]
        rows = source.sample(known, source.randint(0, min(2, len(known))))
        rows += [source.choice(list(GOOD))] if section == "parameters" and source.random() < 0.2 else []
        lines.append(f"[{section}]")
        for row in rows:
            value = GOOD[row] if row in GOOD and source.random() < 0.85 else source.choice(VALUES)
            lines.append(row if "=" in row else f"{row} = {value}")
    return ("\n".join(lines) + "\n").encode()


def random_scene(source: random.Random) -> bytes:
    if source.random() < 0.5:
        return structured(source)
    if source.random() < 0.5:
        return "\n".join(source.choice(LINES) for _ in range(source.randint(1, 14))).encode()
    data = bytearray(source.choice((NEEDLE, BAD)).encode())
    for _ in range(source.randint(1, 8)):
        place = source.randrange(len(data))
        data[place : place + source.randint(0, 3)] = bytes(source.randrange(256) for _ in range(source.randint(0, 3)))
    return bytes(data)
