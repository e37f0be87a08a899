"""What a reader is told before the first formula: how to read an entry, conventions, and when a formula holds.

One text for the book and the web edition, `texts/guide.txt`, in the LaTeX that both can set. Every number in it is
computed from what it says, so that none is typed.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from functools import cache
from types import MappingProxyType
from typing import Any

import mpmath as mp

from ..print.words import escaped
from ..rows import layer
from .back import label
from .texts import sections

BERKOVICH = 24.5
"""Projected area of a Berkovich or a Vickers pyramid over the square of its depth."""
CUBE_CORNER = 1.5 * 3**0.5


def half_angle(area: float) -> float:
    """Half-angle in degrees of the cone that has this area over the square of its depth."""
    return float(mp.degrees(mp.atan(mp.sqrt(area / mp.pi))))


def slope(angle: float) -> float:
    """Slope of the flank of a cone of this half-angle in degrees."""
    return float(mp.cot(mp.radians(angle)))


def slope_factor(angle: float, nu: float) -> float:
    """Stiffness of a cone of this half-angle over that of small slopes (Hay, Bolshakov and Pharr 1999)."""
    steep = mp.cot(mp.radians(angle)) * (1 - 2 * nu) / (4 * (1 - nu))
    return float(mp.pi * (mp.pi / 4 + 0.15483073 * steep) / (mp.pi / 2 - 0.83119312 * steep) ** 2)


@cache
def sphere_over_paraboloid(ratio: float) -> float:
    """Force of a sphere over that of its paraboloid at the contact radius `ratio` times R, from the integrals."""
    return float(_force(lambda x: x / mp.sqrt(1 - x * x), ratio) / _force(lambda x: x, ratio))


def _force(slope: Any, a: float) -> Any:
    """F/E* = 2 (a g(a) - int_0^a g dt) with g(t) = t int_0^t f'(r)/sqrt(t^2 - r^2) dr."""

    def depth(t: Any) -> Any:
        return t * mp.quad(lambda angle: slope(t * mp.sin(angle)), [0, mp.pi / 2])

    return 2 * (a * depth(mp.mpf(a)) - mp.quad(depth, [0, a]))


def first_yield(nu: float) -> tuple[float, float]:
    """Greatest shear stress on the axis of Hertz's contact over p_0, and its depth over the contact radius."""

    def shear(z: Any) -> Any:
        along = -1 / (1 + z * z)
        across = -(1 + nu) * (1 - z * mp.acot(z)) + 1 / (2 * (1 + z * z))
        return (across - along) / 2

    depth = mp.findroot(lambda z: mp.diff(shear, z), 0.5)
    return float(shear(depth)), float(depth)


def without_slip(nu: float) -> float:
    """Stiffness of a flat punch that sticks over that of one without friction (Spence 1968)."""
    return float((1 - nu) * mp.log(3 - 4 * nu) / (1 - 2 * nu))


def retraction_at_pull_off() -> float:
    """Retraction over Tabor's number times the range of adhesion, for the paraboloid under given force."""
    return float(mp.sqrt(2 * mp.pi) * (9 * mp.pi / 8) ** (mp.mpf(1) / 6))


Paragraph = tuple[str, str]
"""Its first words, in bold, and the rest."""
TEXTS = sections("guide")
"""With `@name:format@` in the place of a number, and a work behind \\work."""


def reading() -> list[Paragraph]:
    """How to find an entry and read it."""
    return _paragraphs("reading")


def conventions() -> list[Paragraph]:
    """What the letters stand for where books differ."""
    berkovich, corner = half_angle(BERKOVICH), half_angle(CUBE_CORNER)
    numbers = {"berkovich": berkovich, "inclination": 90 - berkovich, "corner": corner}
    return _paragraphs("conventions", numbers)


def validity() -> list[Paragraph]:
    """When a formula holds, and how wrong it is where it nearly does."""
    factors = {
        "cone": slope_factor(70.3, 0.3),
        **{name: sphere_over_paraboloid(ratio) for name, ratio in (("small", 0.1), ("large", 0.3))},
        **{name: layer.factor(0.1, nu) for name, nu in (("soft", 0.5), ("stiff", 0.3))},
        **{name: without_slip(nu) for name, nu in (("stuck", 0.3), ("sticky", 0.0))},
    }
    shear, depth = first_yield(0.3)
    numbers = {name: 100 * (factor - 1) for name, factor in factors.items()}
    numbers |= {"shear": shear, "depth": depth, "yield": 1 / (2 * shear), "pulled": retraction_at_pull_off()}
    return _paragraphs("validity", numbers)


