"""The command line: exit codes, messages, what is printed."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

from axiderive import cli
from axiderive.commands.show import shown
from axiderive.store import index

ROOT = Path(__file__).parents[1]


def test_every_profile_is_listed(capsys):
    from axiderive.physics.systems import profile_ids

    assert cli.main(["list"]) == 0
    rows = capsys.readouterr().out.splitlines()[1:]
    assert [row.split()[0] for row in rows] == list(profile_ids())


@pytest.mark.parametrize("topic", ["profiles", "physics", "quantities", "units"])
def test_lists_are_also_for_programs(topic, capsys):
    assert cli.main(["list", topic, "--json"]) == 0
    rows = json.loads(capsys.readouterr().out)
    assert cli.main(["list", topic]) == 0
    assert len(capsys.readouterr().out.splitlines()) == len(rows) + 1


def test_every_key_can_be_shown_in_every_form():
    catalogue, problems = index.load(), set()
    for entry in catalogue.entries:
        key = entry["key"]
        text = shown(catalogue, key, "text")
        assert text.startswith(key)
        assert all(part in text for part in entry["evidence"].split("; ")), key
        assert json.loads(shown(catalogue, key, "json")) == entry
        assert all(region["text"] in shown(catalogue, key, "latex") for region in entry["latex"])
        if entry["problem"] not in problems:  # one function of every module
            problems.add(entry["problem"])
            source = shown(catalogue, key, "python")
            assert f"def {entry['function']}(" in source
            compile(source, key, "exec")


def test_show_of_a_profile_has_all_its_formulas(capsys):
    assert cli.main(["show", "rounded_punch"]) == 0
    shown = capsys.readouterr().out
    assert all(f"\n{key}  " in shown for key in (row["key"] for row in index.load().select("rounded_punch")))


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["show", "kone"], "unknown profile or key 'kone'; did you mean 'cone'?"),
        (["show", "kone.p"], "unknown key 'kone.p'; did you mean 'cone.p'?"),
        (["show", "cone.pp"], "unknown key 'cone.pp'; did you mean 'cone.p'?"),
        (["show", "cone.q"], "unknown key 'cone.q'; see axicontact show cone"),
        (["show", "cone p"], "unknown key 'cone p'; did you mean 'cone.p'?"),
        (["show", "cone.pressure"], "unknown key 'cone.pressure'; did you mean 'cone.p'?"),
        (["show", "kone.adh.pressure"], "unknown key 'kone.adh.pressure'; did you mean 'cone.adh.p'?"),
        (["show", "cone.adhesive"], "unknown key 'cone.adhesive'; did you mean 'cone.adh'?"),
        (["show", "plane.wege.P"], "unknown key 'plane.wege.P'; did you mean 'plane.wedge.P'?"),
        (["show", "Cone"], "unknown profile or key 'Cone'; did you mean 'cone'?"),
        (["show", "hertz"], "unknown profile or key 'hertz'; did you mean 'paraboloid' or 'loads.hertzian'?"),
        (["show", "punch"], "unknown profile or key 'punch'; see axicontact list"),
        (["show", ""], "unknown profile or key ''; see axicontact list"),
        (["show", "zzzzzz"], "unknown profile or key 'zzzzzz'; see axicontact list"),
        (["check", "paraboloyd"], "unknown profile or key 'paraboloyd'; did you mean 'paraboloid'?"),
        (["build", "--only", "cone,spere"], "unknown profile 'spere'; did you mean 'sphere'?"),
        (["build", "--only", "spere", "--only", "cone"], "unknown profile 'spere'; did you mean 'sphere'?"),
    ],
)
def test_unknown_names_end_with_code_2_and_the_nearest_name(arguments, message, capsys):
    assert cli.main(arguments) == 2
    assert capsys.readouterr().err == f"axicontact: {message}\n"


@pytest.mark.parametrize(
    ("name", "key"),
    [
        ("adhesive.paraboloid", "paraboloid.adh"), ("axicontact.adhesive.paraboloid", "paraboloid.adh"),
        ("normal.cone", "cone"), ("axicontact.graded.normal.cone", "cone.fgm"), ("axicontact.materials", "materials"),
        ("adhesive.paraboloid.F", "paraboloid.adh.F"), ("axicontact.normal.cone.pressure", "cone.p"),
        ("plane.wedge.load", "plane.wedge.P"), ("loads.uniform.displacement", "loads.uniform.w"),
    ],
)  # fmt: skip
def test_modules_and_functions_are_keys_too(name, key, capsys):
    """What is imported can be shown under its own name."""
    assert cli.main(["show", name]) == cli.main(["show", key]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[: len(lines) // 2] == lines[len(lines) // 2 :]


@pytest.mark.parametrize(
    "arguments",
    [[], ["derive"], ["build", "--jobs", "0"], ["build", "--jobs", "two"], ["show"], ["show", "cone", "--as", "html"]],
    ids=" ".join,
)
def test_bad_command_lines_end_with_code_2(arguments, capsys):
    with pytest.raises(SystemExit) as stopped:
        cli.main(arguments)
    assert stopped.value.code == 2
    assert "usage: axicontact" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ([], "build,list,show,check,verify,derive,emit,study"),
        (["derive", "-r**2"], "-- EXPRESSION"),
        (["build", "--only", ","], "',' names no profile; write cone,sphere"),
        (["check", "cone", "--digits", "1"], "'1' is below 10 digits"),
    ],
)
def test_a_bad_command_line_is_told_what_to_write(arguments, message, capsys):
    """An empty --only would build everything, a check of one digit would pass with none."""
    with pytest.raises(SystemExit):
        cli.main(arguments)
    assert message in capsys.readouterr().err


def test_list_and_show_load_nothing_heavy():
    code = """
