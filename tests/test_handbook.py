"""The handbook: complete, deterministic, true to scale, and it compiles without a remark from TeX."""

from __future__ import annotations

import copy
import re
from pathlib import Path
from typing import Any

import mpmath as mp
import pytest
from stored_book import on_pages, printed, stored

from axiderive.book.back import WORKS, label
from axiderive.book.evidence import coverage
from axiderive.book.handbook import handbook_sources
from axiderive.book.page import spaced
from axiderive.build import pdf
from axiderive.figures.sketch import DEEPEST, RADIUS, sketch
from axiderive.figures.values import Numbers, sketch_values
from axiderive.physics.medium import GRADED, HOMOGENEOUS
from axiderive.physics.normal import derive
from axiderive.physics.systems import problems
from axiderive.print.words import prose
from axiderive.profiles import NAMES, load
from axiderive.rows.laws import universal_rows

SAMPLE = ("cone", "rounded_punch", "capped_cylinder", "plane.wedge", "loads.power", "materials")
"""Profiles that bring every kind of row, one of them in complete contact."""
BOOK = Path(__file__).parents[1] / "catalogue" / "handbook"
PARTIAL, LEFT_OUT = "flat_punch", "flat_punch.adh"
"""A profile composed anew, with a problem that counts as one whose check failed."""


def page(name: str) -> str:
    """The committed page of a profile, which `build --check` holds equal to what the engine writes."""
    return (BOOK / f"profiles/{name}.tex").read_text(encoding="utf-8")


def keys(name: str) -> list[str]:
    """The problems that are printed on a page."""
    return [problem.key for problem in problems([name]) if problem.system.physics.printed]


@pytest.fixture(scope="module")
def small() -> dict[str, str]:
    """A book of one profile, with formulas left out and little evidence."""
    derived = {key: stored(key) for key in keys(PARTIAL) if key != LEFT_OUT}
    return handbook_sources(derived, {PARTIAL: EVIDENCE})


@pytest.fixture(scope="module")
def partial(small: dict[str, str]) -> str:
    """Its page."""
    return small[f"profiles/{PARTIAL}.tex"]


EVIDENCE: dict[str, Any] = {
    "settings": {"digits": 50, "points": 24, "seed": 17},
    "entries": {
        "p": {
            "status": "closed",
            "certified": True,
            "certificate": {"proved": True, "steps": [], "reason": ""},
            "checks": [
                {
                    "compared": "mpmath quadrature of the defining integral",
                    "outcome": "passed",
                    "digits": 50,
                    "count": 24,
                    "worst": "2.7e-51",
                },
                {"compared": "F = 2 pi int p r dr", "outcome": "failed", "digits": 3, "count": 24, "worst": "1e-3"},
            ],
        },
        "w": {
            "status": "closed",
            "certified": False,
            "certificate": {"proved": False, "reason": "no rule for C0"},
            "checks": [],
        },
    },
}


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("tan(theta) << 1; a << size of the body", r"$\tan \theta \ll 1$; $a \ll$ size of the body"),
        ("F ~ d^(1 + 1/n)", r"$F_{\mathrm N} \sim d^{1+1/n}$"),
        ("A paraboloid of radius R1", r"A paraboloid of radius $R_1$"),
        ("a worn sphere of radius b", "a worn sphere of radius $b$"),
        ("keeps g' >= 0 for every a", r"keeps $g' \ge 0$ for every $a$"),
        ("b = R sin(theta)", r"$b=R \sin \theta$"),
        ("needs the force F_min.", r"needs the force $F_{\mathrm{min}}$."),
        ("Popov, Heß & Willert 2019", r"Popov, Heß \& Willert 2019"),
        ("beyond abs(e) = a/2 one edge", r"beyond $\lvert e\rvert=a/2$ one edge"),
        ("100 % of A_1 ... A_N", r"100 \% of $A_{1} \dots A_{N}$"),
        ("Cone, paraboloid and quartic are n = 1, 2, 4.", "Cone, paraboloid and quartic are $n=1$, 2, 4."),
    ],
)
def test_prose(text: str, wanted: str) -> None:
    assert prose(text) == wanted


@pytest.mark.parametrize("name", NAMES)
def test_no_special_character_of_a_profile_reaches_tex(name: str) -> None:
    profile = load(name)
    for text in (profile.title, profile.subtitle, profile.validity, profile.note, *profile.synonyms, *profile.sources):
        outside = re.sub(r"\$[^$]*\$", "", prose(text))
        assert not re.search(r"(?<!\\)[&%#_^]|<<|>=|<=", outside), outside


def test_every_source_has_its_reference() -> None:
    cited = {work for problem in problems() for work in problem.profile.sources}
    assert cited <= set(WORKS)
    assert len({label(work) for work in WORKS}) == len(WORKS)


@pytest.mark.parametrize(
    ("value", "wanted"),
    [
        ("2.9932228461262", r"2.993\,222\,846\,126"),
        ("0.0000000000005", r"0.000\,000\,000\,000"),
        ("-1.5", r"-1.500\,000\,000\,000"),
    ],
)
def test_check_values_are_rounded_to_nearest(value: str, wanted: str) -> None:
    with mp.workdps(30):
        assert spaced(mp.mpf(value)) == wanted


