"""Scenes on the graded half-space: adhesive and tangential contact against the quadrature of their definitions."""

from __future__ import annotations

import json
import math

import pytest
from scenes import NO_PDF, composed_from, exchanged, problems, run_plainly, titles

GRADED = 'profile = "{}"\n[medium]\nkind = "power_law"\n{}\n[physics]\n{} = true\n'
FAST = ("truncated_cone",)
SLOW = ("cone", "power_law", "sphere", "rounded_punch", "capped_paraboloid", "gaussian", "hyperboloid")
PROFILES = [*FAST, *(pytest.param(name, marks=pytest.mark.slow) for name in SLOW)]
WORST = 1e-14
"""Relative; measured 3.5e-15 at worst, of depth_from_force of the sextic."""


@pytest.mark.parametrize("kind", ["adhesive", "tangential"])
@pytest.mark.parametrize("profile", PROFILES)
def test_the_module_agrees_with_the_definition_and_its_test_runs(profile, kind, tmp_path):
    result = composed_from(GRADED.format(profile, "", kind) + NO_PDF)
    evidence = json.loads(result.files["evidence.json"])
    errors = {name: float(error) for name, error in evidence["module against 20-digit quadrature"].items()}
    pulled, slipping = {"pressure", "displacement", "pull_off"}, {"tangential_force", "traction", "stick_radius"}
    own = pulled if kind == "adhesive" else slipping
    assert set(errors) == {"depth", "force", *own}
    assert max(errors.values()) < WORST
    assert "values agree" in run_plainly(result, tmp_path)
    title = f"{kind.capitalize()} contact, graded half-space"
    page = result.files[f"profiles/{profile}.tex"]
    assert titles(page) == ["Power-law graded half-space", title]
    assert page.count(rb"\begin{minipage}") == page.count(rb"\end{minipage}")
    assert b"pageref" not in page + result.files["preamble.tex"]
    prefix = {"adhesive": b"fgm.adh", "tangential": b"fgm.tan"}
    assert prefix[kind] in page
    assert not [other for other in prefix if other != kind and prefix[other] in page]


@pytest.mark.parametrize(
    ("profile", "k"),
    [
        ("rounded_cone", 0.4), pytest.param("cone", -0.3, marks=pytest.mark.slow),
        pytest.param("cone", 0.4, marks=pytest.mark.slow), pytest.param("rounded_cone", -0.3, marks=pytest.mark.slow),
    ],
)  # fmt: skip
def test_radii_under_tension_are_found_again(profile, k):
    """A negative force or depth is a field like any other, down to pull-off; below it there is no contact."""
    source = GRADED.format(profile, f"H = 1e6\nk = {k}", "adhesive").replace("= true", "= { dgamma = 0.05 }")
    frozen = '[parameters]\ntheta = "8 deg"\n' + ("b = 1e-4\n" if profile == "rounded_cone" else "")
    names = '["depth", "force", "radius_from_depth", "radius_from_force", "pull_off"]'
    files = composed_from(f"{source}{frozen}[want]\nquantities = {names}\n" + NO_PDF).files
    space: dict[str, object] = {}
    exec(files["scene.py"].decode(), space)
    for control in ("force", "depth"):
        state = space["pull_off"](control)
        least = getattr(state, control)
        assert space[control](state.radius) == pytest.approx(least, rel=1e-12, abs=0.0)
        a = 1.1 * state.radius
        load = space[control](a)
        assert least < load < 0.0
        assert space[f"radius_from_{control}"](load) == pytest.approx(a, rel=1e-11, abs=0.0)
        assert math.isnan(space[f"radius_from_{control}"](1.001 * least))


@pytest.mark.parametrize(
    ("kind", "right", "wrong"),
    [
        ("adhesive", "- graded_retraction(a, H, k, dgamma)", "+ graded_retraction(a, H, k, dgamma)"),
        ("adhesive", "- tension(r, a, H, k, dgamma)", "- 2.0 * tension(r, a, H, k, dgamma)"),
        ("tangential", "return mu * (2.0 * H / (1.0 + k)) * gain", "return 2.0 * H / (1.0 + k) * gain"),
        ("tangential", "lambda: H / np.pi * gain()", "lambda: H * gain()"),
    ],
)
def test_a_wrong_rule_does_not_pass(kind, right, wrong, monkeypatch):
    exchanged(monkeypatch, f"graded/{kind}/cone.py", right, wrong)
    with pytest.raises(ArithmeticError, match="instead of"):
        composed_from(GRADED.format("cone", "", kind) + NO_PDF)


@pytest.mark.parametrize(
    ("source", "message"),
    [
        (GRADED.format("capped_cylinder", "", "adhesive"), "the nearest is normal = true"),
        (GRADED.format("r**2/sqrt(r**2 + q**2)", "", "normal"), 'the nearest is kind = "homogeneous"'),
        (
            GRADED.format("cone", "", "viscoelastic").replace("= true", '= { model = "maxwell" }'),
            'viscoelastic on a graded half-space is not derived; the nearest is kind = "homogeneous"',
        ),
        (GRADED.format("cone", 'H_x = "3 mm"', "tangential"), "H and H_x are in Pa m^(-k), without a unit"),
        (GRADED.format("cone", "H_x = -1", "tangential"), "H_x = -1 is outside H_x > 0"),
        ('profile = "cone"\n[medium]\nH_x = 1\n', 'H_x belongs to a graded half-space; add kind = "power_law"'),
        (
            GRADED.format("cone", "", "tangential").replace("= true", "= { G_star = 1 }"),
            "unknown key 'G_star' of tangential",
        ),
        (
            GRADED.format("power_law", "k = 0.5", "adhesive") + "[parameters]\nn = 0.2\n",
            "a sharper profile has no pull-off",
        ),
    ],
)
def test_what_is_not_at_hand_is_refused_with_the_nearest(source, message):
    assert message in problems(source)
