"""What stands on the left of a row: the quantity whose value is compared, at the place it is compared at."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from ...contact.systems import BODIES
from ...entry import Entry
from ..naming import system_of
from .printed import name_in_print

NORMAL = {
    "d": "d", "F": "F_N", "p": "p(r)", "w": "w(r)", "k": "dF_N/dd", "pm": "bar p", "ad": "a", "aF": "a", "Fd": "F_N",
    "dF": "d", "rz": "r_0", "dmin": "d_min", "Fmin": "F_min", "rp": "r_max", "pp": "p_max",
}  # fmt: skip
ADHESIVE = {
    "Dl": "Delta ell", "d": "d_adh(a)", "F": "F_adh(a)", "p": "p_adh(r)", "w": "w_adh(r)", "ad": "a", "aF": "a",
    "ac": "a_c", "Fc": "F_c", "dc": "d_c", "am": "a_m", "Fm": "F_m", "dm": "d_m",
}  # fmt: skip
TANGENTIAL = {"F": "F_x", "tau": "tau(r)", "u": "u", "c": "c", "us": "u_s"}
PLANE = {
    "P": "P", "p": "p(x)", "s": "dw/dx", "d": "d", "aP": "a", "xz": "x_0", "Pmin": "P_min", "phi": "varphi",
    "cw": "ell",
}  # fmt: skip
LOADS = {"w": "w(r)"}
VISCOELASTIC = {"step": "F_N(t)", "load": "a", "ramp": "F_N(t)"}
NAMES = {
    "normal": NORMAL, "adhesive": ADHESIVE, "tangential": TANGENTIAL, "plane": PLANE, "loads": LOADS,
    "viscoelastic": VISCOELASTIC,
}  # fmt: skip


def name_of(entry: Entry) -> str:
    """The quantity of an entry as the grammar reads its name, with its argument in brackets: p(r)."""
    system = system_of(entry)
    if system in BODIES.names:
        return name_in_print(entry.quantity.symbol)
    return NAMES[system.rpartition(".")[2]][entry.suffix.partition("_")[0]]


def bound(name: str, value: Any, env: Mapping[str, Any]) -> dict[str, Any]:
    """The names of a point with one of them, or a function at one argument, bound to a value."""
    function, _, argument = name.partition("(")
    if not argument:
        return {**env, name: value}
    return {**env, f"{function}()": _at(name, value, env[argument.rstrip(")")])}


def _at(name: str, value: Any, place: Any) -> Callable[[Any], Any]:
    """A function that is known at one place only."""

    def known(argument: Any) -> Any:
        if argument != place:
            message = f"the row states {name}, and not its value at {argument}"
            raise LookupError(message)
        return value

    return known
