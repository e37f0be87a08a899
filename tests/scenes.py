"""What the tests of scenes share: the examples, a scene with every kind of mistake, random scenes."""

from __future__ import annotations

import random
import re
import subprocess
import sys
from pathlib import Path

import pytest

from axiderive.scene import reading, text
from axiderive.scene.commands import _request as request_of
from axiderive.scene.compose import Result, composed
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


def run_plainly(result: Result, folder: Path) -> str:
    """Write the files; what the test of the module prints, run by plain Python with nothing else to import from."""
    for name, content in result.files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
    command = [sys.executable, "-W", "error", "test_scene.py"]
    return subprocess.run(command, cwd=folder, env={}, capture_output=True, text=True, check=True).stdout


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
)  # fmt: skip


def random_scene(source: random.Random) -> bytes:
    if source.random() < 0.5:
        return "\n".join(source.choice(LINES) for _ in range(source.randint(1, 14))).encode()
    data = bytearray(source.choice((NEEDLE, BAD)).encode())
    for _ in range(source.randint(1, 8)):
        place = source.randrange(len(data))
        data[place : place + source.randint(0, 3)] = bytes(source.randrange(256) for _ in range(source.randint(0, 3)))
    return bytes(data)
