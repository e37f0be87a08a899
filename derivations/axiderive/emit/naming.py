"""What stands beside a formula: its label, its left side, and the system its entry belongs to."""

from __future__ import annotations

from .. import notation as nt
from ..contact.systems import BODIES, ROUND, SYSTEMS
from ..entry import Entry

LEFT = {
    "d": "d=g(a)", "F": r"F_{\mathrm N}", "p": "p(r)", "w": "w(r)", "k": r"\frac{\mathrm{d}F_{\mathrm N}}{\mathrm{d}d}",
    "pm": r"\bar p=\frac{F_{\mathrm N}}{\pi a^{2}}", "ad": "a", "aF": "a", "Fd": r"F_{\mathrm N}", "dF": "d",
    "rz": "r_{0}", "rp": r"r_{\mathrm{max}}", "pp": r"p_{\mathrm{max}}",
    "dmin": r"d_{\mathrm{min}}", "Fmin": r"F_{\mathrm{min}}",
}  # fmt: skip
ADHESIVE = {
    "Dl": r"\Delta\ell", "d": r"d_{\mathrm{adh}}(a)", "F": r"F_{\mathrm{adh}}(a)",
    "p": r"p_{\mathrm{adh}}(r)", "w": r"w_{\mathrm{adh}}(r)", "ad": "a", "aF": "a",
    **{f"{x}{m}": rf"{x}_{{\mathrm {m}}}" for x in "aFd" for m in "cm"},
}  # fmt: skip
TANGENTIAL = {"F": "F_x", "tau": r"\tau(r)", "u": "u", "c": "c", "us": r"u_{\mathrm s}"}
PLANE = {
    "P": "P", "p": "p(x)", "s": r"\frac{\mathrm{d}w}{\mathrm{d}x}", "d": "d", "aP": "a", "xz": "x_{0}",
    "Pmin": r"P_{\mathrm{min}}", "phi": r"\varphi", "cw": r"\ell",
}  # fmt: skip
LEFTS = {"adhesive": ADHESIVE, "tangential": TANGENTIAL, "plane": PLANE}
GROUPS = {system.group: system.name for system in SYSTEMS if system.pool is ROUND}
PREFIXES = {system.pool.prefix: system.name for system in SYSTEMS if system.pool.prefix}

LABELS = {
    "ac": "Pull-off radius: force control", "am": "Pull-off radius: depth control",
    "Fc": "Pull-off force: force control", "Fm": "Pull-off force: depth control",
    "dc": "Pull-off depth: force control", "dm": "Pull-off depth: depth control", "us": "Full slip: displacement",
    "u": "Displacement", "tau": "Traction", "xz": "Place: of first zero pressure",
    "rz": "Ring: of first zero pressure", "aP": "Half-width from load",
    "step": "Force: step of the depth", "load": "Contact radius: step of the force", "ramp": "Force: ramp of the depth",
}  # fmt: skip
"""Labels that say it shorter than those of the quantities."""


def label_of(suffix: str, text: str) -> tuple[str, str]:
    """Label of a quantity and the grey words under it."""
    text = LABELS.get(suffix.partition("_")[0], text).removesuffix(", stable branch")
    for word in (" from ", ": ", " relative to ", " of the "):
        if word in text:
            first, _, second = text.partition(word)
            return _short(first), f"{word.strip(' :')} {second}".strip()
    return _short(text), ""


def _short(label: str) -> str:
    if label in ("Displacement outside", "Surface displacement"):
        return "Displacement"
    return "Depth" if label == "Depth of the middle" else label


def system_of(entry: Entry) -> str:
    """Name of the system whose entry this is, read off its key."""
    first, *groups, _ = entry.key.split(".")
    if first in BODIES.names:
        return first
    return PREFIXES.get(first) or GROUPS.get(".".join(groups), "normal")


def left_of(entry: Entry) -> str:
    """The left side of the row."""
    table = LEFTS.get(system_of(entry).rpartition(".")[2], LEFT)
    return table.get(entry.suffix) or nt.describe(entry.quantity.symbol).latex
