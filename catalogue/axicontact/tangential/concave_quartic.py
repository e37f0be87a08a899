"""Concave quartic: no tangential functions.

Concave quartic is a complete contact and knows no partial slip; it slips as a whole at F_x = mu F, with F
from axicontact.normal.concave_quartic.force.
"""

from __future__ import annotations

from typing import Any

__all__: list[str] = []

_REASON = (
    "Concave quartic is a complete contact and knows no partial slip; it slips as a whole at F_x = mu F, with F "
    "from axicontact.normal.concave_quartic.force"
)


def __getattr__(name: str) -> Any:
    if name.startswith("__"):
        raise AttributeError(name)
    message = f"{name} is not defined: {_REASON}"
    raise AttributeError(message)


def __dir__() -> list[str]:
    return __all__
