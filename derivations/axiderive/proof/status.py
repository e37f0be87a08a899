"""How well an entry, or a whole problem, is known: the words of the matrix profile x physics."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from ..entry import Entry
from .certificate import Certificate
from .evidence import Evidence

NOT_CHECKED = "not checked"


def digits(checks: Iterable[Evidence]) -> int:
    """Digits of the best comparison that passed; 0 without one.  Units and symbolic identities have no digits."""
    return max((check.digits for check in checks if check.passed and check.worst), default=0)


def word(kind: str, proved: bool, reached: int) -> str:
    """From plain data: the status of an entry, whether it is certified, and the digits of its check."""
    if not reached:
        return NOT_CHECKED
    if kind == "integral":
        return f"one integral ({reached} digits)"
    if kind == "root":
        return "root, certified equation" if proved else f"root checked to {reached} digits"
    return "certified closed form" if proved else f"closed form checked to {reached} digits"


def status(entry: Entry, certificate: Certificate, checks: Sequence[Evidence]) -> str:
    """How one entry is known; `checks` are the checks of that entry, none of which may have failed."""
    failed = next((check for check in checks if check.outcome == "failed"), None)
    return f"failed: {failed.compared}" if failed else word(entry.status, certificate.proved, digits(checks))


def cell(
    entries: Mapping[str, Entry], certificates: Mapping[str, Certificate], checks: Mapping[str, Sequence[Evidence]]
) -> str:
    """A problem in a few words: how many entries are certified, then what the others are, by suffix."""
    return summary({suffix: status(entries[suffix], certificates[suffix], checks[suffix]) for suffix in entries})


def summary(words: Mapping[str, str]) -> str:
    """The same from the words of the entries: 11 certified, p one integral (30 digits)."""
    certified = ("certified closed form", "root, certified equation")
    count = sum(text in certified for text in words.values())
    others: dict[str, list[str]] = {}
    for suffix, text in words.items():
        if text not in certified:
            others.setdefault(text, []).append(suffix)
    parts = [f"{count} certified"] if count else []
    return ", ".join([*parts, *(f"{' '.join(suffixes)} {text}" for text, suffixes in others.items())])
