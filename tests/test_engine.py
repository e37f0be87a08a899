"""Reduction to atoms, chains of lengths, and forms."""

from __future__ import annotations

import random

import mpmath as mp
import pytest
import sympy as sp

from axiderive import profiles
from axiderive.abel import reduce
from axiderive.abel.atoms import HyperboloidAtom, PowerAtom, SphereAtom
from axiderive.abel.form import Form, Order, insert
from axiderive.abel.masters import MASTERS
from axiderive.abel.reduce import NotReducibleError, parse
from axiderive.notation import R, a, b, c, r, s, theta
from axiderive.profiles.profile import Piece

SPELLED = [name for name in profiles.COMPACT_NAMES if name != "polynomial"]  # a sum is reduced through its summand


def number(expr: sp.Expr, values: dict[sp.Symbol, mp.mpf]) -> mp.mpf:
    own = {master.__name__: master.numeric for master in MASTERS}
    return mp.mpmathify(sp.lambdify(list(values), expr, [own, "mpmath"])(*values.values()))


@pytest.mark.parametrize("name", SPELLED)
def test_atoms_add_up_to_the_profile(name):
    profile = profiles.load(name)
    reduced, below = parse(profile.pieces), ()
    for i, piece in enumerate(profile.pieces):
        chain = (*below, r) if piece.upper is None else (*below, r, piece.upper)
        height = reduced.shape(Order(chain)) - piece.expr
        values = {symbol: sp.Rational(7 + 3 * j, 10) for j, symbol in enumerate(sorted(height.free_symbols, key=str))}
        values[r] = sp.Rational(2 + i, 10)  # below every radius of curvature and wherever the piece is continued
        assert abs(height.subs(values).evalf(30)) < sp.Float("1e-28")
        below = (*below, piece.upper)


def test_a_jump_is_refused_with_its_height_and_place():
    with pytest.raises(ValueError, match=r"must start at 0 and be continuous, but it jumps by b at r = b"):
        parse([Piece(b, r), Piece(None, 2 * r)])
    with pytest.raises(ValueError, match=r"jumps by s at r = 0"):
        parse([Piece(None, s + r)])


@pytest.mark.parametrize(
    "term", [sp.log(1 + r / s), r**2 / (r + s), sp.sqrt(r**2 + r * s), sp.exp(r / s), sp.sin(r / s)]
)
def test_a_term_without_an_atom_is_named(term):
    with pytest.raises(NotReducibleError, match="no atom is known for it"):
        parse([Piece(None, sp.expand(term - term.subs(r, 0)))])


def test_a_special_tip_must_start_at_zero():
    bump = 1 - sp.exp(-(r**2) / s**2)
    with pytest.raises(NotReducibleError):
        parse([Piece(b, sp.S.Zero), Piece(None, sp.expand(bump - bump.subs(r, b)))])


def test_a_wrong_split_is_noticed(monkeypatch):
    monkeypatch.setattr(reduce, "_atom", lambda term, lower: PowerAtom(sp.Integer(2), sp.Integer(1), lower))
    with pytest.raises(AssertionError, match=r"the atoms add up to 2\*r, not to r"):
        parse([Piece(None, r)])


def test_radicals_are_recognised_in_any_scale():
    (ellipsoid,) = parse([Piece(None, c * (1 - sp.sqrt(1 - r**2 / R**2)))]).atoms
    assert ellipsoid == SphereAtom(c / R, R)
    (hyperboloid,) = parse([Piece(None, sp.tan(theta) * (sp.sqrt(r**2 + b**2) - b))]).atoms
    assert hyperboloid == HyperboloidAtom(sp.tan(theta), b)


def test_a_spherical_tip_ends_where_its_root_does():
    pieces = [Piece(b, R - sp.sqrt(R**2 - r**2)), Piece(None, R - sp.sqrt(R**2 - b**2) + r - b)]
    assert parse(pieces).atoms == (SphereAtom(sp.S.One, R, b), PowerAtom(sp.S.One, sp.S.One, b))


@pytest.mark.parametrize(
    ("inner", "outer"),
    [(sp.S.Zero, r - b), (sp.S.Zero, (r**2 - b**2) / (2 * R)), (r, (r + r**2 / b) / 2), (r**2 / (2 * b), r - b / 2)],
    ids=["truncated cone", "truncated paraboloid", "convex kink", "smooth join"],
)
def test_a_kink_leaves_its_square_root_in_the_slope_of_the_depth(inner, outer):
    """g'(a) sqrt(a^2 - b^2) tends to b times the jump of f' (and to 0 where there is none)."""
    jump = (sp.diff(outer, r) - sp.diff(inner, r)).subs(r, b)
    slope = sp.diff(parse([Piece(b, inner), Piece(None, outer)]).depth(Order((b, a))).expr(), a)
    with mp.workdps(60):
        near = {b: mp.mpf("0.7"), R: mp.mpf("1.9"), a: mp.mpf("0.7") * (1 + mp.mpf("1e-24"))}
        found = number(slope * sp.sqrt(a**2 - b**2), near)
        assert abs(found - number(b * jump, near)) < mp.mpf("1e-11")


def test_order_answers_what_the_chain_decides():
    order = Order((r, b, a))
    assert order.below(r, a)
    assert not order.below(a, b)
    assert order.below(sp.S.Zero, R)
    with pytest.raises(ValueError, match="the order of R and a is not fixed by r < b < a"):
        order.below(R, a)


def test_a_length_is_put_at_every_place():
    assert list(insert((b, R), a)) == [(a, b, R), (b, a, R), (b, R, a)]
    assert list(insert((b, a), r, below=a)) == [(r, b, a), (b, r, a)]
    assert list(insert((b, a), r, above=a)) == [(b, a, r)]
    assert list(insert((), a)) == [(a,)]


def test_forms_add_scale_and_multiply():
    arc, root = sp.acos(b / a), sp.sqrt(a**2 - b**2)
    first, second = Form.of(arc, a) + Form.of(root, b), Form.of(arc, -a) + Form.of(root)
    assert first + second == {arc: 0, root: b + 1}
    assert (first + second).expr() == (b + 1) * root
    assert (first * 3)[arc] == (3 * first)[arc] == 3 * a
    assert first.times(root) == {arc * root: a, root**2: b}
    assert Form.total([]) == {}
    assert Form().expr() == 0


def test_the_text_of_a_form_does_not_depend_on_the_order_of_its_terms():
    terms = [
        (sp.acos(b / a), a**2 / (a + b)),
        (sp.sqrt(a**2 - b**2), b / a),
        (sp.S.One, sp.pi * a),
        (sp.asin(b / r), r),
    ]
    texts = set()
    for seed in range(6):
        random.Random(seed).shuffle(terms)
        texts.add(sp.sstr(Form.total(Form.of(*term) for term in terms).expr()))
    assert len(texts) == 1


def test_a_root_over_its_square_is_one_over_the_root():
    root = sp.sqrt(a**2 - b**2)
    assert Form.of(root, 3 / (a**2 - b**2)).expr() == 3 / root