import sys
from axiderive.cli import main
main(sys.argv[1:])
print(sorted({"sympy", "numpy", "mpmath", "jinja2"} & set(sys.modules)))
"""
    for arguments in (["list"], ["show", "cone.p"]):
        done = subprocess.run([sys.executable, "-c", code, *arguments], capture_output=True, text=True, check=True)
        assert done.stdout.endswith("\n[]\n")


def test_a_reader_that_goes_away_is_no_error():
    done = subprocess.run(
        f"{sys.executable} -m axiderive.cli show rounded_punch --as json | head -1",
        shell=True, capture_output=True, text=True, check=True,
    )  # fmt: skip
    assert done.stderr == ""


def test_the_index_is_short_and_reads_back_whole():
    """An entry to a line; what its key, its symbol and its quantity tell is left out, an exception is kept."""
    whole = index.load().data
    text = index.dumps(whole)
    assert len(text.encode()) < 1.1e3 * len(whole["entries"])
    assert index.loads(text) == whole
    for row in whole["entries"][:50]:
        assert sum(line.startswith(f'{{"key":"{row["key"]}",') for line in text.splitlines()) == 1
    first = whole["entries"][0]
    told = {"problem", "profile", "physics", "quantity", "unit", "function", "label", "symbol", "status", "definition"}
    assert not told & set(json.loads(text)["entries"][0])
    for name, value in (("unit", "kN"), ("note", "mind the gap"), ("quantity", "q"), ("label", "Odd"), ("symbol", "q")):
        odd = {**whole, "entries": [{**first, name: value}, *whole["entries"][1:]]}
        assert index.loads(index.dumps(odd)) == odd


@pytest.mark.parametrize("text", ["[]", "{}", "{", '{"profiles": [], "units": [], "entries": [{}]}'])
def test_a_damaged_index_is_no_index(text):
    with pytest.raises(ValueError, match="not an index|Expecting"):
        index.loads(text)


def test_without_a_catalogue_the_next_step_is_named(monkeypatch, tmp_path, capsys):
    monkeypatch.setattr(index, "find_spec", lambda name: None)
    monkeypatch.setattr(index, "__file__", str(tmp_path / "a" / "b" / "c" / "index.py"))
    assert cli.main(["list"]) == 3
    assert capsys.readouterr().err == "axicontact: there is no catalogue yet; run axicontact build\n"
