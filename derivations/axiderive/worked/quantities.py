"""Quantities in print: digits, a prefix and a unit of the SI."""

from __future__ import annotations

from typing import Any

import mpmath as mp

from .. import notation as nt

PREFIXES = {-12: "p", -9: "n", -6: r"\textmu{}", -3: "m", 0: "", 3: "k", 6: "M", 9: "G"}
DIGITS = 20


def given_text(name: str, text: str, degree: int = 0) -> str:
    """A given value with its unit; that of an amplitude A of r**degree is a power of the metre."""
    notation = nt.describe(name) if nt.known(name) else None
    if notation and notation.unit in ("m", "Pa", "N", "N/m"):
        return stated_text(mp.mpf(text), notation.unit)
    mantissa, _, power = text.partition("e")
    digits = (rf"{mantissa}\times" if mantissa != "1" else "") + f"10^{{{int(power)}}}" if power else mantissa
    return digits + (rf"\,\text{{m}}^{{{1 - degree}}}" if degree > 1 else "")


def stated_text(value: Any, unit: str) -> str:
    """A value that is given, without the zeros that say how far a result was computed: 50 mN."""
    return quantity_text(value, unit, strip=True)


def quantity_text(value: Any, unit: str, strip: bool = False) -> str:
    """Four significant digits with a prefix of the unit."""
    if value == 0:
        return rf"0\,\text{{{unit}}}"
    with mp.workdps(DIGITS):
        value = mp.mpf(mp.nstr(value, 4))
        power = int(mp.floor(mp.log10(abs(value)) / 3 + mp.mpf(10) ** -9)) * 3
        power = max(min(power, 9), -12)
        text = mp.nstr(value / mp.mpf(10) ** power, 4, strip_zeros=strip, min_fixed=-5, max_fixed=7)
    return rf"{text.removesuffix('.0') if strip else text.rstrip('.')}\,\text{{{PREFIXES[power]}{unit}}}"
