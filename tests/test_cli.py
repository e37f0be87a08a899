"""The command line: exit codes, messages, what is printed."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from axiderive import cli, commands, index, pdf, pool, work
from axiderive.build import Failure
from axiderive.progress import failure_lines
from axiderive.show import shown

ROOT = Path(__file__).parents[1]


def axicontact(*arguments, **options):
    """The command in a process of its own, as a user runs it."""
    command = [sys.executable, "-m", "axiderive.cli", *arguments]
    return subprocess.run(command, capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=300, **options)


def test_every_profile_is_listed(capsys):
    from axiderive.contact.systems import profile_ids

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
        (["show", "zzzzzz"], "unknown profile or key 'zzzzzz'; see axicontact list"),
        (["check", "paraboloyd"], "unknown profile or key 'paraboloyd'; did you mean 'paraboloid'?"),
        (["build", "--only", "cone,spere"], "unknown profile 'spere'; did you mean 'sphere'?"),
    ],
)
def test_unknown_names_end_with_code_2_and_the_nearest_name(arguments, message, capsys):
    assert cli.main(arguments) == 2
    assert capsys.readouterr().err == f"axicontact: {message}\n"


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


def test_list_and_show_load_nothing_heavy():
    code = """
import sys
from axiderive.cli import main
main(sys.argv[1:])
print(sorted({"sympy", "numpy", "mpmath", "jinja2", "rich"} & set(sys.modules)))
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
    """An entry to a line; what its key and its symbol tell is left out, an exception is kept."""
    whole = index.load().data
    text = index.dumps(whole)
    assert len(text.encode()) < 1.5e6
    assert index.loads(text) == whole
    for row in whole["entries"][:50]:
        assert sum(line.startswith(f'{{"key":"{row["key"]}",') for line in text.splitlines()) == 1
    first = whole["entries"][0]
    assert not {"problem", "profile", "physics", "quantity", "unit"} & set(json.loads(text)["entries"][0])
    for name, value in (("unit", "kN"), ("note", "mind the gap"), ("quantity", "q")):
        odd = {**whole, "entries": [{**first, name: value}, *whole["entries"][1:]]}
        assert index.loads(index.dumps(odd)) == odd


@pytest.mark.parametrize("text", ["[]", "{}", "{", '{"profiles": [], "units": [], "entries": [{}]}'])
def test_a_damaged_index_is_no_index(text):
    with pytest.raises(ValueError, match="not an index|Expecting"):
        index.loads(text)


def test_without_a_catalogue_the_next_step_is_named(monkeypatch, tmp_path, capsys):
    monkeypatch.setattr(index, "find_spec", lambda name: None)
    monkeypatch.setattr(index, "__file__", str(tmp_path / "a" / "b" / "index.py"))
    assert cli.main(["list"]) == 3
    assert capsys.readouterr().err == "axicontact: there is no catalogue yet; run axicontact build\n"


@pytest.fixture
def elsewhere(tmp_path, monkeypatch):
    """Builds of this test have a cache and a catalogue of their own."""
    monkeypatch.setattr(commands, "project_root", lambda: tmp_path)
    return tmp_path


# prescribed pressures are a fifth of a second each; every kind of problem is built by the same code
SMALL = ["build", "--only", "loads.uniform", "--no-pdf", "--jobs", "1", "--points", "4"]
TWO = ["build", "--only", "loads.uniform,loads.hertzian", "--no-pdf", "--jobs", "1", "--points", "4"]


def _bytes(root):
    return {path.relative_to(root): path.read_bytes() for path in sorted(root.rglob("*")) if path.is_file()}


def test_build_writes_a_catalogue_and_then_changes_nothing(elsewhere, capsys):
    assert cli.main(SMALL) == 0
    said = capsys.readouterr().err
    assert re.search(r"^loads\.uniform +\d+ +\d+", said, flags=re.M)
    assert "next   axicontact show loads.uniform" in said
    first = _bytes(elsewhere / "catalogue")
    assert Path("axicontact/loads/uniform.py") in first
    assert Path("evidence/loads.uniform.json") in first
    assert not [path for path in first if "tmp" in path.name or ".staging" in str(path)]
    assert cli.main(SMALL) == 0
    assert " 0 files changed, 0 removed" in capsys.readouterr().err
    assert cli.main([*SMALL, "--fresh"]) == 0
    assert _bytes(elsewhere / "catalogue") == first
    assert cli.main([*SMALL, "--check"]) == 0
    module = elsewhere / "catalogue/axicontact/loads/uniform.py"
    module.write_text("# mine\n")
    assert cli.main([*SMALL, "--check"]) == 1
    assert "-# mine\n" in capsys.readouterr().out
    assert module.read_text() == "# mine\n"


def test_a_problem_with_a_failed_check_is_left_out_and_listed(elsewhere, monkeypatch, capsys):
    from axiderive import verification

    genuine = verification.verify

    def verify(problem, entries, settings):
        found = genuine(problem, entries, settings)
        wrong = problem.key == "loads.uniform"
        failures = [{"key": "loads.uniform.w", "message": "got 1.0, wanted 2.0"}] if wrong else []
        return {**found, "failures": failures}

    monkeypatch.setattr(verification, "verify", verify)
    assert cli.main(TWO) == 1
    said = capsys.readouterr().err
    assert "loads.uniform.w: got 1.0, wanted 2.0\n    again: axicontact check loads.uniform.w --seed 17 -v" in said
    assert said.rstrip().endswith("left out of the catalogue: loads.uniform")
    assert not (elsewhere / "catalogue/axicontact/loads/uniform.py").exists()
    index_file = elsewhere / "catalogue/axicontact/index.json"
    assert [row["name"] for row in json.loads(index_file.read_text())["profiles"]] == ["loads.hertzian"]


