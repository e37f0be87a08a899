"""Fields on the graded half-space in print as the generated code sums them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from .. import notation as nt
from ..abel.masters import IncompleteBeta
from ..contact.medium import GRADED
from ..entry import Entry
from ..notation import k, r
from .evaluated import Rows
from .evaluated_slip import packed
from .height import bracket
from .printer import Printer
from .rows import Region
from .universal import power_of_depth

ROOM = 330.0
"""Points for a formula with integrals, which are wider than their parts."""
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
    integral = rf"p(r)={scale}\int_{{0}}^{{\lambda}} {ring} {fall}\,\mathrm{{d}}y"
    return [_row(f"{key}.p", f"{printer(r)}\\le a", [integral, GROWN])]


def _row(key: str, where: str, parts: list[str]) -> dict[str, Any]:
    return {
        "half": False, "comment": f"evaluation {key}", "label": "Evaluated as", "small": f"${where}$",
        "tex": Region("", tuple(packed(parts, ROOM))).tex, "remark": "",
    }  # fmt: skip
