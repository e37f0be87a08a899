"""The ramp factors with a Kummer function in print as the generated code sums them."""

from __future__ import annotations

import re

import sympy as sp

from ..abel.masters import Kummer
from ..contact.viscoelastic import Law
from ..notation import time
from .evaluated import Rows
from .physics import RUNTIME
from .printer import Printer

FADING = sp.Symbol("z_fading", positive=True)
"""Printed last, as it is a sum or an integral."""
SERIES = r"\mathrm{e}^{-x}\sum_{j=0}^{\infty} \frac{m x^{j}}{(m+j) j!}"
INTEGRAL = r"\int_{0}^{1} m (1-y)^{m-1} \mathrm{e}^{-x y}\,\mathrm{d}y"


def switch() -> sp.Rational:
    """The age over the relaxation time at which the series gives way, from the module itself.

    The code takes the integral up to that number over x alone: what is left out there is 4e-18 of it.
    """
    text = (RUNTIME / "_relaxation.py").read_text(encoding="utf-8")
    (found,) = re.findall(r"^SWITCH, TERMS = ([\d.]+), \d+$", text, re.MULTILINE)
    return sp.Rational(found)


def ramp_rows(law: Law) -> Rows:
    """Early and late, of a law whose ramp holds 1F1(1; m + 1; -x)."""
    kummer = law.ramp.atoms(Kummer)
    if not kummer:
        return []
    (fading,) = kummer
    x = Printer()(-fading.args[-1])
    border = f"{Printer()(switch())} {Printer()(1 / sp.diff(-fading.args[-1], time))}"
    rows = []
    for sign, text in ((r"\le", SERIES), (r"\ge", INTEGRAL)):
        value = Printer(names={FADING: text})(law.ramp.subs(fading, FADING))
        rows.append(
            {
                "half": False, "comment": f"evaluation vis.ramp_{law.suffix}", "label": "Evaluated as",
                "small": f"$t{sign} {border}$", "tex": rf"\Phi_{{m}}(t)={value},\qquad x={x}", "remark": "",
            }
        )  # fmt: skip
    return rows
