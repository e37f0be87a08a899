"""Brackets as tall as what they enclose."""

from __future__ import annotations

import pytest

from axiderive.print.box import AXIS, box, bracket, size_around

MEASURED = {
    r"\frac{a^{2}}{r^{2}}": (15.6, 7.1),
    r"\sqrt{\frac{2 d}{\pi \tan \theta}}+\frac{1}{\tan \theta}": (16.8, 7.5),
    r"\frac{2 \Gamma\bigl(\tfrac{k+2}{2}\bigr) d}{\sqrt{\pi} \Gamma\bigl(\tfrac{k+1}{2}\bigr)}": (17.1, 12.1),
    r"\sqrt{a^{2}-b^{2}}-b": (10.9, 1.5),
    r"\tfrac{k+1}{2}": (9.5, 3.5),
    r"\frac{\sqrt{(a-r) (a+r)}}{b}": (16.3, 7.0),
    r"\sqrt[3]{\frac{3 F_{\mathrm N} R}{4}}": (16.7, 7.7),
    r"\int_{0}^{a} f\,\mathrm{d}t": (13.2, 8.0),
    r"\Bigl(\frac{a}{b}\Bigr)^{2}": (14.1, 7.0),
    r"\frac{(a^{2}-r^{2})^{(k+1)/2}}{R_{1}^{2}}": (16.3, 11.1),
}
"""Height and depth in points at 10 pt, measured with pdfTeX and the fonts of the book."""
HALF = {"big": 6.0, "Big": 9.0, "bigg": 12.0, "Bigg": 15.0}
STICKS_OUT = 4.2
"""Points by which a content is taller than its bracket on the worse side; 4.1 measured of a^2/r^2."""


@pytest.mark.parametrize("tex", MEASURED)
def test_height_is_that_of_tex(tex: str) -> None:
    assert box(tex)[1:] == pytest.approx(MEASURED[tex], abs=2.1)  # 2.0 measured, over a root above a line


@pytest.mark.parametrize("tex", MEASURED)
def test_bracket_is_as_tall_as_its_content(tex: str) -> None:
    above, below = MEASURED[tex]
    half = HALF[size_around(tex)]
    assert max(above - AXIS, below + AXIS) - half < STICKS_OUT
    assert half < max(above - AXIS, below + AXIS) + 3.0


@pytest.mark.parametrize(
    ("tex", "wanted"),
    [
        ("a+b", "(a+b)"),
        (r"\tfrac{n}{2}", r"\bigl(\tfrac{n}{2}\bigr)"),
        (r"\frac{a}{r}", r"\Bigl(\frac{a}{r}\Bigr)"),
        (r"\sqrt{\frac{2 d}{\pi}}+1", r"\biggl(\sqrt{\frac{2 d}{\pi}}+1\biggr)"),
        (r"\frac{a}{\Gamma(n)}", r"\Bigl[\frac{a}{\Gamma(n)}\Bigr]"),
    ],
)
def test_bracket(tex: str, wanted: str) -> None:
    assert bracket(tex) == wanted
