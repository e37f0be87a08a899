"""Where profiles of one's own touch in one circle, where they end, and the same profile in other words."""

from __future__ import annotations

import pytest
import sympy as sp
from own_profiles import answer_to

from axiderive import notation as nt
from axiderive.expression import ExpressionError, own_profile
from axiderive.expression.answer import answered
from axiderive.expression.validity import examine


def test_far_beyond_its_length_a_profile_is_still_compact():
    """g' of 1 - 1/(1 + r) is positive everywhere: 1.2e-8 at a = 1000, which a rule of few nodes takes for negative."""
    assert answer_to("h*(1 - 1/(1 + r/q))").validity.compact_to is None


@pytest.mark.parametrize(
    ("text", "same"),
    [
        ("Piecewise((0, r <= b), ((r - b)*tan(theta), True))", "Max(0, r - b)*tan(theta)"),
        ("Max(0, (r - b)*tan(theta))", "Max(0, r - b)*tan(theta)"),
        ("Piecewise((r**2/(2*R), r < b), (b**2/(2*R) + (r - b)*b/R, True))", "r**2/(2*R) - Max(0, r - b)**2/(2*R)"),
        ("Max(0, r**2 - b**2)/(2*R)", "Max(0, r - b)*(r + b)/(2*R)"),
        ("h*sin(r/q)**2", "h/2*(1 - cos(2*r/q))"),
    ],
)
def test_the_same_profile_in_other_words(text, same):
    pieces, others = (own_profile(spelled).profile.pieces for spelled in (text, same))
    assert [piece.upper for piece in pieces] == [piece.upper for piece in others]
    for piece, other in zip(pieces, others, strict=True):
        assert sp.expand(piece.expr - other.expr) == 0


@pytest.mark.parametrize(
    ("text", "where"),
    [("r**2/(2*R) - c*r**4", 0.4330127018922193), ("h*(1 - exp(-r**2/q**2))", 1.5019752682)],
    ids=["polynomial", "gaussian"],
)
def test_where_a_profile_stops_being_compact_is_found(text, where):
    """g' = 2 a/R - 32/3 c a**3 vanishes at sqrt(3)/4; the gaussian of the catalogue ends at the same 1.50198 s."""
    found = answer_to(text).validity
    assert found.compact_to == pytest.approx(where, rel=1e-9)
    assert "no longer one circle" in found.sentence


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("r*tan(theta) - Max(0, r - b)*tan(theta)/2", "the slope of f falls by"),
        ("-r**2/(2*R)", "f < 0 already"),
        ("c*r**4 - r**2/(2*R)", "f < 0 already"),
    ],
)
def test_a_profile_that_does_not_touch_with_its_apex_is_refused(text, message):
    own = own_profile(text)
    with nt.extended(own.notation), pytest.raises(ExpressionError, match=message):
        examine(own.profile, dict(own.profile.sketch.values), text)


@pytest.mark.parametrize("expression", ["Max(0, r - b)**n", "Max(0, r - b)**(5/2)", "r**2 + sqrt(Max(0, r - b))"])
def test_broken_and_free_powers_beyond_a_break_are_named(expression):
    own = own_profile(expression)
    with nt.extended(own.notation), pytest.raises(ExpressionError, match=r"-b \+ r.* whole numbers of 1 or more"):
        answered(own)


def test_a_sphere_is_drawn_so_that_it_ends_after_a_break():
    """Its radius is drawn larger than the break; where both are given and it ends before, that is said."""
    own = own_profile("R - sqrt(R**2 - r**2) + c*Max(0, r - b)")
    with nt.extended(own.notation):
        answer = answered(own)
        assert answer.validity.ends == pytest.approx(8.0)
        assert answer.bounded
        with pytest.raises(ExpressionError, match="f ends before or soon after its last break"):
            answered(own, {p: sp.S.One for p in own.profile.parameters})
