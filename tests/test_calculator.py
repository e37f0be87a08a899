"""The calculator of a page as a reader uses it: numbers of the package, units, the address, what is wrong."""

from __future__ import annotations

import json
import math
from typing import Any

import pytest
from chromium import Chromium, needs_browser

from axicontact import materials
from axicontact.adhesive import cone as adhesive_cone
from axicontact.graded.normal import cone as graded_cone
from axicontact.normal import cone, flat_punch
from axicontact.tangential import cone as slipping
from axicontact.viscoelastic import cone as yielding
from axiderive.physics.adhesive import CONTROLS

pytestmark = needs_browser
PHONE = 360


SHOWN = """Object.fromEntries([...document.querySelectorAll("output")].map(
  (one) => [one.parentElement.querySelector(".key").getAttribute("href").slice(1), one.textContent]))"""
UNITS = {"µm": 1e-6, "mm": 1e-3, "nm": 1e-9, "m": 1.0, "mN": 1e-3, "N": 1.0, "kN": 1e3, "µN": 1e-6, "kPa": 1e3}
UNITS |= {"MPa": 1e6, "GPa": 1e9, "Pa": 1.0, "kN/m": 1e3, "MN/m": 1e6, "N/m": 1.0, "nN": 1e-9}


def number(text: str) -> float:
    value, unit = text.split(" at ")[0].split(" ")
    return float(value) * UNITS[unit]


def typed(browser: Chromium, name: str, text: str) -> None:
    """What a reader does to a field, found by the words that a screen reader says."""
    browser.value(f"""(() => {{
      const input = document.querySelector('#calculator input[aria-label^={json.dumps(name)}]');
      input.value = {json.dumps(text)};
      input.dispatchEvent(new Event("input", {{ bubbles: true }}));
    }})()""")


def drawn(browser: Chromium, what: str) -> list[str]:
    """Of each curve what an expression says of `one`, once all are there: they come after the numbers."""
    place = "document.querySelector('.drawn')"
    script = f"""new Promise((given) => {{
      const look = () => {place}.getAttribute("aria-busy") === "false"
        ? given([...{place}.querySelectorAll("figure")].map((one) => {what})) : setTimeout(look, 5);
      look();
    }})"""
    found: list[str] = browser.value(script)
    return found


def faults(browser: Chromium) -> list[str]:
    found: list[str] = browser.value("[...document.querySelectorAll('#calculator em')].map((one) => one.textContent)")
    return [one for one in found if one]


ADDRESS = "cone.html?d=1um&theta=70.3+half&E=3GPa&nu=0.4&mu=0.3"


def test_the_numbers_are_those_of_the_package(opened: tuple[Chromium, str]) -> None:
    """Depth, half-angle, Young's modulus and Poisson's ratio from the address."""
    browser, root = opened
    browser.open(f"{root}/{ADDRESS}")
    found = browser.value(SHOWN)
    angle, modulus = math.radians(90.0 - 70.3), 3e9 / (1.0 - 0.4**2)
    a = cone.radius_from_depth(1e-6, theta=angle)
    assert number(found["ad"]) == pytest.approx(a, rel=1e-4)
    assert number(found["F"]) == pytest.approx(cone.force(a, theta=angle, E_star=modulus), rel=1e-4)
    assert number(found["pm"]) == pytest.approx(cone.mean_pressure(a, theta=angle, E_star=modulus), rel=1e-4)
    assert number(found["p"]) == pytest.approx(cone.pressure(0.5 * a, a, theta=angle, E_star=modulus), rel=1e-4)
    assert number(found["w"]) == pytest.approx(cone.displacement(2.0 * a, a, theta=angle), rel=1e-4)
    F = cone.force(a, theta=angle, E_star=modulus)
    c = slipping.stick_radius(0.15 * F, a, theta=angle, E_star=modulus, mu=0.3)
    assert number(found["tan.c"]) == pytest.approx(c, rel=1e-4)
    shear = materials.effective_shear_modulus(3e9, 0.4, math.inf, 0.3)
    slid = slipping.full_slip_displacement(a, theta=angle, E_star=modulus, G_star=shear, mu=0.3)
    assert number(found["tan.us"]) == pytest.approx(slid, rel=1e-4)
    assert found["w"].endswith(" at r = 3.556 µm")
    assert browser.said() == []
    assert browser.asked() <= {"file", "data"}


