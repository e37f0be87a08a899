"""The study: every method agrees with the definition, a wrong one is noticed, the records hold what they promise."""

from __future__ import annotations

import importlib
import json
import math
import shutil
from functools import partial

import mpmath as mp
import numpy as np
import pytest
from selected import few

from axiderive import notation as nt
from axiderive.cli import main
from axiderive.exits import USAGE
from axiderive.store.writing import stale_files
from axiderive.study import error, extremes, languages, maps, naive, rivals, speed
from axiderive.study.error import DIGITS, QUICK, arguments, exact, methods, skipped
from axiderive.study.report import relative, rounded, to_json
from axiderive.study.subject import PARAMETERS, QUANTITIES, RADIUS, RULED, Subject, subject

# worst relative errors of the quick settings over all CASES, with a margin of at least 1.5
TOLERANCES = {
    "emitted": 1e-14,
    "generated rule": 1e-13,
    "lambdify": 1e-10,
    "Gauss-Jacobi": 1e-3,
    "quad": 1e-10,
    "quad, substituted": 1e-11,
    "quad and root": 1e-9,
    "table": 2e-5,
    "trapezoid MDR": 2e-3,
    "FFT MDR": 1e-3,
    "mpmath": 1e-8,
    "mpmath, substituted": 1e-9,
}
CASES = (
    ("cone", "p"), ("rounded_punch", "p"), ("rounded_punch", "w"), ("rounded_punch", "Fd"),
    ("power_law.fgm", "p"), ("power_law.fgm", "w"), ("power_law.fgm", "Fd"), ("cone.adh", "ad"),
    ("capped_paraboloid", "p"), ("sphere_tipped_cone", "w"), ("hyperboloid", "p"), ("concave_power", "p"),
    ("concave_power", "w"), ("truncated_cone.fgm", "p"), ("capped_cylinder.fgm", "p"), ("sphere_tipped_cone.fgm", "w"),
    ("capped_cylinder.fgm", "w"), ("gaussian.fgm", "w"), ("plane.rounded_punch", "p"),
    ("plane.concave_power", "p"), ("concave_quartic.fgm", "w"),
)  # fmt: skip
SECONDS = (
    ("hyperboloid", "p"), ("concave_power", "p"), ("capped_paraboloid", "p"), ("rounded_punch", "p"),
    ("sphere_tipped_cone", "w"), ("truncated_cone.fgm", "p"), ("plane.concave_power", "p"),
    ("sphere_tipped_cone.fgm", "w"),
)  # fmt: skip
"""A second or two each; every method is tried at least at one of the others."""
GIVEN = ("depth", "rate", "slope")
OWN = ("emitted", "lambdify")
NOTICED = 2 * max(TOLERANCES.values())


@pytest.mark.parametrize(("name", "suffix"), few(CASES, [c for c in CASES if c not in SECONDS], pytest.mark.slow))
def test_every_method_agrees_with_the_definition(name, suffix):
    found = {m.name: max(error.errors(subject(name), suffix, m)) for m in methods(subject(name), suffix, QUICK)}
    assert {method: worst for method, worst in found.items() if worst > TOLERANCES[method]} == {}


@pytest.mark.parametrize(("name", "suffix"), few(CASES, [c for c in CASES if c not in SECONDS], pytest.mark.slow))
def test_every_method_uses_the_profile_it_is_given(name, suffix):
    """A profile 5 % too steep must show in each: a reference made from the same data would not see it."""
    wrong = Subject(name)
    for given in (getattr(wrong, name) for name in GIVEN):
        for kind in ("numpy", "math", "mpmath"):
            function = getattr(given, kind)
            given.__dict__[kind] = lambda x, function=function: function(x) * 1.05
    own = (*OWN, "generated rule") if suffix in RULED.get(name, ()) else OWN
    rivals_only = [m for m in methods(wrong, suffix, QUICK) if m.name not in own]
    assert rivals_only
    for method in rivals_only:
        assert max(error.errors(subject(name), suffix, method)) > NOTICED, method.name


@pytest.mark.parametrize(
    ("function", "counts", "order"),
    [(rivals.trapezoid_pressure, (100, 400), 1.0), (rivals.fft_pressure, (1000, 4000), 0.9)],
)
def test_grids_converge(function, counts, order):
    """Median errors next to four radii fall at least as fast as the order of the method."""
    face, radii = subject("rounded_punch"), arguments(subject("rounded_punch"), "p", 4)
    medians = []
    for count in counts:
        r, pressure = function(face, count)
        near = np.abs(r[:, None] - radii).argmin(axis=0)
        errors = [relative(pressure[i], exact(face, "p", float(r[i]))) for i in near]
        medians.append(float(np.median(errors)))
    assert medians[0] / medians[1] > (counts[1] / counts[0]) ** order


@pytest.mark.parametrize(
    "function", [partial(rivals.jacobi_force, count=64), lambda tipped, d: rivals.Script(tipped).force(d)]
)
def test_a_force_is_taken_from_break_to_break(function):
    """On the tip and beyond: in one piece the fixed rule is wrong by 3e-7, the adaptive one by 1.5e-12."""
    tipped = subject("sphere_tipped_cone")
    d = arguments(tipped, "Fd", 3)
    for depth, force in zip(d, function(tipped, d), strict=True):
        assert relative(force, exact(tipped, "Fd", float(depth))) < 1e-12


