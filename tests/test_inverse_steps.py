"""How often an inverse evaluates its forward function: over lengths, angles, gradings and both ends of every domain."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from functools import wraps
from importlib import import_module
from types import ModuleType
from typing import Any

import mpmath as mp
import numpy as np
import pytest

from axicontact._runtime import inverse as roots
from axicontact._runtime.physics import adhesion
from axicontact._runtime.shapes import waves

STEPS = 6
"""All evaluations of a normal contact, those at the break and at the length that sets the scale included."""
BESIDE = 2
"""Evaluations of a graded contact besides those of the iteration: at the break, and at the scale of the start."""
WHOLE = 5
"""Evaluations over a whole array that lies on both sides of a break; with plain parameters the others are of numbers.

Where below the break there is a sphere, two iterations one after the other would need up to nine.
"""
WITH_ADHESION = 10
"""The load at both ends of the branch, at a corner and at the scale; then at most six, measured."""
POINTS = 120
FORWARD = ("_depth", "_depth_at", "_depth_beyond", "_force", "_force_at", "_force_beyond")
EPS = 2.0**-52
MISSED = 1.8
"""4e-16 in units of EPS, over 1 + the change of the value by a unit of the radius."""
NEAR_A_MAXIMUM, NEAR_A_GRADED_MAXIMUM = 2.0, 5.0
"""Of a Gaussian bump, where no radius is told from another; 1.84 and 4.5 measured.

