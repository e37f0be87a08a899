"""What a quantity says of itself holds together: no table repeats it, so that nothing else would notice."""

from __future__ import annotations

import pytest
import sympy as sp

from axiderive import notation as nt
from axiderive.entry import COMPACT, COMPLETE, FOUR
from axiderive.oracle.evaluate import case_at, evaluate
from axiderive.physics import adhesive, loads, materials, normal, tangential, viscoelastic
from axiderive.physics.plane import PLANE, PLANE_COMPLETE, PLANE_ECCENTRIC
from axiderive.physics.systems import problem
from axiderive.profiles import load
from axiderive.store.records import entry_record, read_entry

TABLES = {
    "compact": COMPACT, "complete": COMPLETE, "adhesive": adhesive.QUANTITIES, "detachment": adhesive.PEELING,
    "tangential": tangential.QUANTITIES, "viscoelastic": viscoelastic.QUANTITIES, "plane": PLANE,
    "plane complete": PLANE_COMPLETE, "plane eccentric": PLANE_ECCENTRIC, "loads": loads.QUANTITIES,
    "materials": materials.QUANTITIES,
}  # fmt: skip


@pytest.mark.parametrize("table", TABLES)
def test_a_quantity_says_what_its_function_gives(table):
    for quantity in TABLES[table].values():
        # the state at pull-off is the result of one function
        assert quantity.summary.endswith(".") != bool(quantity.control), quantity.suffix
        assert quantity.left
        words, small = quantity.heading
        assert words == words.strip()
        assert small == small.strip()


@pytest.mark.parametrize("table", TABLES)
def test_an_inverse_is_given_what_its_curve_gives(table):
    known = TABLES[table]
    for quantity in (q for q in known.values() if q.inverts):
        curve = known[quantity.inverts]
        assert quantity.arguments[0] == curve.symbol
        if table == "complete":
            assert quantity.arguments[0] != curve.arguments[0] == quantity.symbol
        elif quantity.composed:
            outer, inner = (known[suffix] for suffix in quantity.composed)
            assert outer.symbol == quantity.symbol
            assert (inner.inverts, inner.arguments) == (quantity.inverts, quantity.arguments)
        else:
            assert quantity.symbol in curve.arguments


def test_the_four_integrals_come_first():
    assert tuple(COMPACT)[1:5] == FOUR


@pytest.mark.parametrize(
    ("name", "suffix", "radius"),
    [
        ("capped_paraboloid", "d", "0.7"), ("capped_paraboloid", "d", "1.9"),
        ("truncated_paraboloid", "F", "1.001"), ("truncated_paraboloid", "F", "1.9"),
    ],
)  # fmt: skip
def test_a_closed_inverse_gives_the_radius_back(name, suffix, radius):
    """By the case in whose range the value lies: a contact beyond the break, or within; the root of a cubic."""
    entries = normal.derive(load(name))
    forward, own = entries[suffix], entries[f"a{suffix}"]
    values = {symbol: sp.Rational(3 + i, 3) for i, symbol in enumerate(forward.profile.parameters)}
    values |= {nt.b: sp.Integer(1), nt.E_star: sp.Integer(1), nt.a: sp.Rational(radius)}
    value = case_at(forward, values).expr.subs(values)
    values[nt.describe(suffix).symbol] = value
    assert evaluate(case_at(own, values).expr, values, 30) == pytest.approx(float(radius), rel=1e-15)


def test_a_stored_entry_has_the_words_of_its_physics():
    """Records tell quantities by what they compute, and depth and force under adhesion compute as those without it."""
    own = problem("cone.adh")
    for entry in own.derive().values():
        assert read_entry(entry_record(entry), own.profile).quantity is entry.quantity
    plain = problem("cone").derive()["d"].quantity
    assert plain == adhesive.QUANTITIES["d"]
    assert (plain.left, adhesive.QUANTITIES["d"].left) == ("d=g(a)", r"d_{\mathrm{adh}}(a)")
