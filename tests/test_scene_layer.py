"""Scenes of contact with a layer: checked by collocation, which knows no equation of springs."""

from __future__ import annotations

import json

import numpy as np
import pytest
from scenes import NO_PDF, composed_from, exchanged, problems, run_plainly

from axicontact.layer import flat_punch
from axiderive.exits import CommandError
from axiderive.scene.contact import DIGITS

LAYER = """profile = "{}"
[medium]
E_star = "1 MPa"
[physics]
layer = {{ thickness = "2 mm", nu = 0.3{} }}
"""


INVERSES = ("radius_from_depth", "radius_from_force", "force_from_depth", "depth_from_force")
ADHESIVE = ("adhesive_depth", "adhesive_force", "adhesive_pressure")


@pytest.mark.parametrize(
    ("profile", "more", "count"),
    [
        ("flat_punch", (), 3),
        pytest.param(
            "truncated_cone",
            (*INVERSES, "depth_first_order", "force_second_order", *ADHESIVE),
            16,
            marks=pytest.mark.slow,
        ),
        pytest.param("c*r**2 + q*r**3", INVERSES, 8, marks=pytest.mark.slow),
        pytest.param("paraboloid", ("depth_second_order",), 5, marks=pytest.mark.slow),
    ],
)
def test_a_scene_of_a_layer(profile, more, count, tmp_path):
    """Measured 7e-16 at worst, and 3e-14 of an expansion, whose sums over waves end sooner."""
    wanted = [*(["depth"] if more else []), "force", "pressure", *more]
    result = composed_from(LAYER.format(profile, ', base = "frictionless"') + f"[want]\nquantities = {wanted}" + NO_PDF)
    errors = json.loads(result.files["evidence.json"])[f"module against {DIGITS}-digit quadrature"]
    assert max(float(error) for name, error in errors.items() if "order" not in name) < 1e-14
    assert max(map(float, errors.values())) < 1e-13
    assert run_plainly(result, tmp_path) == f"{count} values agree\n"


def test_its_functions_are_those_of_the_package():
    """To the last bit, and with the message where the layer is thin; the base is a constant of the module."""
    source = LAYER.format("flat_punch", ', base = "frictionless"') + '[want]\nquantities = ["force", "pressure"]'
    text, space = composed_from(source + NO_PDF).files["scene.py"].decode(), dict[str, object]()
    assert 'base = "frictionless"  # how the layer lies on what is below it' in text
    exec(text, space)
    r, own = np.linspace(0.0, 1.2e-3, 5), {"E_star": 1e6, "nu": 0.3, "thickness": 0.002, "base": "frictionless"}
    for name, fields in (("pressure", (r, 1e-5)), ("force", (1e-5,))):
        assert np.array_equal(space[name](*fields, a=1e-3), getattr(flat_punch, name)(*fields, a=1e-3, **own))
    with pytest.raises(ValueError, match="thickness = 0.002: a <= 20 thickness is violated; a layer that thin"):
        space["force"](1e-5, a=0.05)


def test_another_base_does_not_pass(monkeypatch):
    right, wrong = (f"return on_layer(a, thickness, nu, {base})" for base in ("base", '"bonded"'))
    exchanged(monkeypatch, "layer/flat_punch.py", right, wrong)
    source = LAYER.format("flat_punch", ', base = "frictionless"') + '[want]\nquantities = ["depth_from_force"]'
    with pytest.raises(ArithmeticError, match="depth_from_force"):
        composed_from(source + NO_PDF)


def test_the_page_has_the_equation_and_its_letters():
    page = (
        composed_from(LAYER.format("flat_punch", "") + '[want]\nquantities = ["force"]' + NO_PDF)
        .files["page.tex"]
        .decode()
    )
    assert r"q(t)=d+\int_{0}^{a} K q(s)" in page
    assert "frictionless base" in page
    assert "$L$ & 1 &" in page


@pytest.mark.parametrize(
    ("source", "message"),
    [
        (
            LAYER.format("cone", ', base = "glued"'),
            "scene.toml:5: base = 'glued' must be 'bonded' or 'frictionless': how the layer lies on what is below it",
        ),
        (LAYER.format("cone", "").replace("2 mm", "0 mm"), "thickness = '0 mm' is outside thickness > 0"),
        (LAYER.format("concave_paraboloid", ""), "has a face that is not flat, which no function on a layer knows"),
        (LAYER.format("cone", "").replace("nu =", "bass ="), "unknown key 'bass' of layer; did you mean 'base'?"),
        (
            LAYER.format("gaussian", "") + '[want]\nquantities = ["depth_second_order"]',
            "unknown quantity 'depth_second_order' of layer",
        ),
        (
            LAYER.format("cone", "") + '[parameters]\ntheta = 0.1\n[want]\nat = { F = "1 N" }',
            "a worked example is not given for contact on a layer; leave at out",
        ),
    ],
)
def test_bad_input_is_named(source, message):
    assert message in problems(source)


def test_a_layer_too_thin_to_be_checked_is_refused():
    thin = LAYER.format("rounded_cone", "").replace("2 mm", "0.1 mm") + '[parameters]\nb = "1 mm"\n'
    with pytest.raises(CommandError, match=r"thickness = 0.0001: .* radii of 5 thickness, and the profile"):
        composed_from(thin + NO_PDF)


@pytest.mark.slow
def test_inverses_of_a_contact_up_to_some_radius_are_refused():
    bounded = LAYER.format("r**2/(2*R) - c*r**4", "") + '[want]\nquantities = ["radius_from_depth"]'
    with pytest.raises(CommandError, match="radius_from_depth: the expression is that of a contact up to some radius"):
        composed_from(bounded + NO_PDF)


def test_other_languages_say_so():
    with pytest.raises(CommandError, match='no program in c .*; write language = "python"'):
        composed_from(LAYER.format("flat_punch", "") + '[output]\nlanguage = "c"\nformats = ["c"]\n')