def test_reference_is_the_textbook_where_there_is_one():
    with mp.workdps(DIGITS + 10):
        tangent = mp.tan(mp.mpf(PARAMETERS[nt.theta]))
        cone = tangent / 2 * mp.acosh(mp.mpf(RADIUS) / mp.mpf(0.3))
        assert abs(exact(subject("cone"), "p", 0.3) / cone - 1) < mp.mpf(10) ** (5 - DIGITS)
        hertz = mp.mpf(4) / 3 * mp.sqrt(PARAMETERS[nt.R]) * mp.mpf(0.7) ** 1.5
        assert abs(exact(subject("paraboloid"), "Fd", 0.7) / hertz - 1) < mp.mpf(10) ** (5 - DIGITS)


def test_error_record_holds_what_it_promises():
    record = error.measure(["cone"], quick=True)
    assert json.loads(to_json(record)) == record
    assert {"note", "settings", "rows", "skipped"} <= set(record)
    assert {row["key"] for row in record["rows"]} == {f"cone.{suffix}" for suffix in QUANTITIES}
    for row in record["rows"]:
        assert set(row) == {"key", "method", "setting", "ratio", "worst", "median", "points", "lost"}
        assert row["ratio"] > 0
        assert row["ratio"] == rounded(row["ratio"])
    assert "seconds" not in to_json(record)
    assert "quad and root" in error.text(record)


def test_skipped_methods_say_why(monkeypatch):
    monkeypatch.setattr(rivals, "find_spec", lambda name: None)
    reasons = {row["method"]: row["reason"] for row in skipped(subject("cone"), "p")}
    assert "pip install tamaas" in reasons["BEM"]
    assert "BEM" not in {method.name for method in methods(subject("cone"), "p", QUICK)}


def test_axes_are_the_lengths_that_the_formula_compares():
    def names(problem, suffix):
        return [axis.name for axis in maps.axes(subject(problem).entries[suffix])]

    assert names("cone", "p") == ["r/a"]
    assert names("cone", "w") == ["a/r"]
    assert names("rounded_punch", "p") == ["r/a", "b/a"]
    assert names("sphere", "w") == ["a/r", "a/R"]
    assert names("power_law", "p") == ["r/a", "n"]
    assert names("paraboloid", "F") == []


def test_map_tells_naive_from_emitted():
    record = maps.measure(["rounded_punch"], quick=True, quantities=("d", "w"))
    assert json.loads(to_json(record)) == record
    depth, outside = record["maps"]
    assert (len(depth["emitted"]["worst"]), len(outside["emitted"]["worst"])) == (1, maps.QUICK_CELLS)
    assert [len(edges) for edges in outside["edges"]] == [maps.QUICK_CELLS + 1] * 2
    assert depth["naive"]["worst_ulps"] > 1e3 > depth["emitted"]["worst_ulps"]
    assert depth["naive"]["share"] > depth["emitted"]["share"] == 0
    assert record == maps.measure(["rounded_punch"], quick=True, quantities=("d", "w"))


@pytest.mark.parametrize(("factor", "share", "lost"), [(1 + 1e-11, 1.0, 0), (math.nan, 1.0, 4), (1 + 1e-13, 0.0, 0)])
def test_map_sees_a_wrong_function(monkeypatch, factor, share, lost):
    from axicontact.normal import cone

    right = cone.pressure
    monkeypatch.setattr(cone, "pressure", lambda *fields, **parameters: right(*fields, **parameters) * factor)
    (pressure,) = maps.measure(["cone"], quick=True, quantities=("p",))["maps"]
    assert (pressure["emitted"]["share"], pressure["emitted"]["lost"]) == (share, lost)
    assert (maps.LOST in pressure["emitted"]["worst"][0]) == bool(lost)


def test_speed_compares_with_the_formula_itself():
    record = speed.measure(("cone", "paraboloid"), quick=True)
    found = {row["key"]: row for row in record["rows"]}
    assert set(found) == {f"{name}.{suffix}" for name in ("cone", "paraboloid") for suffix in ("d", "F", "p", "w")}
    numbers = [x for row in found.values() for x in (row["scalar"], row["steps"], *row["arrays"], row["copy"])]
    assert min(numbers) > 0.0
    assert all(row["ratio"] > 0.0 for row in (*record["imports"], {"ratio": record["fresh"]}))
    assert "cone.p" in speed.text(record)