def test_a_field_changes_the_numbers_the_curves_and_the_address(opened: tuple[Chromium, str]) -> None:
    browser, root = opened
    browser.open(f"{root}/{ADDRESS}")
    assert browser.value("location.search").startswith("?d=1um&"), "a page that is only read keeps its address"
    first, before = browser.value(SHOWN), drawn(browser, "one.querySelector('polyline').getAttribute('points')")
    assert len(before) == 4  # pressure, displacement, load within a radius, force
    typed(browser, "indentation depth", "2 µm")
    after = browser.value(SHOWN)
    assert number(after["ad"]) == pytest.approx(2.0 * number(first["ad"]), rel=1e-4)
    assert number(after["F"]) == pytest.approx(4.0 * number(first["F"]), rel=1e-4)
    assert "d=2+%C2%B5m" in browser.value("location.search")
    load = drawn(browser, "decodeURIComponent(one.querySelector('a').href)")[-1].splitlines()
    assert load[0].endswith('"d in m","F in N"')
    depth, force = map(float, load[-1].split(","))
    assert force / number(after["F"]) == pytest.approx((depth / 2e-6) ** 2, rel=1e-3)
    typed(browser, "effective (plane-strain) modulus", "1 MPa")
    assert browser.value("document.querySelector('#calculator input[aria-label^=Young]').value") == ""
    assert number(browser.value(SHOWN)["pm"]) == pytest.approx(0.5e6 * math.tan(math.radians(19.7)), rel=1e-4)


def test_any_of_depth_force_and_radius_is_the_given_one(opened: tuple[Chromium, str]) -> None:
    browser, root = opened
    browser.open(f"{root}/{ADDRESS}")
    before = browser.value(SHOWN)
    for name in ("F", "a", "d"):
        browser.value(f"""(() => {{
          const choice = document.querySelector("#calculator select");
          choice.value = {json.dumps(name)};
          choice.dispatchEvent(new Event("change"));
        }})()""")
        found = browser.value(SHOWN)
        assert {key: number(found[key]) for key in ("d", "F", "aF")} == pytest.approx(
            {key: number(before[key]) for key in ("d", "F", "aF")}, rel=2e-4
        )


@pytest.mark.parametrize(
    ("name", "text", "told"),
    [
        ("indentation depth", "1 GPa", "GPa is no unit of d; use m, km, mm, cm, µm, um, nm"),
        ("indentation depth", "deep", "deep is no number; write"),
        ("indentation depth", "-1 um", "-1 um is outside d > 0"),
        ("inclination", "100 deg", "100 deg is outside 0 < theta < pi/2"),
        ("coefficient of friction", "0.3 m", "m is no unit of mu; use no unit"),
    ],
)
def test_what_is_wrong_is_said_beside_the_field(opened: tuple[Chromium, str], name: str, text: str, told: str) -> None:
    browser, root = opened
    browser.open(f"{root}/{ADDRESS}")
    typed(browser, name, text)
    (found,) = faults(browser)
    assert found.startswith(told)
    shown: dict[str, Any] = browser.value(SHOWN)
    assert set(shown.values()) == {""}
    assert drawn(browser, "one.outerHTML") == []


def test_a_fixed_edge_and_a_telephone(opened: tuple[Chromium, str]) -> None:
    browser, root = opened
    browser.open(f"{root}/flat_punch.html?F=1+kN&a=2+mm&E_star=100+GPa", PHONE)
    found = browser.value(SHOWN)
    assert number(found["dF"]) == pytest.approx(flat_punch.depth_from_force(1e3, a=2e-3, E_star=1e11), rel=1e-4)
    assert browser.value("document.documentElement.scrollWidth") <= PHONE
    assert browser.said() == []