The iterations end where the load is met within 4 and 6 of its roundings, 2 and 3 EPS; on the graded half-space the
value is as rounded an integral itself.
"""
GAUSSIAN_END = 1.5019752682686114
COMPACT_WAVES = 12.391420936291584
Numbers = dict[str, Any]


class Draw:
    """Numbers over decades, half of them close to a bound."""

    def __init__(self, seed: int) -> None:
        self.rng = np.random.default_rng(seed)

    def decades(self, low: float, high: float) -> float:
        return float(10.0 ** self.rng.uniform(low, high))

    def share(self) -> float:
        """In (0, 1), down to 1e-60 and up to 1 - 5e-16."""
        return self.decades(-60, 0) if self.rng.random() < 0.5 else 1.0 - self.decades(-15.2, -0.1)

    def beyond(self) -> float:
        return 1.0 + self.decades(-15.2, 60 if self.rng.random() < 0.3 else 4)

    def around(self) -> float:
        return self.share() if self.rng.random() < 0.5 else self.beyond()

    def angle(self) -> float:
        return self.decades(-6, 0.19) if self.rng.random() < 0.5 else np.pi / 2.0 - self.decades(-6, -0.5)

    def grading(self) -> float:
        near = self.decades(-15.2, -1)
        return [-1.0 + near, -near, near, 1.0 - near, self.rng.uniform(-0.9, 0.9)][self.rng.integers(5)]

    def bodies(self, name: str) -> tuple[Numbers, float]:
        """Parameters of a profile and a contact radius."""
        b, R = self.decades(-3, 3), self.decades(-9, 9)
        match name:
            case "truncated_cone":
                return {"theta": self.angle(), "b": b}, b * self.beyond()
            case "rounded_punch" | "truncated_paraboloid":
                return {"R": R, "b": b}, b * self.beyond()
            case "rounded_cone" | "hyperboloid":
                return {"theta": self.angle(), "b": b}, b * self.around()
            case "sphere":
                return {"R": b}, b * self.share()
            case "ellipsoid":
                return {"h": R, "b": b}, b * self.share()
            case "gaussian":
                return {"h": R, "s": b}, b * GAUSSIAN_END * self.share()
            case "capped_paraboloid":
                return {"R1": R, "R2": R * self.share(), "b": b}, b * self.around()
            case "rounded_curved_punch":
                return {"R1": R, "R2": R * self.decades(-30, 30), "b": b}, b * self.around()
            case "wavy_paraboloid":
                steepness = self.share() if self.rng.random() < 0.5 else 1.0
                return {"R": R, "h": b * (b / R) / COMPACT_WAVES * steepness, "wavelength": b}, b * self.decades(-6, 4)
            case "polynomial":
                return {"A": tuple(self.decades(-9, 9) for _ in range(self.rng.integers(1, 9)))}, self.decades(-6, 6)
            case "sphere_tipped_cone":
                angle = self.angle()
                return {"R": b, "theta": angle}, b * float(np.sin(angle)) * self.around()
        message = f"no points are drawn for {name}"
        raise ValueError(message)


NORMAL = (
    "truncated_cone", "rounded_punch", "truncated_paraboloid", "sphere", "ellipsoid", "hyperboloid", "rounded_cone",
    "sphere_tipped_cone", "capped_paraboloid", "rounded_curved_punch", "gaussian", "wavy_paraboloid", "polynomial",
)  # fmt: skip
GRADED = tuple(name for name in NORMAL if name not in ("wavy_paraboloid", "polynomial"))


def counted(module: ModuleType, monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """Counts the calls of the forward functions of a module, a call within another one not."""
    calls, inside = [0], [False]

    def watched(function: Callable[..., Any]) -> Callable[..., Any]:
        @wraps(function)
        def call(*arguments: Any, **named: Any) -> Any:
            if inside[0]:
                return function(*arguments, **named)
            inside[0] = True
            calls[0] += 1
            try:
                return function(*arguments, **named)
            finally:
                inside[0] = False

        return call

    for name in FORWARD:
        if hasattr(module, name):
            monkeypatch.setattr(module, name, watched(getattr(module, name)))
    monkeypatch.setattr(waves, "_series", watched(waves._series))
    return calls


def arguments(function: Callable[..., Any], known: Numbers) -> list[Any]:
    return [known[name] for name in list(inspect.signature(function).parameters)[1:]]


def missed(forward: Callable[..., Any], a: Any, value: Any, known: Numbers) -> float:
    """What the value at the radius misses, over the rounding of the value and of the radius."""
    below, here, above = (forward(a * (1.0 + i * EPS), *arguments(forward, known)) for i in (-1, 0, 1))
    unit = np.fmax(np.abs(above - here), np.abs(here - below))
    return float((np.abs(here - value) / (EPS * value + unit))[0])


def check(module: ModuleType, name: str, calls: list[int], graded: bool) -> None:
    draw, most, tried = Draw(31), 0, 0
    points = POINTS // 15 if name == "sphere_tipped_cone" else POINTS  # its force is an integral
    for _ in range(points):
        known, radius = draw.bodies(name)
        known |= {"E_star": draw.decades(-3, 3), "H": draw.decades(-3, 3), "k": draw.grading()}
        for quantity in ("depth", "force"):
            forward, inverse = getattr(module, f"_{quantity}"), getattr(module, f"_radius_from_{quantity}")
            with np.errstate(all="ignore"):
                value = forward(np.array([radius]), *arguments(forward, known))
                if not 1e-250 < value[0] < 1e250:
                    continue
                calls[0] = 0
                found = inverse(value, *arguments(inverse, known))
                most, tried = max(most, calls[0]), tried + 1
                bound = (NEAR_A_GRADED_MAXIMUM if graded else NEAR_A_MAXIMUM) if name == "gaussian" else MISSED
                assert missed(forward, found, value, known) <= bound, (quantity, known, radius, float(found[0]))
        assert most <= STEPS + (BESIDE if graded else 0), (known, radius, most)
    assert tried > points


@pytest.mark.parametrize("name", NORMAL)
def test_normal_contact(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    module = import_module(f"axicontact.normal.{name}")
    check(module, name, counted(module, monkeypatch), graded=False)


@pytest.mark.parametrize("name", ["sphere_tipped_cone", "rounded_cone", "capped_paraboloid", "rounded_curved_punch"])
def test_arrays_across_a_break(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    module, draw = import_module(f"axicontact.normal.{name}"), Draw(11)
    calls, sizes = counted(module, monkeypatch), list[int]()
    for part in (name for name in FORWARD if hasattr(module, name)):
        monkeypatch.setattr(module, part, sized(getattr(module, part), calls, sizes))
    several, points = (1, 8) if name == "sphere_tipped_cone" else (12, 50)  # its force is an integral
    for _ in range(several):
        known = draw.bodies(name)[0] | {"E_star": draw.decades(-3, 3)}
        b = known["R"] * np.sin(known["theta"]) if name == "sphere_tipped_cone" else known["b"]
        radii = b * np.array([draw.share() for _ in range(points)] + [draw.beyond() for _ in range(points)])
        for quantity in ("depth", "force"):
            forward, inverse = getattr(module, f"_{quantity}"), getattr(module, f"_radius_from_{quantity}")
            with np.errstate(all="ignore"):
                value = forward(radii, *arguments(forward, known))
                value = value[(value > 1e-250) & (value < 1e250)]
                sizes.clear()
                inverse(value, *arguments(inverse, known))
            whole = sum(size == len(value) for size in sizes)
            assert 0 < whole <= WHOLE, (known, quantity, sizes)


def sized(function: Callable[..., Any], calls: list[int], sizes: list[int]) -> Callable[..., Any]:
    """Notes how many values a counted call gives."""

    @wraps(function)
    def call(*given: Any) -> Any:
        before = calls[0]
        found = function(*given)
        if calls[0] > before:
            sizes.append(np.size(found))
        return found

    return call


@pytest.mark.parametrize("name", GRADED)
def test_graded_contact(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    module = import_module(f"axicontact.graded.normal.{name}")
    check(module, name, counted(module, monkeypatch), graded=True)


@pytest.mark.parametrize("name", ["truncated_cone", "rounded_punch", "sphere", "hyperboloid", "rounded_cone"])
@pytest.mark.parametrize("control", ["depth", "force"])
def test_adhesive_contact(name: str, control: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Within 1e-12 of the radius of pull-off and far from it."""
    module, draw = import_module(f"axicontact.adhesive.{name}"), Draw(7)
    calls, tried = counted(module, monkeypatch), 0
    for over in 2 * (1.0 + 1e-12, 1.0 + 1e-6, 1.001, 1.3, 30.0):
        known, radius = draw.bodies(name)
        known["theta"] = 0.3
        known |= {"E_star": draw.decades(-3, 3)} | ({"b": radius / draw.decades(0.1, 3)} if "b" in known else {})
        known["dgamma"] = known["E_star"] * radius * draw.decades(-6, -1)
        given = {key: known[key] for key in inspect.signature(module.pull_off).parameters if key in known}
        a = over * module.pull_off(control, **given).radius
        value = getattr(module, control)(a, **given)
        if not np.isfinite(value):
            continue
        calls[0], tried = 0, tried + 1
        inverse = getattr(module, f"_radius_from_{control}")
        with np.errstate(all="ignore"):
            found = inverse(np.array([value]), *arguments(inverse, known))
        assert abs(found[0] / a - 1.0) <= 1e-6, (known, a)
        assert calls[0] <= WITH_ADHESION, (known, a)
    assert tried > 4


