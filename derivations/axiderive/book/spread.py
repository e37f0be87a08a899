"""The page model of one profile: everything its template needs, as plain data."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from .. import notation as nt
from ..entry import Entry
from ..figures.contours import pictures
from ..figures.curves import curves
from ..figures.drawing import outline
from ..figures.given import axes_of, load_sketch, tilted_sketch
from ..figures.plots import SHOWN, frames, plots
from ..figures.sketch import sketch
from ..figures.values import Numbers, StripNumbers, sketch_values
from ..physics.peak import stretch_of_arc
from ..physics.systems import PRINTED, Problem, pool_of
from ..print.words import prose
from ..profiles.loads import Load
from ..profiles.pools import ROUND
from ..profiles.profile import Profile
from ..rows import blocks, special
from ..store.cache import digest
from ..worked.normal import worked, worked_bodies, worked_given
from . import back, front, page
from . import evidence as proven
from .page import given_table, panel

Entries = Mapping[str, Entry]
PLOT_DIGITS = 16


def problems_of(profile_id: str) -> list[Problem]:
    """The problems of a profile, of whatever system."""
    pool, name = pool_of(profile_id), profile_id.rpartition(".")[2]
    profile = pool.load(name)
    return [Problem(s, name) for s in PRINTED if s.pool is pool and not s.refusal(profile)]


def model(profile_id: str, derived: Mapping[str, Entries], evidence: Mapping[str, Any], number: str) -> dict[str, Any]:
    """What the template prints for one profile, whose problems are given by key."""
    pool, name = pool_of(profile_id), profile_id.rpartition(".")[2]
    profile = pool.load(name)
    refusals = {s.name: message for s in PRINTED if s.pool is pool and (message := s.refusal(profile))}
    own = {problem.key: derived[problem.key] for problem in problems_of(profile_id) if problem.key in derived}
    records = {key: evidence.get(key, {"entries": {}}) for key in own}
    main = next((entries for key, entries in own.items() if key == profile_id), {})
    rows = blocks.every(profile_id, derived)
    shown = blocks.blocks(profile_id, derived, rows, refusals, evidence)
    printed = [row for block in shown.values() for line in block.lines for row in line]
    formulas = [(region.condition, region.tex) for row in printed for region in row.regions]
    further = [(row.small, row.tex) for block in shown.values() for row in block.approached]
    figures = _figures(profile_id, profile, main, derived)
    return {
        "name": profile_id,
        "title": prose(f"Plane {profile.title[0].lower()}{profile.title[1:]}" if pool.strip else profile.title),
        "number": number,
        "chapter": int(number.partition(".")[0]),
        "subtitle": prose(profile.subtitle),
        "panel": panel(profile, main, pool.strip) if main else [],
        "place": str(pool.place),
        "first": next(system.name for system in PRINTED if system.pool is pool),
        "rows": rows,
        "blocks": shown,
        "sources": [(prose(work), back.label(work)) for work in profile.sources],
        "equations": _equations(own),
        "keys": [entry.key for entries in own.values() for entry in entries.values()],
        "symbols": sorted({s for entries in own.values() for s in page.symbols(entries)}),
        "master_row": front.master_row(main),
        "special": special.tables(profile_id),
        "elsewhere": special.elsewhere(profile_id),
        "host": special.HOSTS.get(profile_id, ""),
        "status": proven.matrix(own, records)["profiles"].get(profile_id, {}),
        "coverage": proven.coverage([one for record in records.values() for one in record["entries"].values()]),
        "digest": digest([*formulas, *further]),
        # the letters that stand for a root somewhere in the rows
        "roots": sorted({name for _, tex in formulas for name in _ROOT.findall(tex)}),
        "shape": figures["picture"] and outline(figures["picture"]),
        **figures,
    }


_ROOT = re.compile(r"(?:quad |,)(\\?[a-z]+)=\\sqrt")


def _equations(own: Mapping[str, Entries]) -> list[str]:
    found = {r for entries in own.values() for entry in entries.values() for r in entry.references}
    return sorted(found, key=lambda text: tuple(map(int, text.strip("()").split("."))))


NOTHING: dict[str, Any] = {
    **dict.fromkeys(("worked", "picture", "checks", "stress")),
    **dict.fromkeys(("plots", "curves", "axes", "graded"), ()),
    **{"loaded": False, "derivation": ""},
}


def _stretched(profile: Profile) -> bool:
    return stretch_of_arc(profile) not in (None, 1)


def _figures(profile_id: str, profile: Profile, main: Entries, derived: Mapping[str, Entries]) -> dict[str, Any]:
    """Sketch, plots, check values, calls and derivation, where the profile has them."""
    pool = pool_of(profile_id)
    force, place = nt.describe(pool.force).latex, str(pool.place)
    texts = NOTHING | {"derivation": page.derivation(profile_id, profile, main)}
    texts["axes"] = axes_of(profile, main) if main else ()
    if texts["axes"]:
        texts |= {"worked": worked_given(profile, main), "checks": given_table(profile, main)}
        if isinstance(profile, Load):
            return texts | {"picture": load_sketch(profile, main), "loaded": True}
        return texts | {"picture": tilted_sketch(profile, main, force)}
    if "E_star" in main:
        texts["worked"] = worked_bodies(main)
    if not main or "p" not in main:
        return texts
    values = sketch_values(profile)
    if pool.strip:
        rough: Numbers = StripNumbers(profile, main, values, PLOT_DIGITS)
        exact: Numbers = StripNumbers(profile, main, values)
    else:
        rough, exact = Numbers(profile, main, values, PLOT_DIGITS), Numbers(profile, main, values)
    graded = derived.get(f"{profile_id}.fgm", {})
    return texts | {
        "graded": frames(profile, main, graded) if profile_id in SHOWN and "p" in graded else (),
        "stress": pictures(rough) if pool is ROUND else None,
        # a stretched sphere has the sphere's, over its own depth and force
        "curves": curves(profile, rough) if profile.compact and pool is ROUND and not _stretched(profile) else (),
        "worked": worked(profile_id, profile, derived, type(rough)),
        "picture": sketch(profile, rough, force, place),
        "plots": plots(profile, rough),
        "checks": page.check_table(profile, exact),
    }