@pytest.mark.parametrize("name", SAMPLE)
def test_every_key_is_printed_once_and_every_reference_has_a_target(name: str) -> None:
    text = page(name)
    wanted = {entry.key for key in keys(name) for entry in on_pages(stored(key))}
    places = re.findall(r"\\(?:tolab\{|f(?:row|pair).*\{)([\w.]+)\}\}?$|\\tolab\{([\w.]+)\}", text, flags=re.M)
    targets = {f"{name}.{suffix}" for pair in places for suffix in pair if suffix}
    targets |= {f"{name}.{left}" for left in re.findall(r"\{([\w.]+)\}\}\{[\[{]", text)}
    assert wanted <= targets, wanted - targets
    assert {f"{name}.{suffix}" for suffix in re.findall(r"\\own\{([\w.]+)\}", text)} <= wanted


@pytest.mark.parametrize("name", SAMPLE)
def test_what_is_compiled_is_what_was_read_back(name: str) -> None:
    """The rows that `worst_residual` evaluates stand in the source, letter by letter."""
    text = page(name)
    for one in (one for key in keys(name) for one in printed(key)):
        for region in () if one.listed else one.regions:
            assert f"{{{region.tex}" in text, one.key
            assert not region.condition or f"${region.condition}$" in text


def test_rows_without_a_key_are_those_that_are_read_back(partial: str) -> None:
    """What follows from other rows is set by macros of its own, and is the text that its tests read."""
    rows = [
        one.tex
        for key, base, medium in (("cone.adh", "cone", HOMOGENEOUS), ("cone.fgm.adh", "cone.fgm", GRADED))
        for one in universal_rows(key, stored(base)["d"], medium)
    ]
    told = [line for line in page("cone").splitlines() if line.startswith(r"\further{Universal")]
    assert told == [rf"\further{{Universal curve}}{{}}{{{text}}}" for text in rows]
    assert r"\further{Limit}" not in partial  # none is recorded as checked here


def test_a_problem_that_is_missing_is_said_to_be_missing(partial: str) -> None:
    assert "left out of this edition" in partial
    assert "knows no partial slip" in page("capped_cylinder")
    assert "left out" not in page("cone")


def test_the_line_on_the_evidence_claims_what_is_recorded(partial: str) -> None:
    """Two formulas of a profile are recorded here, and nothing is said of the others."""
    assert "Evidence:" not in partial
    assert "Evidence:" in page(PARTIAL)
    assert coverage(list(EVIDENCE["entries"].values()))["least"] == 0  # w agreed with nothing
    agreed = copy.deepcopy(EVIDENCE)
    agreed["entries"]["w"]["checks"] = [
        {"outcome": "passed", "digits": 31, "worst": ""},
        {"outcome": "failed", "digits": 2},
    ]
    found = coverage(list(agreed["entries"].values()))
    assert [found[name] for name in ("formulas", "certified", "least", "root", "integral")] == [2, 1, 31, 0, 0]


@pytest.mark.parametrize("name", ["cone", "rounded_punch", "concave_paraboloid", "sphere_tipped_cone", "flat_punch"])
def test_the_sketch_is_the_solution(name: str) -> None:
    """The drawn surface leaves the drawn indenter at the edge of contact: w(a) = d - f(a)."""
    profile = load(name)
    numbers = Numbers(profile, derive(profile), sketch_values(profile))
    picture = sketch(profile, numbers, "P", "r")
    contact, surface = picture.of("contact"), picture.of("surface")
    scale = contact[-1][0] / float(numbers["a"])
    assert scale == pytest.approx(min(RADIUS / float(numbers["a"]), DEEPEST / float(numbers.depth)))
    # the displacement leaves the edge like a square root where the edge is sharp
    assert surface[0][1] == pytest.approx(contact[-1][1], abs=2e-3)
    assert contact[len(contact) // 2] == pytest.approx((0.0, -scale * float(numbers.depth)), abs=1e-12)
    heights = [y for _, y in surface]
    assert heights == sorted(heights)


needs_latex = pytest.mark.skipif(not pdf.has_latex(), reason="needs pdflatex with the packages of the book")


@pytest.mark.slow
@needs_latex
def test_the_whole_book_compiles_without_a_remark() -> None:
    _, remarks = pdf.compile_pdf({p.relative_to(BOOK).as_posix(): p.read_bytes() for p in sorted(BOOK.rglob("*.tex"))})
    assert remarks == []


@pytest.mark.slow
@needs_latex
def test_a_book_has_the_same_bytes_in_two_folders(
    small: dict[str, str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    found = set()
    for folder in (tmp_path, tmp_path / "a folder further down" / "ü"):
        folder.mkdir(exist_ok=True, parents=True)
        monkeypatch.setattr(pdf.tempfile, "tempdir", str(folder))
        found.add(pdf.compile_pdf({path: text.encode() for path, text in small.items()})[0])
    assert len(found) == 1