def _paragraphs(part: str, numbers: Mapping[str, float] = MappingProxyType({})) -> list[Paragraph]:
    """The paragraphs of a part of the guide with its numbers put in, and the works as links to their references."""
    text = _NUMBER.sub(
        lambda match: format(numbers[match[1]], match[2]), _WORK.sub(lambda match: linked(match[1]), TEXTS[part])
    )
    found = (" ".join(paragraph.split()).removeprefix("**").partition("** ") for paragraph in text.split("\n\n"))
    return [(first, rest) for first, _, rest in found]


_NUMBER = re.compile(r"@(\w+):([.\w]+)@")
_WORK = re.compile(r"\\work\{([^}]*)\}")


def linked(work: str) -> str:
    """A work as a link to its reference."""
    return rf"\hyperref[{label(work)}]{{{escaped(work)}}}"


TIPS = (
    ("Berkovich, Vickers", half_angle(BERKOVICH)),
    ("cube corner", half_angle(CUBE_CORNER)),
    ("sphero-conical, 60°", 30.0),
    ("sphero-conical, 90°", 45.0),
    ("Rockwell C, 120°", 60.0),
)
"""Cones of the same area, or tips with their full angle, and half-angles in degrees."""


def tips() -> list[tuple[str, str, str, str]]:
    """Half-angle, inclination and slope of usual tips."""
    return [(name, f"{half:.1f}", f"{90 - half:.1f}", f"{slope(half):.3f}") for name, half in TIPS]


MODULI = (
    (r"rigid indenter, $E$ and $\nu$", r"E/(1-\nu^2)"),
    ("two bodies of one material", r"E/(2-2\nu^2)"),
    ("rigid indenter, incompressible", r"\tfrac43 E"),
    ("rigid indenter, shear modulus $G$", r"2G/(1-\nu)"),
)
"""What is known of the bodies, and the contact modulus."""


def errors() -> list[tuple[str, str, tuple[str, ...], list[tuple[str, list[str]]]]]:
    """By how many per cent the force exceeds that of the formula: title, abscissa, its values, shares by case."""
    angles, ratios, layers = (80.0, 75.0, 70.3, 65.0), (0.1, 0.2, 0.3, 0.5), (0.01, 0.02, 0.05, 0.1)
    return [
        ("Cone, slope not small", "half-angle", tuple(f"{x:g}°" for x in angles), [
            (rf"$\nu={nu}$", _shares(slope_factor(x, nu) for x in angles)) for nu in (0, 0.3)
        ]),
        ("Sphere taken for a paraboloid", "$a/R$", tuple(f"{x:g}" for x in ratios), [
            ("at the same $a$", _shares(map(sphere_over_paraboloid, ratios)))
        ]),
        ("Paraboloid on a bonded layer", r"$\sqrt{R\,d}$ over the thickness", tuple(f"{x:g}" for x in layers), [
            (rf"$\nu={nu}$", _shares(layer.factor(x, nu) for x in layers)) for nu in (0.3, 0.5)
        ]),
    ]  # fmt: skip


def _shares(factors: Iterable[float]) -> list[str]:
    return [f"{share:.1f}" if share < 9.95 else f"{share:.0f}" for share in (100 * (factor - 1) for factor in factors)]


TITLE = "Elastic contact: closed forms of axisymmetric and plane indentation"


def cited(version: str, edition: str, key: str = "cone.p") -> str:
    """What a formula is cited by behind the title of the book."""
    return f"axicontact {version}, edition {edition}, formula {key}"


def bibtex(version: str, edition: str) -> str:
    """The citation of a formula as BibTeX, with KEY for its key and NAME for the key in LaTeX."""
    return f"""@misc{{axicontact:KEY,
  key = {{axicontact}},
  title = {{{TITLE}}},
  note = {{{cited(version, edition, "NAME")}}}
}}"""
