"""The front and the back of the book: numbers of the guide, the tree, the indexes, the spread of rules."""

from __future__ import annotations

import re
from functools import cache

import mpmath as mp
import pytest
import sympy as sp
from stored_book import HANDBOOK, PROFILES, stored

from axiderive import notation as nt
from axiderive.book import back, book, front, guide, handbook, texts
from axiderive.oracle.evaluate import evaluate
from axiderive.physics.systems import pool_of
from axiderive.profiles import load
from axiderive.rows import layer
from axiderive.rows.special import HOSTS


@cache
def text() -> str:
    return (HANDBOOK / "handbook.tex").read_text(encoding="utf-8")


def test_a_pyramid_has_the_cone_of_its_area() -> None:
    """Berkovich: faces at 65.27 degrees to the axis; a triangle of the height h sees its inscribed circle."""
    inscribed = mp.tan(mp.radians(mp.mpf("65.27")))
    area = 3 * mp.sqrt(3) * inscribed**2
    assert pytest.approx(float(area), rel=2e-3) == guide.BERKOVICH
    assert guide.half_angle(guide.BERKOVICH) == pytest.approx(70.3, abs=0.05)
    assert pytest.approx(3 * 3**0.5 * 0.5, rel=1e-12) == guide.CUBE_CORNER  # faces at 35.26 degrees, tan^2 = 1/2


def test_steep_cones_are_stiffer_unless_the_half_space_is_incompressible() -> None:
    assert guide.slope_factor(70.3, 0.5) == pytest.approx(1.0, abs=1e-12)
    assert guide.slope_factor(89.99, 0.0) == pytest.approx(1.0, abs=1e-3)
    assert 1 < guide.slope_factor(70.3, 0.3) < guide.slope_factor(70.3, 0.0) < guide.slope_factor(60.0, 0.0)


@pytest.mark.parametrize("ratio", [0.1, 0.3])
def test_the_force_of_the_sphere_is_that_of_the_catalogue(ratio: float) -> None:
    values = {nt.R: 1, nt.a: mp.mpf(ratio), nt.E_star: 1}
    forces = [evaluate(stored(name)["F"].cases[0].expr, values, 20) for name in ("sphere", "paraboloid")]
    assert guide.sphere_over_paraboloid(ratio) == pytest.approx(float(forces[0] / forces[1]), rel=1e-12)


@pytest.mark.parametrize(("nu", "lost"), [(0.5, "1.770217"), (0.3, "1.376854"), (0.0, "1.211062")])
def test_a_thick_layer_is_a_half_space_that_has_lost_its_far_part(nu: float, lost: str) -> None:
    """To the first order the factor is 1 + (2/pi) int (1 - L) times the ratio, L from hyperbolic functions."""
    k = 3 - 4 * nu

    def kernel(u: float) -> mp.mpf:
        whole = (2 * k * mp.sinh(2 * u) - 4 * u) / (2 * k * mp.cosh(2 * u) + 4 * u * u + 1 + k * k)
        return 1 - whole

    first = mp.quad(kernel, [0, 1, 4, 20])
    assert float(first) == pytest.approx(float(lost), abs=1e-6)
    assert (layer.factor(1e-6, nu) - 1) / 1e-6 == pytest.approx(2 / mp.pi * first, rel=1e-5)


def test_first_yield_is_where_the_pressure_of_the_catalogue_shears_most() -> None:
    """Stresses on the axis as integrals of the pressure over point loads."""
    expr, nu = stored("paraboloid")["p"].cases[0].expr, mp.mpf("0.3")

    def pressure(r: mp.mpf) -> mp.mpf:
        return evaluate(expr, {nt.r: r, nt.a: 1, nt.R: 1, nt.E_star: 1}, 15)

    def shear(z: mp.mpf) -> mp.mpf:
        def along(r: mp.mpf) -> mp.mpf:
            return -3 * z**3 * pressure(r) * r / mp.sqrt(r * r + z * z) ** 5

        def across(r: mp.mpf) -> mp.mpf:
            far = mp.sqrt(r * r + z * z)
            return pressure(r) * r * ((1 - 2 * nu) * z / far**3 - 3 * r * r * z / far**5) / 2

        with mp.workdps(15):
            return mp.quad(lambda r: across(r) - along(r), [0, 0.5, 1]) / 2

    greatest, depth = guide.first_yield(0.3)
    middle = pressure(mp.mpf(0))
    assert float(shear(mp.mpf(depth)) / middle) == pytest.approx(greatest, rel=1e-8)
    assert max(shear(mp.mpf(depth) * (1 + side)) for side in (-0.02, 0.02)) < shear(mp.mpf(depth))
    assert (f"{greatest:.4f}", f"{depth:.4f}") == ("0.3100", "0.4809")