@pytest.mark.parametrize("largest", [2.0, 50.0, 1e3, 1e6, 1e9])
def test_universal_adhesive_curve(largest: float, monkeypatch: pytest.MonkeyPatch) -> None:
    """((1 + s)**m - 1 - m s)/(m - 1) = e for e from 1e-16, next to pull-off, to 1e60, against 400 digits."""
    steps: list[int] = []

    def counting(curve: Callable[..., Any], *given: Any) -> Any:
        steps.append(0)

        def watched(s: Any) -> Any:
            steps[-1] += 1
            return curve(s)

        return roots.inverse(watched, *given)

    monkeypatch.setattr(adhesion, "inverse", counting)
    rng = np.random.default_rng(3)
    m = largest ** rng.uniform(0.01, 1.0, 60)
    e = 10.0 ** np.concatenate([rng.uniform(-16, -8, 20), rng.uniform(-60, 60, 40)])
    with np.errstate(all="ignore"):
        found = adhesion._growth(e, m)
    assert steps == [max(steps)]
    assert max(steps) <= STEPS
    with mp.workdps(400):
        for power, wanted, got in zip(m, e, found, strict=True):
            s, power = mp.mpf(float(got)), mp.mpf(float(power))  # noqa: PLW2901 - the same numbers, exact
            value = (mp.power(1 + s, power) - 1 - power * s) / (power - 1)
            slope = s * power * (mp.power(1 + s, power - 1) - 1) / (power - 1) / value
            assert abs(value / float(wanted) - 1) <= 4e-16 * (1 + slope), (float(power), wanted)
