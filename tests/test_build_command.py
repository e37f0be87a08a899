"""The command build: what is written, what is left out and said, interruption, and the same bytes again."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from axiderive import cli
from axiderive.build import pdf, pool, work
from axiderive.build.catalogue import Failure
from axiderive.build.comparison import LONGEST
from axiderive.commands import build
from axiderive.commands.build import failure_lines

ROOT = Path(__file__).parents[1]


# prescribed pressures are a fifth of a second each; every kind of problem is built by the same code
QUICK = ["build", "--no-pdf", "--jobs", "1", "--points", "4", "--digits", "20"]
SMALL = [*QUICK, "--only", "loads.uniform"]
TWO = [*SMALL, "--only", "loads.hertzian"]


@pytest.fixture
def empty(tmp_path, monkeypatch):
    """Builds of this test have a cache and a catalogue of their own."""
    monkeypatch.setattr(build, "project_root", lambda: tmp_path)
    return tmp_path


@pytest.fixture(scope="module")
def built(tmp_path_factory):
    """A folder where the uniform pressure has been built."""
    folder = tmp_path_factory.mktemp("built")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(build, "project_root", lambda: folder)
        assert cli.main(SMALL) == 0
    return folder


@pytest.fixture
def elsewhere(built, empty):
    """The same, with what a build of the uniform pressure has left in the cache."""
    shutil.copytree(built / ".cache", empty / ".cache")
    return empty


def _bytes(root):
    return {path.relative_to(root): path.read_bytes() for path in sorted(root.rglob("*")) if path.is_file()}


def test_build_writes_a_catalogue_and_then_changes_nothing(empty, capsys):
    assert cli.main(SMALL) == 0
    said = capsys.readouterr().err
    assert re.search(r"^loads\.uniform +\d+ +\d+", said, flags=re.M)
    assert "next   axicontact show loads.uniform" in said
    first = _bytes(empty / "catalogue")
    assert Path("axicontact/loads/uniform.py") in first
    assert Path("evidence/loads.uniform.json") in first
    assert not [path for path in first if "tmp" in path.name or ".staging" in str(path)]
    assert cli.main(SMALL) == 0
    assert " 0 files changed, 0 removed" in capsys.readouterr().err
    assert cli.main([*SMALL, "--fresh"]) == 0
    assert _bytes(empty / "catalogue") == first
    assert cli.main([*SMALL, "--check"]) == 0
    module = empty / "catalogue/axicontact/loads/uniform.py"
    module.write_text("# mine\n")
    assert cli.main([*SMALL, "--check"]) == 1
    said = capsys.readouterr()
    assert "-# mine\n" in said.out
    assert said.out.endswith("lines of difference: with -v\n")
    assert len(said.out.splitlines()) <= LONGEST + 2
    assert "1 file differs; run axicontact build --only loads.uniform and commit the result" in said.err
    assert module.read_text() == "# mine\n"
    # a folder without a catalogue once cost two hundred lines of what is missing, and none that all of it is
    nowhere = empty / "nowhere"
    assert cli.main([*SMALL, "--check", "--out", str(nowhere)]) == 1
    said = capsys.readouterr()
    assert said.out == ""
    line = next(line for line in said.err.splitlines() if line.startswith("axicontact: "))
    assert f"no catalogue in {nowhere}: all {len(first)} files that a build writes are missing; " in line
    assert line.endswith(f"run axicontact build --only loads.uniform --out {nowhere} to write them")
    assert not nowhere.exists()


def test_a_page_made_alone_has_its_number_of_the_whole_book(elsewhere, capsys):
    assert cli.main(TWO) == 0
    assert cli.main([*QUICK, "--only", "loads.hertzian", "--check"]) == 0, capsys.readouterr().out
    pages = [path.read_text() for path in sorted((elsewhere / "catalogue/handbook/profiles").glob("*.tex"))]
    assert sorted(re.search(r"entryhead\{(\S+?)\}", page)[1] for page in pages) == ["3.1", "3.2"]


def test_a_problem_with_a_failed_check_is_left_out_and_listed(elsewhere, monkeypatch, capsys):
    from axiderive.build import verification

    genuine = verification.verify

    def verify(problem, entries, settings, kept):
        found = genuine(problem, entries, settings, kept)
        wrong = problem.key == "loads.hertzian"
        failures = [{"key": "loads.hertzian.w", "message": "got 1.0, wanted 2.0"}] if wrong else []
        return {**found, "failures": failures}

    monkeypatch.setattr(verification, "verify", verify)
    assert cli.main(TWO) == 1
    said = capsys.readouterr().err
    assert "loads.hertzian.w: got 1.0, wanted 2.0\n    again: axicontact check loads.hertzian.w --seed 17 -v" in said
    assert said.rstrip().endswith("left out of the catalogue: loads.hertzian")
    assert not (elsewhere / "catalogue/axicontact/loads/hertzian.py").exists()
    index_file = elsewhere / "catalogue/axicontact/index.json"
    assert [row["name"] for row in json.loads(index_file.read_text())["profiles"]] == ["loads.uniform"]


def test_what_rests_on_a_problem_that_is_left_out_is_left_out_too():
    """The adhesive module calls the normal one; the plane problem of the same name rests on nothing."""
    from axiderive.build.catalogue import _publishable
    from axiderive.physics.systems import problems

    wanted = list(problems(["cone", "plane.wedge"]))
    failed = {"failures": [{"key": "cone.p", "message": "wrong"}]}
    found = {p.key: work.Outcome(p.key, {}, failed if p.key == "cone" else {}, 0.0) for p in wanted}
    published, failures = _publishable(wanted, found)
    assert [problem.key for problem, _ in published] == ["cone.fgm", "cone.fgm.adh", "cone.fgm.tan", "plane.wedge"]
    above = ["cone.adh", "cone.tan", "cone.vis", "cone.coh", "cone.sub", "cone.lay"]
    assert [failure.key for failure in failures] == ["cone.p", *above]


def test_a_defect_in_one_problem_does_not_take_the_others(elsewhere, monkeypatch, capsys):
    from axiderive.physics.systems import Problem

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
    assert cli.main([*QUICK, "--only", "loads.hertzian"]) == 1
    assert "nothing to publish" in capsys.readouterr().err
    assert (elsewhere / "catalogue/axicontact/loads/uniform.py").exists()


def test_an_unwritable_folder_is_named_before_any_work(elsewhere, monkeypatch, capsys):
    monkeypatch.setattr(work, "task", None)
    (elsewhere / "file").write_text("")
    assert cli.main([*SMALL, "--out", str(elsewhere / "file" / "catalogue")]) == 3
    assert re.match(
        r"axicontact: cannot write a catalogue to .*/file/catalogue: Not a directory; .*--out", capsys.readouterr().err
    )


def test_interruption_ends_with_code_130_and_keeps_finished_work(empty, monkeypatch, capsys):
    def interrupted(function, tasks, jobs):
        yield function(*tasks[0])
        raise KeyboardInterrupt

    monkeypatch.setattr(pool, "run", interrupted)
    arguments = TWO
    assert cli.main(arguments) == 130
    assert "the same command continues" in capsys.readouterr().err
    assert not list((empty / "catalogue").rglob("*.py"))
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
    monkeypatch.setattr("axiderive.commands.check.project_root", lambda: elsewhere)
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


def test_a_missing_pdf_is_an_error_only_if_asked(elsewhere, monkeypatch, capsys):
    monkeypatch.setattr(pdf, "has_latex", lambda: False)
    arguments = [argument for argument in SMALL if argument != "--no-pdf"]
    for strict, code in (([], 0), (["--strict"], 4)):
        assert cli.main([*arguments, "--no-install", *strict]) == code
        assert "apt-get install --no-install-recommends" in capsys.readouterr().err
        assert not (elsewhere / "catalogue/handbook/handbook.pdf").exists()


ELSEWHERE = """
import sys
from pathlib import Path
from axiderive import cli
from axiderive.commands import build
build.project_root = lambda: Path(sys.argv[1])
sys.exit(cli.main(sys.argv[2:]))
"""
"""The command with a cache of its own."""


@pytest.mark.slow
def test_one_process_and_another_hash_seed_write_the_same_catalogue(tmp_path):
    """Modules, book and web edition of every kind of contact, derived anew; that of all others is made in `.ci/run`."""
    command = [sys.executable, "-c", ELSEWHERE, str(tmp_path), "build", "--check", "--no-pdf", "--jobs", "1"]
    profiles = "cone,flat_punch,plane.rounded_wedge,loads.power"
    done = subprocess.run(
        [*command, "--out", str(ROOT / "catalogue"), "--only", profiles],
        env={**os.environ, "PYTHONHASHSEED": "1"}, capture_output=True, text=True, stdin=subprocess.DEVNULL,
        timeout=600, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stdout + done.stderr
