"""The committed catalogue: no problem without a module, no function without an entry, no entry without evidence.

Everything here is read from what is committed, so that a formula cannot be
published by a way around the checks.
"""

from __future__ import annotations

import ast
import functools
import json
from importlib import import_module
from pathlib import Path

import pytest
from stored_book import evidence, stored

from axiderive.book.index import formulas_of, index_record
from axiderive.build import work
from axiderive.build.verification import checks_of
from axiderive.build.work import Settings
from axiderive.physics import adhesive, cohesive
from axiderive.physics.systems import BY_NAME, SYSTEMS, Problem, problems
from axiderive.profiles.pools import BODIES
from axiderive.stable.measure import closure
from axiderive.stable.records import MEASURED
from axiderive.store.index import dumps, loads

CATALOGUE = Path(__file__).resolve().parents[1] / "catalogue"
PROBLEMS = {problem.key: problem for problem in problems()}
PACKAGES = {problem.system.name: problem.system for problem in problems()}

COMPACT = {
    "profile", "depth", "force", "pressure", "displacement", "stiffness", "mean_pressure",
    "radius_from_depth", "radius_from_force", "force_from_depth", "depth_from_force",
}  # fmt: skip
COMPLETE = {
    "profile", "force", "pressure", "displacement", "stiffness", "depth_from_force",
}  # fmt: skip
CONCAVE = {"minimum_depth", "minimum_force", "zero_radius"}
PEAKED = (
    *("paraboloid", "rounded_cone", "hyperboloid", "quartic", "sextic", "rounded_punch", "power_law"),
    *("sphere", "ellipsoid", "gaussian"),
)
ADHESIVE = {
    "retraction", "depth", "force", "pressure", "displacement", "radius_from_depth", "radius_from_force", "pull_off",
    "work_of_adhesion_from_pull_off",
}  # fmt: skip
TANGENTIAL = {"tangential_force", "traction", "tangential_displacement", "stick_radius", "full_slip_displacement"}
BELOW = {
    "surface_stress", "surface_displacement", "sliding_stress", "greatest_von_mises", "greatest_shear",
    "partial_slip_stress",
}  # fmt: skip
"""Functions of the numbers below the surface whose entries stand under stress and displacement."""
LAWS = ("maxwell", "kelvin_voigt", "standard_solid", "power_creep")
FOLLOW = {"load_within", "energy"}
"""Of the homogeneous half-space, as the greatest pressure is."""
TURNING = {"torque", "slip_angle", "traction", "full_slip_torque"}
SEARCHED = {"pull_off", "radius_from_depth", "radius_from_force", "without_contact"}
INVERTED = {"work_of_adhesion_from_pull_off"}
"""Of adhesive contacts, the inverse of `pull_off`."""
COHESIVE = {"work_of_separation", "cohesive_radius", "depth", "force", "pressure", "displacement"}
"""Functions of entries of a cohesive zone, behind those that search among their values for a state."""
POWERS = ("cone", "paraboloid", "quartic", "sextic", "power_law")
"""Of which the moment of the depth is closed."""
LAYERED = {
    "depth", "force", "pressure", "radius_from_depth", "radius_from_force", "force_from_depth", "depth_from_force",
    "depth_first_order", "force_second_order", "adhesive_depth", "adhesive_force", "adhesive_pressure",
}  # fmt: skip
PLANE = {"profile", "load", "pressure", "slope", "depth", "half_width_from_load"}
PLANE_COMPLETE = {"profile", "pressure", "slope", "depth"}


WITHOUT_CERTIFICATE = ("materials.h_N", "materials.H")
"""Closed forms that rest on h_N, which is compared with a solution of the equations of equilibrium."""


def interface(problem: Problem) -> set[str]:
    """The functions that the design names for a problem."""
    profile, family = problem.profile, problem.system.name.rpartition(".")[2]
    compact = profile.contact == "compact"
    if family == "normal":
        peak = {"peak_pressure"} if problem.key in PEAKED else set()
        peak |= set() if problem.system.medium.graded else FOLLOW
        return (COMPACT if compact else COMPLETE) | peak | (CONCAVE if "concave" in problem.name else set())
    if family == "adhesive":
        return ADHESIVE if compact else {"retraction", "pull_off"} | INVERTED
    if family == "tangential":
        return TANGENTIAL
    if family == "viscoelastic":
        kinds = ["step_force"] + ["step_load_radius"] * compact
        if compact or problem.name == "flat_punch":
            kinds += ["ramp_force", "earlier_time", "retract_force", "contact_time"] + ["retract_radius"] * compact
        return {f"{kind}_{law}" for kind in kinds for law in LAWS}
    if family == "torsion":
        return TURNING if compact else {"torque", "displacement", "stress"}
    if family == "cohesive":
        return COHESIVE | SEARCHED
    if family == "layer":
        second = {"depth_second_order"} if problem.name in POWERS else set()
        return LAYERED | second if compact else {"force", "pressure", "depth_from_force"}
    if family == "subsurface":
        return {"stress", "displacement"} | BELOW - (set() if compact else {"partial_slip_stress"})
    if family == "loads":
        return {"displacement"}
    if family == "materials":
        return {
            "effective_modulus", "effective_shear_modulus", "graded_modulus", "h_N", "transversely_isotropic_modulus",
            "effective_radius", "tabor", "maugis_lambda",
        }  # fmt: skip
    if problem.name == "eccentric_punch":
        return {"pressure", "tilt", "contact_width"}
    if compact:
        return PLANE
    return PLANE_COMPLETE | ({"minimum_load", "zero_distance"} if "concave" in problem.name else set())


