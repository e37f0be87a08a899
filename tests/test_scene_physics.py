"""Scenes of every kind of contact on a homogeneous half-space, of profiles of one's own, and worked examples."""

from __future__ import annotations

import ast
import itertools
import json
import math

import pytest
from scenes import NEEDLE, NO_PDF, OUTSIDE, composed_from, exchanged, run_plainly, titles
from selected import few

from axiderive.exits import CommandError


@pytest.mark.parametrize(
    "source",
    [
        'profile = "q*r**2 + c*r**4"\n[parameters]\nq = 3\nc = "2 mm^-3"\n[physics]\nadhesive = { dgamma = 0.1 }\n',
        'profile = "q*r**2 + Max(0, r - b)*tan(theta)"\n[parameters]\nb = 0.002\n[physics]\nadhesive = true\n',
        'profile = "truncated_cone"\n[parameters]\nb = "5 mm"\n[physics]\ntangential = { mu = 0.2 }\n',
        pytest.param(
            'profile = "rounded_punch"\n[parameters]\nR = "2 mm"\nb = "5 mm"\n[physics]\ntangential = { mu = 0.2 }\n',
            marks=pytest.mark.slow,
        ),
        # `test_scene_matrix` composes one in every run
        pytest.param('profile = "concave_paraboloid"\n[medium]\nE_star = "2 GPa"\n', marks=pytest.mark.slow),
        pytest.param(
            'profile = "cone"\n[parameters]\ntheta = "10 deg"\n[medium]\nkind = "power_law"\nH = 1e6\nk = 0.3\n',
            marks=pytest.mark.slow,
        ),
        f'profile = "{OUTSIDE}"\n[parameters]\nh = 1e-3\nq = 0.01\n[physics]\nadhesive = {{ dgamma = 0.1 }}\n',
        pytest.param(
            f'profile = "{OUTSIDE}"\n[parameters]\nh = 1e-3\nq = 0.01\n[physics]\ntangential = true\n',
            marks=pytest.mark.slow,
        ),
        'profile = "r**2/(2*R) + c*r**4"\n[medium]\nkind = "power_law"\nk = 0.3\n',
    ],
    ids=[
        "expression with adhesion",
        "break and free parameters",
        "tangential",
        "tangential of a rounding",
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


@pytest.mark.parametrize(
    "expression", [pytest.param("q*r**n", marks=pytest.mark.slow), "q*r**2 + Max(0, r - b)*tan(theta)"]
)
def test_an_expression_on_a_viscoelastic_half_space(expression, tmp_path):
    """Under a sum the force of the ramp is an integral over springs; measured 7e-15 at worst."""
    result = composed_from(f'profile = "{expression}"\n[physics]\nviscoelastic = {{ model = "power_creep" }}{NO_PDF}')
    errors = json.loads(result.files["evidence.json"])["module against 20-digit quadrature"]
    assert set(errors) == {"ramp_force", "step_force", "step_load_radius"}
    assert max(map(float, errors.values())) < 1e-14
    assert run_plainly(result, tmp_path) == "6 values agree\n"


@pytest.mark.parametrize("profile", ["A*r**(3/2)", pytest.param("power_law", marks=pytest.mark.slow)])
def test_a_power_that_comes_off_at_the_depth_zero(profile, tmp_path):
    """(1 - 2 n/3) g is all rounding at n = 3/2, which is what a free exponent is checked at."""
    request = '[physics]\nadhesive = true\n[want]\nquantities = ["pull_off"]\n'
    result = composed_from(f'profile = "{profile}"\n{request}{NO_PDF}')
    assert ", 0.0)," in result.files["test_scene.py"].decode()
    assert run_plainly(result, tmp_path) == "6 values agree\n"


LAWS = {
    "maxwell": 'E = "2 MPa", tau = "3 s"',
    "kelvin_voigt": 'E = "2 MPa", eta = "4 MPa s"',
    "standard_solid": 'E_inf = "1 MPa", E_1 = "2 MPa", tau = "3 s"',
    "power_creep": 'E = "2 MPa", alpha = 0.25, t_0 = "1 min"',
}
RELAXING = ["ramp_force", "step_force", "step_load_radius", "retract_force", "retract_radius", "earlier_time",
            "contact_time"]  # fmt: skip


@pytest.mark.parametrize(
    ("profile", "law"),
    few(
        itertools.product(("cone", "truncated_cone"), LAWS),
        [("cone", "maxwell"), ("truncated_cone", "kelvin_voigt"), ("cone", "standard_solid"), ("cone", "power_creep")],
        pytest.mark.slow,
    ),
)
def test_viscoelastic_scenes_agree_with_the_convolution(profile, law):
    """The values are convolutions of the elastic quadrature; measured 8e-16 at worst, and 6e-14 over springs."""
    material = f'viscoelastic = {{ model = "{law}", {LAWS[law]} }}'
    result = composed_from(f'profile = "{profile}"\n[physics]\n{material}\n[want]\nquantities = {RELAXING}' + NO_PDF)
    evidence = json.loads(result.files["evidence.json"])
    errors = {name: float(error) for name, error in evidence["module against 20-digit quadrature"].items()}
    assert set(errors) == set(RELAXING)
    summed = {"ramp_force", "retract_force"} if profile == "truncated_cone" else set()
    assert max(error for name, error in errors.items() if name not in summed) < 1e-14
    assert max(errors.values()) < 1e-13
    module = result.files["scene.py"].decode()
    assert "def step_force(t, d" in module
    assert not [other for other in LAWS if f"_{other}(" in module and other != law]
    shown = titles(result.files[f"profiles/{profile}.tex"])
    assert "Viscoelastic half-space" in shown
    assert "Adhesive contact" not in shown
    page = result.files["page.tex"]
    assert page.count(rb"\Phi_{m}(t)=") == page.count(b"E(t)=") == 1


def test_a_wrong_relaxation_does_not_pass(monkeypatch):
    exchanged(monkeypatch, "viscoelastic/cone.py", "ramp_maxwell(t, 2.0", "ramp_maxwell(t, 1.0")
    with pytest.raises(ArithmeticError, match="ramp_force"):
        composed_from('profile = "cone"\n[physics]\nviscoelastic = { model = "maxwell" }' + NO_PDF)


def test_a_hold_that_ends_before_it_begins_is_refused():
    """As the package does: the first pair of times is named."""
    law = '{ model = "maxwell", E = "2 MPa", tau = "3 s" }'
    wanted = ["contact_time", "earlier_time"]
    source = f'profile = "cone"\n[physics]\nviscoelastic = {law}\n[want]\nquantities = {wanted}{NO_PDF}'
    space: dict[str, object] = {}
    exec(composed_from(source).files["scene.py"].decode(), space)
    assert space["contact_time"](0.2, 0.1, 0.8, 0.8) < space["contact_time"](0.2, 0.1, 0.8, 0.9)
    for name, fields in (("contact_time", ()), ("earlier_time", (1.2,))):
        with pytest.raises(
            ValueError, match=r"t_m = 0.8, t_h = 0.5: t_h >= t_m is violated; the depth is held from t_m"
        ):
            space[name](*fields, 0.2, 0.1, 0.8, [0.9, 0.5])


COHESIVE = """profile = "{}"
[medium]
E_star = "1 MPa"
[physics]
cohesive = {{ dgamma = "50 mJ/m^2", sigma_0 = "20 kPa" }}
"""


@pytest.mark.parametrize("profile", ["paraboloid", pytest.param("truncated_cone", marks=pytest.mark.slow)])
def test_a_scene_with_a_cohesive_zone(profile, tmp_path):
    """By the springs under contact and ring, at a zone that is the root of the work by its definition."""
    result = composed_from(COHESIVE.format(profile) + NO_PDF)
    errors = json.loads(result.files["evidence.json"])["module against 20-digit quadrature"]
    assert set(errors) == {"cohesive_radius", "depth", "force", "pressure", "displacement"}
    assert max(map(float, errors.values())) < 1e-14
    assert run_plainly(result, tmp_path) == "6 values agree\n"
    assert "Cohesive zone" in titles(result.files[f"profiles/{profile}.tex"])


SEARCHED = '[want]\nquantities = {}\n[output]\nformats = ["python", "json"]'


@pytest.mark.parametrize(
    ("profile", "count"),
    [
        ("cone", 5),
        *(
            pytest.param(*row, marks=pytest.mark.slow)
            for row in [("paraboloid", 8), ("quartic", 8), ("rounded_cone", 10), ("sphere", 8), ("truncated_cone", 2)]
        ),
    ],
)
def test_where_a_contact_with_a_cohesive_zone_breaks(profile, count, tmp_path):
    """By the least load of the proved formulas, and the loads there by the definitions.

    A cone is held down to a = 0 under control of the depth, and a flat face of half a metre peels up to where the zone
    reaches its edge.
    """
    wanted = '["radius_from_depth", "radius_from_force", "pull_off"]'
    result = composed_from(COHESIVE.format(profile) + SEARCHED.format(wanted))
    errors = json.loads(result.files["evidence.json"])["module against 20-digit quadrature"]
    assert set(errors) >= {"radius_from_depth", "radius_from_force"}
    assert max(map(float, errors.values())) < 1e-11
    assert run_plainly(result, tmp_path) == f"{count} values agree\n"


@pytest.mark.parametrize(
    ("right", "wrong", "found"),
    [
        ("E_star, dgamma, sigma_0, control),\n", "E_star, 1.01 * dgamma, sigma_0, control),\n", "pull_off"),
        ("        F,\n", "        1.01 * F,\n", "radius_from_force"),
        ("        d,\n", "        1.01 * d,\n", "radius_from_depth"),
    ],
)
@pytest.mark.slow
def test_another_state_is_refused(monkeypatch, right, wrong, found):
    with monkeypatch.context() as patch:
        exchanged(patch, "cohesive/cone.py", right, wrong)
        with pytest.raises(ArithmeticError, match=found):
            composed_from(COHESIVE.format("cone") + SEARCHED.format(f'["{found}"]'))


@pytest.mark.parametrize(
    ("right", "wrong", "found"),
    [
        ("a) - sunk(q", "a) - 0.9 * sunk(q", "depth"),
        ("return outer_radius(", "return 0.9 * outer_radius(", "cohesive_radius"),
    ],
)
def test_a_wrong_zone_does_not_pass(monkeypatch, right, wrong, found):
    with monkeypatch.context() as patch:
        exchanged(patch, "cohesive/cone.py", right, wrong)
        with pytest.raises(ArithmeticError, match=found):
            composed_from(COHESIVE.format("cone") + f'[want]\nquantities = ["{found}"]' + NO_PDF)


def test_the_work_of_a_narrow_zone_is_asked_for_at_the_radius_that_is_given():
    """Next to the edge the rounding of the outer radius alone is 6e-10 of the work."""
    source = COHESIVE.format("cone").replace("20 kPa", "20 MPa")
    result = composed_from(source + '[want]\nquantities = ["work_of_separation"]' + NO_PDF)
    errors = json.loads(result.files["evidence.json"])["module against 20-digit quadrature"]
    assert float(errors["work_of_separation"]) < 1e-14


def test_a_zone_beyond_the_profile_is_refused():
    source = COHESIVE.format("gaussian") + '[parameters]\nh = "1 nm"\ns = "1 um"\n[want]\nquantities = ["depth"]'
    with pytest.raises(CommandError, match=r"sigma_0 = 20000: at a = .* beyond the profile; change these values"):
        composed_from(source + NO_PDF)


def test_the_worked_example_is_at_the_force_that_was_asked_for():
    """The state stands in the docstring; every function is tested there; the force found again is the one given."""
    files = composed_from(NEEDLE + NO_PDF).files
    docstring = ast.get_docstring(ast.parse(files["needle_on_gel.py"].decode()))
    assert "at F = 0.05 N it is a = 0.0003205988 m" in docstring
    space: dict[str, object] = {}
    exec(files["needle_on_gel.py"].decode(), space)
    assert space["force"](0.000320598788133061) == pytest.approx(0.05, rel=1e-12, abs=0.0)
    assert files["test_needle_on_gel.py"].decode().count("0.000320598788133061") == 6


@pytest.mark.parametrize("load", ['{ d = "0.1 um" }', '{ F = "-1 N" }'])
def test_a_worked_example_without_a_contact_is_refused(load):
    source = NEEDLE.replace('{ F = "50 mN" }', load).replace('"50 mJ/m^2"', '"5 mJ/m^2"')
    source = source.replace(', "pressure", "displacement", "pull_off"]', "]")
    assert "pull_off" not in source
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
    assert space["radius_from_depth"](space["depth"](0.9 * reach)) == pytest.approx(0.9 * reach, rel=1e-12, abs=0.0)
    assert math.isnan(space["radius_from_depth"](1.01 * space["depth"](reach)))


@pytest.mark.parametrize("profile", ["cone", "c*r**4", OUTSIDE])
def test_only_pages_of_the_catalogue_carry_its_edition(profile):
    preamble = composed_from(f'profile = "{profile}"\n' + NO_PDF).files["preamble.tex"]
    assert (b"edition " in preamble) == (profile == "cone")


def test_a_page_is_written_outside_the_normal_form():
    source = f'profile = "{OUTSIDE}"\n' + NO_PDF
    page = composed_from(source).files["profiles/own_profile.tex"].decode()
    assert r"\int_{0}^{\sqrt{a^{2}-r^{2}}}\frac{g'(t)}{t}" in page
    assert page.count(r"\int") == 5
