"""Gauss-Legendre nodes and weights as literals: certified by Arb, rounded once to double precision."""

from __future__ import annotations

from collections.abc import Sequence

from flint import arb, ctx, fmpq


def gauss_legendre(count: int) -> list[tuple[float, float]]:
    """Nodes on (0, 1) in ascending order with their weights, for an even count."""
    precision, ctx.prec = ctx.prec, 160
    try:
        pairs = [arb.legendre_p_root(count, k, weight=True) for k in range(count)]
        half = arb(fmpq(1, 2))
        return sorted((float((1 + x) * half), float(weight * half)) for x, weight in pairs)
    finally:
        ctx.prec = precision


def nodes_source(counts: Sequence[int]) -> str:
    """The text of `_nodes.py`."""
    lines = [
        '"""Gauss-Legendre nodes and weights on (0, 1), rounded from certified enclosures."""',
        "",
        "from __future__ import annotations",
        "",
        "import numpy as np",
        "",
        "# the weights of numpy.polynomial.legendre.leggauss are off by 6e-14 at 32 nodes and 1e-11 at 128",
        "NODES = {",
    ]
    for count in counts:
        pairs = gauss_legendre(count)
        lines.append(f"    {count}: (")
        for column in (0, 1):
            lines.append("        np.array(")
            lines.append("            [")
            lines += [f"                {pair[column]!r}," for pair in pairs]
            lines.append("            ]")
            lines.append("        ),")
        lines.append("    ),")
    return "\n".join([*lines, "}", ""])