@functools.cache
def record(key: str) -> dict:
    return json.loads((CATALOGUE / "evidence" / f"{key}.json").read_text())


@functools.cache
def functions(path: Path) -> set[str]:
    return {n.name for n in ast.parse(path.read_text()).body if isinstance(n, ast.FunctionDef) and n.name[0] != "_"}


@functools.cache
def index() -> dict:
    return loads((CATALOGUE / "axicontact" / "index.json").read_text())


@pytest.mark.parametrize("profile", ["quartic", "plane.wedge"])
def test_the_index_of_one_profile_in_that_of_all_changes_no_line(profile):
    text = (CATALOGUE / "axicontact" / "index.json").read_text()
    whole = loads(text)
    own = loads(dumps({**whole, "entries": [row for row in whole["entries"] if row["profile"] == profile]}))
    rows = {row["key"]: row for row in own["entries"]}
    assert rows
    assert dumps({**whole, "entries": [rows.get(row["key"], row) for row in whole["entries"]]}) == text


@pytest.mark.parametrize("key", ["truncated_paraboloid", "paraboloid.adh", "flat_punch.fgm"])
def test_the_index_says_of_an_entry_what_the_engine_says(key: str) -> None:
    """Its conditions, domains and calls are those of the committed index, written anew."""
    path = PROBLEMS[key].module
    modules = {path: (CATALOGUE / path).read_text(encoding="utf-8")}
    own = {key: stored(key)}
    written = index_record(own, {key: evidence(key)}, modules, formulas_of(own))["entries"]
    assert written == [row for row in index()["entries"] if row["problem"] == key]


def test_every_problem_is_published_in_the_order_of_the_handbook() -> None:
    assert list(dict.fromkeys(row["problem"] for row in index()["entries"])) == list(PROBLEMS)
    assert {path.stem for path in (CATALOGUE / "evidence").glob("*.json")} >= set(PROBLEMS)


def test_modules_have_the_interface_and_nothing_that_no_entry_backs() -> None:
    for key, problem in PROBLEMS.items():
        found = functions(CATALOGUE / problem.module)
        assert found == interface(problem), key
        backed = {row["function"] for row in index()["entries"] if row["problem"] == key}
        backed |= INVERTED if problem.system.physics is adhesive.PHYSICS else set()
        backed |= SEARCHED if problem.system.physics is cohesive.PHYSICS else set()
        assert found - {"profile", *BELOW} == backed, key


def test_every_entry_has_its_evidence() -> None:
    """A certificate or the reason why there is none, and a passed comparison that does not rest on the derivation."""
    for key in PROBLEMS:
        stored = record(key)
        assert not stored["evidence"]["failures"], key
        assert set(stored["evidence"]["entries"]) == set(stored["entries"]), key
        for suffix, found in stored["evidence"]["entries"].items():
            certificate, entry = found["certificate"], stored["entries"][suffix]
            assert certificate["steps"] if certificate["proved"] else certificate["reason"], f"{key}.{suffix}"
            proved = certificate["proved"] or entry["status"] != "closed" or f"{key}.{suffix}" in WITHOUT_CERTIFICATE
            assert proved, f"{key}.{suffix} is closed and not certified"
            passed = [c for c in found["checks"] if c["outcome"] == "passed"]
            assert [c for c in passed if c["digits"] > 0 and c["worst"]], f"{key}.{suffix} was compared with nothing"
            assert [c for c in passed if "dimension" in c["compared"]], f"{key}.{suffix} has no dimension"


@pytest.mark.parametrize("system", [s.name for s in SYSTEMS])
def test_a_profile_that_a_physics_leaves_out_says_why(system: str) -> None:
    package = BY_NAME[system]
    if package.pool is BODIES:
        return
    listed = set(import_module(package.package).__all__)
    for name in package.pool.names:
        assert name in listed
        profile = package.pool.load(name)
        if package.refusal(profile):
            module = import_module(f"{package.package}.{name}")
            with pytest.raises(AttributeError, match=f"force is not defined: {profile.title} "):
                module.force  # noqa: B018


def test_package_lists_what_it_holds() -> None:
    import axicontact

    assert {name.partition(".")[0] for name in PACKAGES} | {"expressions", "materials"} == set(axicontact.__all__)


def test_the_evidence_was_made_by_this_engine_of_these_entries() -> None:
    """What a build has checked and measured is asked for by the digest of its inputs, and not done again here."""
    settings, stale = Settings(), []
    modules = {
        path.relative_to(CATALOGUE).as_posix(): path.read_text() for path in (CATALOGUE / "axicontact").rglob("*.py")
    }
    receipts = json.loads((CATALOGUE / "evidence" / "receipts.json").read_bytes())
    for key, problem in PROBLEMS.items():
        made_of = work.checking_key(problem, record(key)["entries"], settings)
        if receipts[key]["checks"] != work.receipt(made_of, checks_of(record(key)["evidence"])):
            stale.append(key)
        assert ("evaluation" in receipts[key]) == (problem.system in MEASURED)
        if problem.system in MEASURED:
            sources = closure(modules, problem.module)
            measured_of = work.evaluation_key(problem, record(key)["entries"], sources)
            errors = record(key)["evidence"]["evaluation"]
            if receipts[key]["evaluation"] != work.receipt(measured_of, errors):
                stale.append(f"{key} (measured errors)")
    if receipts["chapter11"]["record"] != work.receipt(work.chapter_key(), record("chapter11")):
        stale.append("chapter11")
    assert not stale, f"the engine or the entries have changed since: run make build for {', '.join(stale[:5])} ..."
    assert set(receipts) == {*PROBLEMS, "chapter11"}
