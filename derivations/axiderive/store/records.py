"""Profiles, entries and their expressions as plain data and back: what the cache, the evidence and `check` hold.

An expression is `{"=": srepr}`, an object `{"@is": class, field: value, ...}`; the catalogue's own profiles and
quantities are referred to by name.  The text of an expression is `srepr` with the arguments in their stored order.  It
is read without `eval`, by a walk over Python's own syntax tree that knows only names on a list; heads are applied
without evaluation, so that the expression returns exactly as it was (`2*(a + b)` would otherwise come back multiplied
out).
"""

from __future__ import annotations

import ast
import dataclasses
from collections.abc import Callable, Mapping
from functools import lru_cache
from typing import Any

import sympy as sp

from ..abel.masters import MASTERS
from ..entry import Case, Entry, Primitive, Quantity
from ..physics.systems import SYSTEMS, of
from ..profiles.loads import Load
from ..profiles.profile import Limit, Piece, Profile, Rule, Sketch

_FUNCTIONS: tuple[str, ...] = (
    "Abs", "Max", "Min", "acos", "acosh", "asin", "asinh", "atan", "atan2", "atanh", "besseli", "besselj", "beta",
    "ceiling", "cos", "cosh", "elliptic_e", "elliptic_f", "elliptic_k", "elliptic_pi", "erf",
    "erfi", "exp", "floor", "gamma", "hyper", "im", "log", "loggamma", "polylog", "sign", "sin", "sinh", "tan", "tanh",
)  # fmt: skip
_UNEVALUATED: tuple[str, ...] = (
    "Add", "Mul", "Pow", "Equality", "Unequality", "StrictLessThan", "LessThan", "StrictGreaterThan", "GreaterThan",
    "And", "Or", "Not",
)  # fmt: skip
_PLAIN: tuple[str, ...] = ("Integral", "Sum", "Product", "Derivative", "Tuple", "Indexed", "IndexedBase")
_CONSTANTS: dict[str, sp.Basic] = {
    "pi": sp.pi, "E": sp.E, "I": sp.I, "oo": sp.oo, "zoo": sp.zoo, "nan": sp.nan, "EulerGamma": sp.EulerGamma,
    "Catalan": sp.Catalan, "GoldenRatio": sp.GoldenRatio, "true": sp.true, "false": sp.false,
}  # fmt: skip


class ReadingError(ValueError):
    """Text that is not one of our expressions."""


def to_text(expr: sp.Basic) -> str:
    """The expression as text; `ReadingError` if `from_text` would not return it."""
    text = str(sp.srepr(expr, order="none"))
    if from_text(text) != expr:
        message = f"{expr} is not what its stored text reads as; add its functions to those it may name"
        raise ReadingError(message)
    return text


# a sixth of the texts of a profile are different ones, and all are read when they are written, proved and printed
@lru_cache(maxsize=16384)
def from_text(text: str) -> Any:
    """The expression that `to_text` wrote."""
    try:
        tree = ast.parse(text, mode="eval").body
    except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
        message = f"not an expression: {text[:60]!r}"
        raise ReadingError(message) from error
    return _read(tree)


def _read(node: ast.expr) -> Any:
    match node:
        case ast.Name(id=name) if name in _CONSTANTS:
            return _CONSTANTS[name]
        case ast.Call(func=ast.Name(id="Symbol"), args=[ast.Constant(value=str(name))], keywords=keywords):
            return sp.Symbol(name, **_flags(keywords))
        case ast.Call(func=ast.Name(id="Integer"), args=[number], keywords=[]):
            return sp.Integer(_integer(number))
        case ast.Call(func=ast.Name(id="Rational"), args=[p, q], keywords=[]):
            return sp.Rational(_integer(p), _integer(q))
        case ast.Call(
            func=ast.Name(id="Float"),
            args=[ast.Constant(value=str(digits))],
            keywords=[ast.keyword(arg="precision", value=ast.Constant(value=int(bits)))],
        ):
            return sp.Float(digits, precision=bits)
        case ast.Call(func=ast.Name(id=name), args=arguments, keywords=[]) if name in _HEADS:
            return _HEADS[name](*map(_read, arguments))
        case ast.Call(
            func=ast.Call(func=ast.Name(id="Function"), args=[ast.Constant(value=str(name))]), args=arguments
        ):
            return sp.Function(name)(*map(_read, arguments))
        case ast.Tuple(elts=elements):
            return sp.Tuple(*map(_read, elements))
    message = f"{ast.unparse(node)[:60]!r} has no place in a stored expression"
    raise ReadingError(message)


