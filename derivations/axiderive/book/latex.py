"""Entries in Jupyter, which show their formulas as the handbook prints them."""

from __future__ import annotations

from ..entry import Entry
from ..rows.row import row


def markdown(entry: Entry) -> str:
    """Key, label and formula of an entry, its ranges line by line, for Markdown with LaTeX."""
    lines = [f"`{entry.key}` {entry.quantity.label}"]
    found = row(entry)
    for region in found.regions:
        formula = region.tex.replace(r"\begin{aligned}[t]", r"\begin{aligned}")
        where = rf"\qquad {region.condition}" if region.condition else ""
        lines.append(rf"$\displaystyle {formula}{where}$")
    if found.remark:
        behind = f" `{entry.key.removesuffix(entry.suffix)}{found.uses}`" if found.uses else ""
        lines.append(found.remark + behind)
    return "\n\n".join(lines)
