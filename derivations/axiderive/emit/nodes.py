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
        "from functools import cache",
        "from typing import Any",
        "",
        "import numpy as np",
        "",
        "# only the lower half, the rule is symmetric;",
        "# the weights of numpy.polynomial.legendre.leggauss are off by 6e-14 at 32 nodes and 1e-11 at 128",
        "_LOWER_HALVES = {",
    ]
    for count in counts:
        lines.append(f"    {count}: [")
        lines += [f"        ({node!r}, {weight!r})," for node, weight in gauss_legendre(count)[: count // 2]]
        lines.append("    ],")
    return "\n".join([*lines, *TAIL])


TAIL = (
    "}",
    "",
    "",
    "@cache",
    "def gauss_legendre(count: int) -> tuple[Any, Any]:",
    '    """Nodes and weights as arrays."""',
    "    nodes, weights = np.array(_LOWER_HALVES[count]).T",
    "    return np.concatenate([nodes, 1.0 - nodes[::-1]]), np.concatenate([weights, weights[::-1]])",
    "",
)