def _integer(node: ast.expr) -> int:
    match node:
        case ast.Constant(value=int(number)) if not isinstance(number, bool):
            return number
        case ast.UnaryOp(op=ast.USub(), operand=ast.Constant(value=int(number))):
            return -number
        case ast.Call(func=ast.Name(id="Integer"), args=[inner], keywords=[]):
            return _integer(inner)
    message = f"{ast.unparse(node)[:60]!r} is not an integer"
    raise ReadingError(message)


def _flags(keywords: list[ast.keyword]) -> dict[str, bool]:
    flags: dict[str, bool] = {}
    for keyword in keywords:
        if keyword.arg is None or not isinstance(keyword.value, ast.Constant) or type(keyword.value.value) is not bool:
            message = f"assumption {keyword.arg!r} of a symbol is not True or False"
            raise ReadingError(message)
        flags[keyword.arg] = keyword.value.value
    return flags


def _unevaluated(head: Callable[..., Any]) -> Callable[..., Any]:
    return lambda *arguments: head(*arguments, evaluate=False)


def _piecewise(*branches: sp.Tuple) -> Any:
    return sp.Piecewise(*branches, evaluate=False)


_HEADS: dict[str, Callable[..., Any]] = {
    **{name: _unevaluated(getattr(sp, name)) for name in _FUNCTIONS + _UNEVALUATED},
    **{master.__name__: _unevaluated(master) for master in MASTERS},
    **{name: getattr(sp, name) for name in _PLAIN},
    "Piecewise": _piecewise,
    "ExprCondPair": sp.Tuple,
}


Record = Any
_CLASSES: dict[str, type] = {
    cls.__name__: cls for cls in (Case, Entry, Limit, Load, Piece, Primitive, Profile, Quantity, Rule, Sketch)
}
_KINDS = {name: table for own in SYSTEMS for name, table in own.physics.quantities.items()}
_QUANTITIES = {f"{name}.{q.suffix}": q for name, kind in _KINDS.items() for q in kind.values()}


class RecordError(ValueError):
    """A record that does not describe one of our objects."""


def profile_record(profile: Profile) -> Record:
    """All that a derivation or a verification can depend on."""
    return _encode(profile, {})


def entry_record(entry: Entry) -> Record:
    """The entry as plain data; its own profile is referred to by name."""
    return _encode(entry, {entry.profile.name: entry.profile})


def read_entry(record: Record, profile: Profile) -> Entry:
    """The entry of `profile` that `entry_record` wrote."""
    try:
        entry = _decode(record, {profile.name: profile})
    except (TypeError, KeyError, AttributeError) as error:
        message = f"{profile.name}: a stored entry cannot be read ({error}); run axicontact build --fresh"
        raise RecordError(message) from error
    if not isinstance(entry, Entry):
        message = f"{profile.name}: a stored entry is a {type(entry).__name__}; run axicontact build --fresh"
        raise RecordError(message)
    # stored by the name of the first quantity that computes the same: the depth under adhesion as that without it
    tables = of(entry).physics.quantities.values()
    own = next(table[entry.suffix] for table in tables if table.get(entry.suffix) == entry.quantity)
    return dataclasses.replace(entry, quantity=own)


def _encode(value: Any, profiles: Mapping[str, Profile]) -> Record:
    if value is None or isinstance(value, (str, bool, int, float)):
        return value
    if isinstance(value, sp.Basic):
        return {"=": to_text(value)}
    if isinstance(value, (tuple, list)):
        return [_encode(item, profiles) for item in value]
    if isinstance(value, dict):
        return {"@items": [[_encode(key, profiles), _encode(item, profiles)] for key, item in value.items()]}
    if isinstance(value, Profile) and profiles.get(value.name) == value:
        return {"@profile": value.name}
    if isinstance(value, Quantity):
        return {"@quantity": next(name for name, quantity in _QUANTITIES.items() if quantity == value)}
    if type(value).__name__ in _CLASSES:
        fields = {f.name: _encode(getattr(value, f.name), profiles) for f in dataclasses.fields(value)}
        return {"@is": type(value).__name__, **fields}
    message = f"{type(value).__name__} {value!r} has no record"
    raise RecordError(message)


def _decode(record: Record, profiles: Mapping[str, Profile]) -> Any:
    if isinstance(record, list):
        return tuple(_decode(item, profiles) for item in record)
    if not isinstance(record, dict):
        return record
    if "=" in record:
        return from_text(record["="])
    if "@items" in record:
        return {_decode(key, profiles): _decode(value, profiles) for key, value in record["@items"]}
    if "@profile" in record:
        return profiles[record["@profile"]]
    if "@quantity" in record:
        return _QUANTITIES[record["@quantity"]]
    fields = {name: _decode(value, profiles) for name, value in record.items() if name != "@is"}
    return _CLASSES[record["@is"]](**fields)