def test_a_punch_that_sticks_is_stiffer_unless_the_half_space_is_incompressible() -> None:
    assert guide.without_slip(0.49999) == pytest.approx(1.0, abs=1e-4)
    assert guide.without_slip(0.0) == pytest.approx(float(mp.log(3)), rel=1e-12)


def test_every_reference_is_cited_and_every_citation_has_its_reference() -> None:
    labels = {back.label(work): work for work in back.WORKS}
    cited = set(re.findall(r"\\hyperref\[(ref:\w+)\]", text()))
    assert cited <= set(labels)
    of_profiles = {work for name in PROFILES for work in next(iter(stored(name).values())).profile.sources}
    assert {labels[label] for label in cited} | of_profiles == set(back.WORKS)
    assert r"\work" not in text()


def test_a_doi_is_one() -> None:
    for work in back.WORKS.values():
        assert not work.doi or re.fullmatch(r"10\.\d{4,5}/[\w.()/-]+", work.doi), work
        assert not work.place.endswith("."), work
        assert re.search(r"\((18|19|20)\d\d\)", work.place), work


def test_every_entry_has_one_place_in_the_book() -> None:
    placed = [name for names in book.ENTRIES.values() for name in names]
    assert sorted(placed) == sorted(name for name in PROFILES if name not in HOSTS)
    numbers = handbook.numbered(PROFILES)
    assert [numbers[name] for name in ("cone", "plane.wedge", "plane.flat_punch", "materials")] == [
        *("1.1", "1.2", "2.2", "4.1"),
    ]
    assert {name: numbers[name] for name in HOSTS} == {name: numbers[host] for name, host in HOSTS.items()}
    # of some profiles the numbers follow each other too
    assert handbook.numbered(("paraboloid", "plane.wedge", "sphere")) == {
        **{"plane.wedge": "1.1", "paraboloid": "1.2", "sphere": "1.3"},
    }


def test_the_plane_contact_of_a_shape_stands_behind_its_entry() -> None:
    """Its last piece is that of an entry before it in the chapter, with x for r."""
    for names in book.ENTRIES.values():
        for i, name in enumerate(names):
            if pool_of(name).strip and "eccentric" not in name:
                own = pool_of(name).load(name.partition(".")[2])
                shape = own.pieces[-1].expr.subs(pool_of(name).place, nt.r)
                before = [load(other).pieces[-1].expr for other in names[:i] if not pool_of(other).strip]
                assert any(sp.expand(shape - other) == 0 for other in before), name


def test_every_profile_is_an_answer_once() -> None:
    answers = [name for own in texts.sections("chart").values() for name, _ in texts.rows(own)]
    assert sorted(answers) == sorted(name for name in PROFILES if name != "materials")
    known = [{"name": "cone", "number": "1.1", "title": "Cone", "shape": {}}]
    (only,) = front.chart(known)
    assert only["question"] == "Pointed"
    assert [one["name"] for line in only["lines"] for one in line] == ["cone"]


def test_words_lead_to_places_that_there_are() -> None:
    contents = {
        "front": [("", title, f"part:{label}") for title, label in book.FRONT],
        "back": [("", title, f"part:{label}") for title, label in book.BACK],
    }
    summaries = [{"name": name, "keys": [e.key for e in stored(name).values()]} for name in ("cone", "paraboloid")]
    found = dict(back.word_index(summaries, contents, book.WITHIN))
    assert found["Berkovich indenter"] == ["part:conventions", "sec:cone"]
    assert found["run time"] == ["part:study"]
    assert "wedge" not in found
    known = {*PROFILES, *(f"part:{label}" for _, label in (*book.FRONT, *book.BACK)), *book.WITHIN}
    for word, names in back.WORDS.items():
        places = [name for name in names.split() if name not in known]
        assert all(place.rpartition(".")[2] in stored(place.rpartition(".")[0]) for place in places), word
    assert 140 <= len(back.WORDS) <= 200
    assert list(back.WORDS) == sorted(back.WORDS, key=lambda word: word.replace("ß", "ss").lower())


def test_every_place_of_the_book_has_a_label() -> None:
    for label in re.findall(r"\\wordpage\{(part:\w+)\}", text()):
        assert f"\\label{{{label}}}" in text() or f"{{{label[5:]}}}" in text(), label


def test_rules_of_both_half_spaces_stand_one_behind_the_other() -> None:
    left, right = ([one for _, _, lines in page for line in lines for one in line]
                   for page in (front.homogeneous(), front.graded()))  # fmt: skip
    graded = {one.key for one in right}
    both = [one for one in left if one.system in ("adhesive", "tangential")]
    assert {f"fgm.{one.key}" for one in both} <= graded
    assert len({one.key for one in (*left, *right)}) == len(left) + len(right)
    titles = ("parthead{Rules for every profile}", "pagetitle{The same on a graded half-space}")
    places = [text().index(f"\\{title}") for title in (*titles, "parthead{Layer on a rigid base}")]
    assert places == sorted(places)