def test_what_rests_on_a_problem_that_is_left_out_is_left_out_too():
    """The adhesive module calls the normal one; the plane problem of the same name rests on nothing."""
    from axiderive.build import _publishable
    from axiderive.contact.systems import problems

    wanted = list(problems(["cone", "plane.wedge"]))
    failed = {"failures": [{"key": "cone.p", "message": "wrong"}]}
    found = {p.key: work.Outcome(p.key, {}, failed if p.key == "cone" else {}, 0.0) for p in wanted}
    published, failures = _publishable(wanted, found)
    assert [problem.key for problem, _ in published] == ["cone.fgm", "cone.fgm.adh", "cone.fgm.tan", "plane.wedge"]
    assert [failure.key for failure in failures] == ["cone.p", "cone.adh", "cone.tan", "cone.vis"]


def test_a_defect_in_one_problem_does_not_take_the_others(elsewhere, monkeypatch, capsys):
    from axiderive.contact.systems import Problem

    genuine = Problem.derive

    def derive(problem):
        if problem.key == "loads.hertzian":
            message = "no atoms"
            raise ValueError(message)
        return genuine(problem)

    monkeypatch.setattr(Problem, "derive", derive)
    assert cli.main(TWO) == 1
    assert "loads.hertzian: ValueError: no atoms" in capsys.readouterr().err
    assert (elsewhere / "catalogue/axicontact/loads/uniform.py").exists()
    assert cli.main([*TWO, "--only", "loads.hertzian"]) == 1
    assert "nothing to publish" in capsys.readouterr().err
    assert (elsewhere / "catalogue/axicontact/loads/uniform.py").exists()


def test_an_unwritable_folder_is_named_before_any_work(elsewhere, monkeypatch, capsys):
    monkeypatch.setattr(work, "task", None)
    (elsewhere / "file").write_text("")
    assert cli.main([*SMALL, "--out", str(elsewhere / "file" / "catalogue")]) == 3
    assert re.match(
        r"axicontact: cannot write a catalogue to .*/file/catalogue: Not a directory; .*--out", capsys.readouterr().err
    )


def test_interruption_ends_with_code_130_and_keeps_finished_work(elsewhere, monkeypatch, capsys):
    def interrupted(function, tasks, jobs):
        yield function(*tasks[0])
        raise KeyboardInterrupt

    monkeypatch.setattr(pool, "run", interrupted)
    arguments = TWO
    assert cli.main(arguments) == 130
    assert "the same command continues" in capsys.readouterr().err
    assert not list((elsewhere / "catalogue").rglob("*.py"))
    finished = []

    def counted(function, tasks, jobs):
        finished.extend(tasks if function is work.task else [])
        return (function(*task) for task in tasks)

    monkeypatch.setattr(pool, "run", counted)
    assert cli.main(arguments) == 0
    assert len(finished) == 1


def test_check_verifies_a_stored_formula_and_sees_a_wrong_one(elsewhere, monkeypatch, capsys):
    assert cli.main(["check", "cone.F", "--points", "4"]) == 0
    assert re.search(r"^cone\.F +closed ", capsys.readouterr().out, flags=re.M)
    folder = elsewhere / "catalogue" / "evidence"
    folder.mkdir(parents=True)
    text = (ROOT / "catalogue/evidence/cone.json").read_text()
    record = json.loads(text)
    depth = record["entries"]["d"]["cases"][0]["expr"]
    depth["="] = f"Mul(Integer(2), {depth['=']})"
    (folder / "cone.json").write_text(json.dumps(record))
    monkeypatch.setattr(work, "project_root", lambda: elsewhere)
    assert cli.main(["check", "cone.d", "--points", "4"]) == 1
    assert "FAILED cone.d: " in capsys.readouterr().err


def test_failures_say_how_to_see_them_again():
    lines = failure_lines([Failure("cone.w", "a"), Failure("sphere", "b", "Traceback")], seed=3, verbose=True)
    assert lines == [
        "cone.w: a\n    again: axicontact check cone.w --seed 3 -v",
        "sphere: b\n    again: axicontact build --fresh --jobs 1 --only sphere -v",
        "Traceback",
        "left out of the catalogue: cone, sphere",
    ]


@pytest.mark.parametrize(("strict", "code"), [([], 0), (["--strict"], 4)])
def test_a_missing_pdf_is_an_error_only_if_asked(elsewhere, monkeypatch, capsys, strict, code):
    monkeypatch.setattr(pdf, "_has_latex", lambda: False)
    arguments = [argument for argument in SMALL if argument != "--no-pdf"]
    assert cli.main([*arguments, "--no-install", *strict]) == code
    assert "apt-get install --no-install-recommends" in capsys.readouterr().err
    assert not (elsewhere / "catalogue/handbook/handbook.pdf").exists()


@pytest.mark.slow
def test_jobs_and_hash_seed_do_not_change_a_byte(tmp_path):
    catalogues = []
    for jobs, seed in (("1", "1"), ("2", "2")):
        out = tmp_path / seed
        done = axicontact(
            *("build", "--only", "cone,rounded_punch,flat_punch", "--no-pdf", "--fresh"),
            *("--jobs", jobs, "--out", str(out)),
            env={**os.environ, "PYTHONHASHSEED": seed},
        )
        assert done.returncode == 0, done.stderr
        catalogues.append(_bytes(out))
    assert catalogues[0] == catalogues[1]
