"""Stored text, and the formulas of the tables, as trees."""

from __future__ import annotations

import ast
import re
from collections.abc import Mapping
from fractions import Fraction
from functools import cache
from typing import Any

Tree = Any
"""The name of a symbol, a number, or a tuple of a head and its arguments."""
Chain = tuple[Tree, ...]
"""Lengths in their order."""
INFIX: dict[type, str] = {ast.Add: "Add", ast.Mult: "Mul", ast.Pow: "Pow"}
ASSUMED = {"j": {"integer", "positive"}, "N": {"integer", "positive"},
           **dict.fromkeys(("e", "nu", "nu_1", "nu_2", "C_13", "radius_2"), {"real"})}  # fmt: skip
"""What the text of a symbol says of it; of all others, that they are positive."""

SIGNS = {"=": {0}, ">": {1}, "<": {-1}, ">=": {0, 1}, "<=": {-1, 0}}
"""What a comparison asks of the sign of the difference of its sides."""


class UnknownError(Exception):
    """Nothing is shown."""


def require(shown: object, reason: str, *about: object) -> None:
    """Raises `UnknownError` for what is not shown: the reason has {} where it names what it is about."""
    if not shown:
        raise UnknownError(reason.format(*about))


@cache
def tree(text: str) -> Tree:
    """Stored text, or a formula in Python's notation."""
    return _tree(ast.parse(text, mode="eval").body)


def _tree(node: Any) -> Tree:
    match node:
        case ast.Constant(value=value):
            return value
        case ast.Name(id=name):
            return name
        case ast.Tuple(elts=members):
            return ("Tuple", *map(_tree, members))
        case ast.UnaryOp(operand=inner):
            return ("Mul", -1, _tree(inner))
        case ast.BinOp(left=left, op=ast.Sub(), right=right):
            return ("Add", _tree(left), ("Mul", -1, _tree(right)))
        case ast.BinOp(left=left, op=ast.Div(), right=right):
            return ("Mul", _tree(left), ("Pow", _tree(right), -1))
        case ast.BinOp(left=left, op=op, right=right):
            return (INFIX[type(op)], _tree(left), _tree(right))
        case ast.Call(func=ast.Name(id="Integer"), args=[inner]):
            return int(ast.unparse(inner))
        case ast.Call(func=ast.Name(id="Symbol"), args=[ast.Constant(value=str(name))], keywords=flags) if {
            flag.arg for flag in flags if ast.unparse(flag.value) == "True"
        } == ASSUMED.get(name, {"positive"}):
            return name
        case ast.Call(func=ast.Name(id="Rational"), args=numbers):
            return Fraction("/".join(ast.unparse(number).strip("'") for number in numbers))
        case ast.Call(func=ast.Name(id="Indexed"), args=[base, inner]) if (
            ast.unparse(base) == "IndexedBase(Symbol('A'))" and _tree(inner) == "j"
        ):
            return "A_j"
        case ast.Subscript(value=name, slice=ast.Tuple(elts=arguments)):
            return (f"[{ast.unparse(name)}]", *map(_tree, arguments))
        case ast.Subscript(value=name, slice=argument):
            return (f"[{ast.unparse(name)}]", _tree(argument))
        case ast.Call(
            func=ast.Call(func=ast.Name(id="Function"), args=[ast.Constant(value=str(head))]), args=arguments
        ):
            return (head, *map(_tree, arguments))
        case ast.Call(func=ast.Name(id="elliptic_e"), args=[inner]):
            return ("complete_e", _tree(inner))
        case ast.Call(func=ast.Name(id=head), args=arguments):
            return (head, *map(_tree, arguments))
    message = f"{ast.unparse(node)[:40]} is no formula"
    raise UnknownError(message)


def put(formula: Tree, values: Mapping[str, Tree]) -> Tree:
    """The tree with other trees for some symbols, and for functions trees in their argument x."""
    if isinstance(formula, tuple):
        head, *parts = formula[0], *(put(part, values) for part in formula[1:])
        return put(values[head], {"x": parts[0]}) if head in values else (head, *parts)
    return values.get(formula, formula) if isinstance(formula, str) else formula


def symbols(formula: Tree) -> set[str]:
    """Names of the symbols in a tree, pi apart."""
    if isinstance(formula, tuple):
        return set().union(*map(symbols, formula[1:]))
    return {formula} - {"pi"} if isinstance(formula, str) else set()


def heads(formula: Tree) -> set[str]:
    """Names of the functions in a tree."""
    return set().union({formula[0]}, *map(heads, formula[1:])) if isinstance(formula, tuple) else set()


def summed(formula: Tree) -> Tree:
    """The formula without what stands under a sum."""
    if isinstance(formula, tuple):
        return "A" if formula[0] == "Sum" else (formula[0], *map(summed, formula[1:]))
    return formula


@cache
def definition(text: str) -> Tree:
    """A defining equation in one form, stored or in Python's notation, without what is said of its symbols."""
    return ordered(tree(re.sub(r"(?:Symbol|Function)\('(\w+)'(?:, \w+=True)?\)", r"\1", text)))


def ordered(formula: Tree) -> Tree:
    """Sums and products in one row and order, numbers gathered, roots and quotients as powers."""
    if not isinstance(formula, tuple):
        return formula
    head, *parts = formula[0], *map(ordered, formula[1:])
    match head, parts:
        case "Equality", _:
            return ("Eq", *parts)
        case "sqrt", [inner]:
            return ordered(("Pow", inner, Fraction(1, 2)))
        case "Derivative", [inner, str(name)]:
            return (head, inner, ("Tuple", name, 1))
        case "Pow", [int() | Fraction() as base, int(power)]:
            return Fraction(base) ** power
        case "Pow", [("Pow", base, inner), int(power)]:
            return ordered(("Pow", base, ("Mul", inner, power)))
        case "Pow", [("Mul", *factors), int(power)]:
            return ordered(("Mul", *(("Pow", factor, power) for factor in factors)))
        case (("Add" | "Mul"), _):
            return _gathered(head, parts)
    return (head, *parts)


def _gathered(head: str, parts: list[Tree]) -> Tree:
    number, others = Fraction(head == "Mul"), []
    for part in parts:
        for one in part[1:] if isinstance(part, tuple) and part[0] == head else [part]:
            if not isinstance(one, int | Fraction):
                others.append(one)
            else:
                number = number * one if head == "Mul" else number + one
    if number != (head == "Mul"):
        others.append(number)
    return (head, *sorted(others, key=repr)) if len(others) != 1 else others[0]
