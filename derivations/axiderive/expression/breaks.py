"""Breaks of an expression: `Max(0, ...)` and `Piecewise` as sums of what begins at a break times its step."""

from __future__ import annotations

import ast
from collections.abc import Callable, Sequence

import sympy as sp

from ..notation import r, theta

FORM = "write breaks as Max(0, r - b) with a parameter b"
PIECES = "write Piecewise((f1, r < b), (f2, True)) with a parameter b"


class BreakError(ValueError):
    """What is wrong with a break, and the node where it is."""

    def __init__(self, message: str, node: ast.AST) -> None:
        self.node = node
        super().__init__(message)


def step(b: sp.Symbol) -> sp.Symbol:
    """0 for r < b, 1 for r > b."""
    return sp.Symbol(f"[r > {b.name}]", nonnegative=True)


def begins_at(height: sp.Expr, parameters: Sequence[sp.Symbol]) -> sp.Symbol | None:
    """The parameter b at which an expression in r changes from below to above 0."""
    slope = sp.diff(height, r).subs(sp.tan(theta), sp.Dummy(positive=True))
    if any(symbol not in (r, *parameters) for symbol in height.free_symbols) or not slope.is_positive:
        return None
    return next((b for b in parameters if height.has(b) and sp.expand(height.subs(r, b)) == 0), None)


def limit(node: ast.expr, parameter: Callable[[ast.Name], sp.Expr]) -> sp.Symbol | None:
    """The b of a condition r < b or r <= b; None for True."""
    match node:
        case ast.Constant(value=True):
            return None
        case ast.Compare(left=ast.Name(id="r"), ops=[ast.Lt() | ast.LtE()], comparators=[ast.Name() as name]):
            found = parameter(name)
            if found.is_Symbol and found != r:
                return found
    message = f"a condition is r < b with a parameter b, and True for the last piece; {PIECES}"
    raise BreakError(message, node)


def joined(pieces: Sequence[tuple[sp.Expr, sp.Symbol | None]], node: ast.AST) -> sp.Expr:
    """The sum of the first piece and of what each further one adds at its break."""
    if len(pieces) < 2 or pieces[-1][1] is not None or any(b is None for _, b in pieces[:-1]):
        message = f"the last piece, and no other, has the condition True; {PIECES}"
        raise BreakError(message, node)
    total, before = pieces[0][0], pieces[0]
    for piece in pieces[1:]:
        added, b = sp.expand(piece[0] - before[0]), before[1]
        jump = sp.expand(added.subs(r, b))
        if any(str(symbol).startswith("[") for symbol in jump.free_symbols):
            message = f"a piece has a break of its own; {PIECES} for each break in turn"
            raise BreakError(message, node)
        if jump != 0:
            message = f"f jumps by {sp.sstr(jump)[:60]} at the break r = {b}; write pieces that agree there"
            raise BreakError(message, node)
        total, before = total + added * step(b), piece
    return total