@pytest.mark.parametrize(
    ("key", "field"), [("cone.p", nt.r), ("cone.w", nt.r), ("rounded_punch.F", nt.a), ("power_law.d", nt.a)]
)
def test_what_speed_compares_with_gives_the_same_number(key, field):
    name, _, suffix = key.rpartition(".")
    entry = subject(name).entries[suffix]
    values = {symbol: PARAMETERS.get(symbol, RADIUS) for symbol in (*entry.parameters, *entry.quantity.arguments)}
    x = 3.0 if suffix == "w" else 1.25
    bare = speed.in_math(entry, values | {field: x})
    module = importlib.import_module(f"axicontact.normal.{name}")
    own = getattr(module, entry.quantity.function)
    got, steps, expected = (
        speed.called(function, entry, values)(x) for function in (bare, speed.in_steps(entry, module), own)
    )
    assert got == pytest.approx(expected, rel=1e-13, abs=0.0)
    assert steps == expected


def test_the_same_steps_check_nothing():
    """A negative depth, from a radius that the function itself refuses."""
    entry, module = subject("cone").entries["d"], importlib.import_module("axicontact.normal.cone")
    assert math.isnan(module.depth(-1.0, theta=0.3))
    assert speed.in_steps(entry, module)(-1.0, theta=0.3) < 0.0


@pytest.mark.skipif(shutil.which("cc") is None, reason="no C compiler: apt-get install gcc libc6-dev")
def test_the_same_calls_in_c():
    """Of every function with an example, pull-off under one control; what has no program is left out."""
    record = languages.measure(["adhesive.cone", "layer.cone"], quick=True)
    module = importlib.import_module("axicontact.adhesive.cone")
    assert [row["function"] for row in record["rows"]] == [f"adhesive.cone.{own}" for own in module.__all__]
    assert all(row["ratio"] > 0.0 and row["nanoseconds"] > 0.0 for row in record["rows"])
    assert languages.text(record).startswith(f"{len(module.__all__)} functions: ")


def test_the_numbers_of_an_example():
    module = importlib.import_module("axicontact.adhesive.cone")
    assert languages.example(module.depth) == {"a": 1.0, "theta": 0.35, "E_star": 1.0, "dgamma": 0.01}
    assert languages.example(test_the_numbers_of_an_example) is None


def test_speed_leaves_out_what_math_cannot_do():
    entry = subject("truncated_cone").entries["p"]
    values = {symbol: PARAMETERS.get(symbol, RADIUS) for symbol in (*entry.parameters, nt.r)}
    assert speed.in_math(entry, values | {nt.r: 1.5}) is None


def test_extremes_hold_every_limit():
    record = extremes.measure(quick=True)
    assert json.loads(to_json(record)) == record
    for row in record["rows"]:
        assert set(row) == {"limit", "key", "case", "emitted", "naive", "ulps"}
    named = {row["limit"] for row in record["rows"]}
    assert named == {limit.name for limit in extremes.LIMITS}
    assert "worst emitted case" in extremes.text(record)


def limit_of(name, suffix=""):
    return next(limit for limit in extremes.LIMITS if (limit.name, limit.suffix) == (name, suffix))


def test_extremes_judge_both_ways():
    """Next to the edge the printed acosh(a/r) loses half of the digits, the emitted form none."""
    (case,) = (c for c in limit_of("edge", "p").cases(["cone"]) if "1e-15" in c.label)
    value = naive.reference(case.problem, case.suffix, case.point)
    found = naive.judged(case.problem, case.suffix, [case.point], [value])
    assert found["emitted"][0].ulps < 10 < 1e6 < found["naive"][0].ulps


def test_limits_of_other_systems_have_their_references():
    """Grading and pull-off: two ways to the same numbers."""
    for limit, tolerance in ((limit_of("k -> 0"), 1e-12), (limit_of("pull-off", "aF"), 1e-10)):
        cases = list(limit.cases(quick=True))
        assert cases
        for case in cases:
            known = subject(case.problem).entries
            value = naive.reference(case.problem, case.suffix, case.point)
            assert value is not None, case
            got = np.squeeze(naive.naive(known[case.suffix], known)(case.point))
            assert relative(got, value) < tolerance, case


def test_values_that_are_lost_or_refused_count_as_such():
    assert naive.judge(math.nan, mp.mpf(1)).lost
    assert naive.judge(math.inf, mp.mpf(1)).lost
    assert naive.judge(1.0, mp.mpf(1)).ulps == 0
    assert naive.judge(float(np.nextafter(1.0, 2.0)), mp.mpf(1)).ulps == 1


def test_study_alone_lists_its_topics(capsys):
    assert main(["study"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert [line.split()[2] for line in lines] == ["corpus", "error", "speed", "languages", "maps", "extremes"]


def test_a_part_of_a_record_is_never_kept(capsys):
    assert main(["study", "maps", "--quick", "--only", "cone", "--write"]) == USAGE
    assert "--write keeps whole records" in capsys.readouterr().err


def test_command_prints_a_table_or_json(capsys):
    assert main(["study", "maps", "--quick", "--only", "cone"]) == 0
    assert capsys.readouterr().out.splitlines()[1].startswith("cone.p")
    assert main(["study", "maps", "--quick", "--only", "cone", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["study"] == "maps"


def test_a_build_leaves_the_records_alone(tmp_path):
    for path in ("evidence/study/error.json", "evidence/kone.json"):
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text("{}")
    assert stale_files([], tmp_path) == ["evidence/kone.json"]
