"""The tree for choosing a profile: questions about a body, and what a user calls the bodies that answer them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

Answer = tuple[str, str]
"""Profile, and the bodies it stands for."""
QUESTIONS: tuple[tuple[str, str, tuple[Answer, ...]], ...] = (
    ("Pointed", "a tip with straight flanks", (
        ("cone", "sharp Berkovich, Vickers or conical tip"),
        ("rounded_cone", "blunted tip, smooth into the flank"),
        ("sphere_tipped_cone", "sphero-conical tip, blunted Berkovich"),
        ("hyperboloid", "blunted AFM tip, calibrated area function"),
        ("truncated_cone", "cone worn or cut flat"),
    )),
    ("Round", "one point of first contact", (
        ("paraboloid", "ball, lens, any smooth tip (Hertz)"),
        ("sphere", "ball or colloidal probe at any depth"),
        ("ellipsoid", "ball flattened or drawn out along its axis"),
        ("capped_paraboloid", "ball with a worn, flatter cap"),
        ("truncated_paraboloid", "ball worn flat"),
        ("wavy_paraboloid", "lens or ball with ripples"),
        ("gaussian", "single bump, asperity"),
    )),
    ("Flatter than round", "or a measured power of $r$", (
        ("power_law", "measured power, any exponent"),
        ("polynomial", "measured shape, aspherical lens"),
        ("quartic", "no curvature at the tip, order 4"),
        ("sextic", "no curvature at the tip, order 6"),
    )),
    ("Flat", "and the edge is rounded", (
        ("rounded_punch", "worn pin, flat punch with rounded edge"),
        ("rounded_curved_punch", "worn pin with a slightly curved face"),
    )),
    ("Edge of contact fixed", "a sharp edge, whatever the load", (
        ("flat_punch", "flat punch, pile, foundation"),
        ("capped_cylinder", "cylinder with a round end"),
        ("concave_paraboloid", "cup, hollow-ground punch"),
        ("concave_quartic", "cup with a flat bottom"),
        ("concave_power", "cup of any power"),
    )),
    ("Long", "the same in every section", (
        ("plane.parabola", "roller, cylinder on its side"),
        ("plane.wedge", "knife edge, wedge"),
        ("plane.rounded_wedge", "blunt knife edge"),
        ("plane.truncated_wedge", "wedge worn flat"),
        ("plane.power_law", "crowned or measured roller"),
        ("plane.quartic", "flat-crowned roller, order 4"),
        ("plane.sextic", "flat-crowned roller, order 6"),
        ("plane.rounded_punch", "fretting pad, worn rail"),
        ("plane.flat_punch", "strip foundation, seal lip"),
        ("plane.eccentric_punch", "strip loaded off its middle"),
        ("plane.concave_parabola", "hollow strip"),
        ("plane.concave_quartic", "hollow strip, flat bottom"),
        ("plane.concave_power", "hollow strip of any power"),
    )),
    ("Pressure known", "and not the shape", (
        ("loads.uniform", "fluid, tyre, soft pad"),
        ("loads.hertzian", "ball contact"),
        ("loads.punch", "rigid foundation"),
        ("loads.power", "any power of the distance to the edge"),
    )),
)  # fmt: skip
ABREAST = 4
"""Answers on a line."""


def chart(summaries: Sequence[Mapping[str, Any]]) -> list[dict[str, Any]]:
    """The questions with the answers of which the edition has an entry, in lines."""
    known = {m["name"]: m for m in summaries}
    found = []
    for question, hint, answers in QUESTIONS:
        shown = [
            {"name": name, "number": known[name]["number"], "title": known[name]["title"], "words": words,
             "shape": known[name]["shape"]}
            for name, words in answers if name in known
        ]  # fmt: skip
        if shown:
            lines = [shown[i : i + ABREAST] for i in range(0, len(shown), ABREAST)]
            found.append({"question": question, "hint": hint, "lines": lines})
    return found