def test_an_end_that_belongs_to_its_domain(opened: tuple[Chromium, str]) -> None:
    """A stick zone that has shrunk to nothing is full slip."""
    browser, root = opened
    browser.open(f"{root}/{ADDRESS}")
    typed(browser, "radius of the stick", "0 m")
    assert faults(browser) == []
    found = browser.value(SHOWN)
    assert number(found["tan.F"]) == pytest.approx(0.3 * number(found["F"]), rel=1e-3)


def test_pull_off_and_the_graded_half_space(opened: tuple[Chromium, str]) -> None:
    """Under both controls; on the graded half-space the contact has a radius of its own."""
    browser, root = opened
    browser.open(f"{root}/cone.html?F=20+mN&theta=20+deg&E_star=1+MPa&dgamma=0.05&H=1e6&k=0.2")
    found, theta = browser.value(SHOWN), math.radians(20.0)
    for control, (a, F, d) in CONTROLS.items():
        state = adhesive_cone.pull_off(control, theta=theta, E_star=1e6, dgamma=0.05)
        assert number(found[f"adh.{a}"]) == pytest.approx(state.radius, rel=1e-4)
        assert number(found[f"adh.{F}"]) == pytest.approx(state.force, rel=1e-4)
        assert number(found[f"adh.{d}"]) == pytest.approx(state.depth, rel=1e-4)
    a = graded_cone.radius_from_force(0.02, theta=theta, H=1e6, k=0.2)
    assert number(found["fgm.aF"]) == pytest.approx(a, rel=1e-4)
    assert number(found["fgm.d"]) == pytest.approx(graded_cone.depth(a, theta=theta, k=0.2), rel=1e-4)
    assert number(found["fgm.pm"]) == pytest.approx(graded_cone.mean_pressure(a, theta=theta, H=1e6, k=0.2), rel=1e-4)
    assert number(found["F"]) == pytest.approx(0.02)
    assert browser.said() == []


def test_material_laws(opened: tuple[Chromium, str]) -> None:
    """Their modulus is not that of the elastic body, which has its letter."""
    browser, root = opened
    solid = "E_inf=1+MPa&E_1=2+MPa&tau=500+ms"
    browser.open(f"{root}/cone.html?d=10+um&theta=20+deg&E=5+MPa&nu=0.4&E_law=3+MPa&{solid}&t=700+ms&v=20+um/s")
    found, theta = browser.value(SHOWN), math.radians(20.0)
    law = {"theta": theta, "E_inf": 1e6, "E_1": 2e6, "tau": 0.5}
    wanted = yielding.step_force_standard_solid(0.7, d=1e-5, **law)
    assert number(found["vis.step_sls"]) == pytest.approx(wanted, rel=1e-4)
    assert number(found["vis.ramp_sls"]) == pytest.approx(
        yielding.ramp_force_standard_solid(0.7, v=2e-5, **law), rel=1e-4
    )
    wanted = yielding.step_force_maxwell(0.7, d=1e-5, theta=theta, E=3e6, tau=0.5)
    assert number(found["vis.step_mx"]) == pytest.approx(wanted, rel=1e-4)
    typed(browser, "relaxation time", "0.5 m")
    assert faults(browser) == ["m is no unit of tau; use s, ms, µs, us, ns"]


def test_what_is_wrong_can_be_read_on_a_telephone(opened: tuple[Chromium, str]) -> None:
    browser, root = opened
    browser.open(f"{root}/{ADDRESS}", PHONE)
    typed(browser, "inclination", "100 deg")
    box = browser.value("""(() => {
      const [fault] = [...document.querySelectorAll('#calculator em')].filter((one) => one.textContent);
      const parts = [fault, fault.parentElement.querySelector('input')];
      const [own, field] = parts.map((one) => one.getBoundingClientRect());
      return { left: own.left, right: own.right, height: own.height, below: own.top - field.top };
    })()""")
    assert box["height"] > 0.0
    assert 0.0 <= box["left"] < box["right"] <= PHONE
    assert 0.0 <= box["below"] < 100.0
    assert browser.value("document.documentElement.scrollWidth") <= PHONE
