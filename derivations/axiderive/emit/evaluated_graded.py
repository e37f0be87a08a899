"""Fields on the graded half space in print as the generated code sums them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from .. import notation as nt
from ..abel.masters import IncompleteBeta
from ..contact.medium import GRADED
from ..entry import Entry
from ..notation import k, r
from .evaluated import Rows
from .order import bracket
from .printer import Printer
from .universal import power_of_depth

GROWN = r"\lambda=\ln\Bigl(1+\frac{a-r}{r}\Bigr)"


def pressure_rows(key: str, plain: Mapping[str, Entry]) -> Rows:
    """The pressure of a power law as an integral over ln(t/r), in place of a Beta function of a negative parameter."""
    order = power_of_depth(plain["d"])
    if order is None or not any(case.expr.has(IncompleteBeta) for case in plain["p"].cases):
        return []
    printer = Printer()
    rate = bracket(printer(order + k - 1)) if (order + k - 1).is_Add else printer(order + k - 1)
    scale = rf"{printer(GRADED.pressure_scale * nt.a**k)} g'(a)"
    ring = rf"\bigl[1-\exp(-2 y)\bigr]^{{{printer.exponent((k - 1) / 2)}}}"
    fall = rf"\exp\bigl[-{rate} (\lambda-y)\bigr]"
    tex = rf"p(r)={scale}\int_{{0}}^{{\lambda}} {ring} {fall}\,\mathrm{{d}}y,\qquad {GROWN}"
    return [
        {
            "half": False, "comment": f"evaluation {key}.p", "label": "Evaluated as", "small": f"${printer(r)}\\le a$",
            "tex": tex, "remark": "",
        }
    ]  # fmt: skip


def outside_row(key: str) -> dict[str, Any]:
    """The displacement beside any contact, from the gap that the half space closes inside it."""
    scale, root = Printer()(GRADED.displacement_scale), r"\sqrt{(r-a) (r+a)}"
    share = r"\frac{g(a)-f(s)}{q^{2}+z^{2}}"
    tex = rf"w(r)={scale} q^{{1-k}}\int_{{0}}^{{a}} {share} z^{{k}}\,\mathrm{{d}}z"
    return {
        "half": False, "comment": f"evaluation {key}.w", "label": "Evaluated as", "small": r"$r\ge a$",
        "tex": rf"{tex},\qquad s=\sqrt{{(a-z) (a+z)}},\quad q={root}", "remark": "",
    }  # fmt: skip
