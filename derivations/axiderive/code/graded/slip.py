"""What a graded contact gains from the zone of stick to its edge, by the rule of each shape of its profile."""

from __future__ import annotations

from ..writer import Writer
from .families import Family, family

RULES = {
    "hyperboloid": "smooth", "gaussian": "smooth", "sphere": "below", "flank": "beyond", "rim": "beyond",
    "rounding": "beyond", "rounded": "rounded", "tipped": "tipped", "waves": "waves",
}  # fmt: skip
"""Which rule of the runtime follows the growth of a shape."""


def gains(writer: Writer) -> tuple[list[str], list[str], list[str]]:
    """The lines of the force, the traction and the displacement."""
    own = family(writer.profile)
    limit = _domain(writer, own)

    def limited(value: str) -> str:
        return f"return np.where({limit}, {value}, np.nan)" if limit else f"return {value}"

    traction = f"mu * either(r < c, lambda: H / np.pi * gain(), lambda: {writer.call('_pressure', 'r', 'a')})"
    lines = ["inside = np.minimum(r, c)", *_gains(own, "pressure", "inside", "return")]
    inside = ["def gain() -> Array:", *(f"    {line}" for line in lines)]
    return (
        [*_gains(own, "force"), limited("mu * (2.0 * H / (1.0 + k)) * gain")],
        [*([""] if writer.profile.abbreviations else []), *inside, "", limited(traction)],
        [*_gains(own, "depth"), limited("mu * (H / H_x) * gain")],
    )


def _gains(own: Family, quantity: str, r: str = "0.0", result: str = "gain =") -> list[str]:
    """The lines of `gain`, or that return it: the sum of what the terms of a profile gain from c to a."""
    parts = {}
    for term in own.terms:
        if term.shape == "power":
            (n,) = term.texts
            call = f'power_gain("{quantity}", {r}, c, a, {n}, k)'
        else:
            lengths = ", ".join(term.texts) + ("," if len(term.texts) == 1 else "")
            shape = f"{term.shape}_{quantity}, {term.shape}_rate, ({lengths})"
            call = f'{RULES[term.shape]}_gain("{quantity}", {shape}, {r}, c, a, k)'
        parts[term.shape] = term.times(call)
    if len(parts) > 1:
        return [*(f"{shape} = {part}" for shape, part in parts.items()), f"{result} {' + '.join(parts)}"]
    (text,) = parts.values()
    return [f"{result} sum({text} for j, A_j in enumerate(A, 1))" if own.summed else f"{result} {text}"]


def _domain(writer: Writer, own: Family) -> str:
    """The condition on the radii, "" where there is none."""
    if writer.profile.truncated:
        return f"c >= {writer.profile.breaks[0]}"
    if own.has("sphere"):
        return f"a <= {writer.profile.chain[-1]}"
    return f"{writer.call('_rate', 'a')} >= 0.0" if own.has("gaussian") else ""
