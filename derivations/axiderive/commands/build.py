"""The command `axicontact build`: build the catalogue, write or compare it, make the PDF, and say what happened."""

from __future__ import annotations

import argparse
import hashlib
import json
import re
import sys
import time
from collections.abc import Collection, Mapping, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from pathlib import Path
from typing import Any

from ..book.evidence import with_tables
from ..build import pdf
from ..build.catalogue import Catalogue, Failure, study_records
from ..build.catalogue import build as build_catalogue
from ..build.comparison import Difference, book_of, differences, only_profiles, shortened, standing
from ..build.pool import workers
from ..build.work import Outcome, Settings, project_root
from ..exits import FAILED, INCOMPLETE, CommandError
from ..physics import systems
from ..store.cache import Cache, digest
from ..store.index import nearest, table
from ..store.sources import kept
from ..store.writing import RECEIPTS, ensure_writable, publish, stale_files, write_atomic

HEAD = ["profile", "formulas", "closed", "integral", "root", "certified", "worst residual", "time"]
MOST_REMARKS = 5


def build(arguments: argparse.Namespace) -> int:
    """The exit code, 0 if all went well; UnknownNameError for a profile that does not exist."""
    known = systems.profile_ids()
    for name in arguments.only:
        if name not in known:
            raise nearest(name, "profile", known)
    names = arguments.only or known
    root = arguments.out or project_root() / "catalogue"
    cache = Cache(project_root() / ".cache", arguments.fresh)
    settings = Settings(arguments.digits, arguments.points, arguments.seed)
    started = time.perf_counter()
    if not arguments.check:
        ensure_writable(root)
    partial = bool(arguments.only) and (root / "axicontact" / "index.json").exists()
    book = book_of(root, names) if partial else None
    keys = [problem.key for problem in systems.problems(names)]
    measured = standing(project_root() / "catalogue", keys) | standing(root, keys)
    ahead = Ahead(wanted=not (arguments.no_pdf or arguments.check or partial))
    progress = Progress(len(keys), quiet=arguments.quiet)
    with kept(cache), workers(arguments.executor, arguments.jobs) as jobs:
        catalogue = build_catalogue(
            names,
            cache=cache,
            settings=settings,
            standing=measured,
            book=book,
            jobs=jobs,
            report=progress.finished,
            printed=ahead.begin,
        )
    failures = failure_lines(catalogue.failures, seed=settings.seed, verbose=arguments.verbose)
    files = only_profiles(catalogue.files, names, root) if partial else catalogue.files
    progress.say(_summary(catalogue))
    progress.say(_taken_over(catalogue))
    worse = _worse_lines(catalogue)
    if worse:
        print("\n".join(worse), file=sys.stderr)
    if not any(path.startswith("evidence/") for path in catalogue.files):
        print("\n".join([*failures, f"nothing to publish, {root} is as it was"]), file=sys.stderr)
        return FAILED
    readme = {} if partial or root != project_root() / "catalogue" else _readme(catalogue)
    if arguments.check:
        stale = [] if partial else stale_files(files, root)
        results = {path: content for path, content in files.items() if path != RECEIPTS}
        found = differences(results, root, stale) + differences(readme, project_root())
        if any((root / path).is_file() for path in files):
            code = _compare(found, root, len(files), progress, arguments)
        else:
            code = _nothing_there(root, len(files), arguments)
        code = FAILED if worse else code
    else:
        written, removed = publish(files, root, prune=not partial)
        for path, content in readme.items():
            write_atomic(project_root() / path, content)
        code = _handbook(root, cache, arguments, progress, ahead)
        _report_written(catalogue, root, (len(written), len(removed)), time.perf_counter() - started, progress)
    if failures:
        print("\n".join(failures), file=sys.stderr)
        return FAILED
    return code


class Ahead:
    """The PDF of a whole book, set while the web edition is still made."""

    def __init__(self, *, wanted: bool) -> None:
        self.wanted = wanted
        self.sources: Mapping[str, bytes] = {}
        self.made: Future[tuple[bytes, list[str]]] | None = None

    def begin(self, sources: Mapping[str, bytes]) -> None:
        """Starts on these sources, where there is LaTeX."""
        if self.wanted and pdf.has_latex():
            self.sources = sources
            self.made = ThreadPoolExecutor(1).submit(pdf.compile_pdf, sources)

    def result(self, sources: Mapping[str, bytes]) -> tuple[bytes, list[str]]:
        """The PDF of the sources and LaTeX's remarks; made now if it was not begun, or on others."""
        if self.made is None or dict(sources) != dict(self.sources):
            return pdf.compile_pdf(sources)
        return self.made.result()


def _readme(catalogue: Catalogue) -> dict[str, bytes]:
    """The README with the tables of this catalogue, where a checkout has one."""
    path = project_root() / "README.md"
    if not path.is_file():
        return {}
    index = json.loads(catalogue.files["axicontact/index.json"])
    measured = study_records().get("error")
    return {path.name: with_tables(path.read_text(encoding="utf-8"), index["matrix"], measured).encode()}


def _compare(found: list[Difference], root: Path, count: int, progress: Progress, arguments: argparse.Namespace) -> int:
    if not found:
        progress.say(f"{root} is what a build writes ({count} files)")
        return 0
    lines = [line for one in found for line in one.lines]
    short = lines if arguments.verbose else shortened(found)
    print("\n".join(short if short == lines else [*short, f"all {len(lines)} lines of difference: with -v"]))
    differ = "1 file differs" if len(found) == 1 else f"{len(found)} files differ"
    print(
        f"axicontact: {root} is not what a build writes, {differ}; "
        f"run {_without_check(arguments)} and commit the result",
        file=sys.stderr,
    )
    return FAILED


def _nothing_there(root: Path, count: int, arguments: argparse.Namespace) -> int:
    print(
        f"axicontact: no catalogue in {root}: all {count} files that a build writes are missing; "
        f"run {_without_check(arguments)} to write them",
        file=sys.stderr,
    )
    return FAILED


def _without_check(arguments: argparse.Namespace) -> str:
    """The command that writes what was compared."""
    only = f" --only {','.join(arguments.only)}" if arguments.only else ""
    return f"axicontact build{only}" + (f" --out {arguments.out}" if arguments.out else "")


def _handbook(root: Path, cache: Cache, arguments: argparse.Namespace, progress: Progress, ahead: Ahead) -> int:
    """Make handbook.pdf unless it is there already, made from the same sources."""
    if arguments.no_pdf:
        return 0
    folder = root / "handbook"
    sources = {
        path.relative_to(folder).as_posix(): path.read_bytes()
        for path in sorted(folder.rglob("*"))
        if path.is_file() and path.suffix in pdf.SOURCES
    }
    target = folder / "handbook.pdf"
    key = digest(["pdf", {path: hashlib.sha256(content).hexdigest() for path, content in sources.items()}])
    made = cache.get(key)
    if made is not None and target.is_file() and hashlib.sha256(target.read_bytes()).hexdigest() == made:
        return 0
    try:
        pdf.ensure_latex(install=not arguments.no_install, say=progress.say)
        content, warnings = ahead.result(sources)
    except pdf.NoLatexError as error:
        progress.say(str(error))
        return INCOMPLETE if arguments.strict else 0
    except pdf.LatexError as error:
        message = f"the handbook does not compile, everything else is written\n{error}"
        raise CommandError(message) from error
    write_atomic(target, content)
    cache.put(key, hashlib.sha256(content).hexdigest())
    for warning in warnings if arguments.verbose else warnings[:MOST_REMARKS]:
        progress.say(f"handbook: {warning}")
    if len(warnings) > MOST_REMARKS and not arguments.verbose:
        progress.say(f"handbook: {len(warnings) - MOST_REMARKS} more remarks of LaTeX, shown with -v")
    return 0


def _report_written(
    catalogue: Catalogue, root: Path, counts: tuple[int, int], seconds: float, progress: Progress
) -> None:
    files = catalogue.files
    sources = [files[p.module] for p in systems.problems() if p.module in files]
    modules, functions = len(sources), sum(len(re.findall(rb"^def [a-z]", source, re.M)) for source in sources)
    evidence = sum(1 for path in files if path.startswith("evidence/"))
    book = "handbook.pdf" if (root / "handbook" / "handbook.pdf").exists() else "LaTeX only, no PDF"
    shown = root.relative_to(Path.cwd()) if root.is_relative_to(Path.cwd()) else root
    rows = [
        f"{shown}/axicontact  {modules} modules, {functions} functions (NumPy only)",
        f"{shown}/handbook    {book}",
        f"{shown}/evidence    {evidence} files",
    ]
    changed, removed = counts
    progress.say("\nwrote  " + "\n       ".join(rows))
    progress.say(f"       {changed} files changed, {removed} removed, {seconds:.1f} s in all")
    example = "rounded_punch.F"
    if "evidence/rounded_punch.json" not in files:
        first = next(outcome for outcome in catalogue.outcomes if f"evidence/{outcome.key}.json" in files)
        example = f"{first.key}.{next(iter(first.entries))}"
    progress.say(f"next   axicontact show {example.rpartition('.')[0]}    |    axicontact show {example} --as python")


class Progress:
    """Counts finished problems; `--quiet` says nothing but failures."""

    def __init__(self, total: int, *, quiet: bool) -> None:
        self.total, self.quiet, self.done = total, quiet, 0

    def finished(self, outcome: Outcome) -> None:
        """Counts one problem, and says a line of it unless it was cached."""
        self.done += 1
        if not outcome.cached:
            count = f"{self.done:>{len(str(self.total))}}/{self.total}"
            state = f"{len(outcome.entries):3} formulas" if not outcome.error else "failed"
            self.say(f"{count}  {outcome.key:28} {state}  {outcome.seconds:6.1f} s")

    def say(self, text: str) -> None:
        """Writes a line to standard error, unless the build is quiet."""
        if not self.quiet:
            print(text, file=sys.stderr, flush=True)


def _summary(catalogue: Catalogue) -> str:
    """The table of profiles, all physics together, with a line of totals."""
    rows: dict[str, list[Any]] = {}
    for outcome in catalogue.outcomes:
        if not outcome.error:
            name = systems.problem(outcome.key).profile_id
            rows[name] = _sum(name, [rows[name], _row(outcome)]) if name in rows else _row(outcome)
    if not rows:
        return ""
    cells = [HEAD, *([*map(str, row[:-1]), f"{row[-1]:.1f} s"] for row in [*rows.values(), _sum("all", rows.values())])]
    widths = [0, *(max(map(len, column)) for column in list(zip(*cells, strict=True))[1:])]
    return table([[cell.rjust(width) for cell, width in zip(row, widths, strict=True)] for row in cells])


def _taken_over(catalogue: Catalogue) -> str:
    """How much numerical evidence was not made anew."""
    checks, errors = catalogue.kept
    made = sum(not outcome.cached for outcome in catalogue.outcomes)
    derived = f"{made} of {len(catalogue.outcomes)} problems were derived and proved now"
    if made < len(catalogue.outcomes):
        derived += ", the others by an earlier build from the same inputs"
    if not checks and not errors:
        return derived
    return (
        f"{derived}; checks of {checks} and measured errors of {errors} are those of the catalogue, "
        "from the same inputs (--fresh repeats everything)"
    )


def _row(outcome: Outcome) -> list[Any]:
    statuses = [record["status"] for record in outcome.entries.values()]
    evidence = outcome.evidence.get("entries", {})
    certified = sum(1 for found in evidence.values() if found.get("certified"))
    worst = max((found["residual"] for found in evidence.values() if found.get("residual")), key=float, default="")
    counts = [statuses.count(status) for status in ("closed", "integral", "root")]
    name = systems.problem(outcome.key).profile_id
    return [name, len(statuses), *counts, certified, worst, outcome.seconds]


def _sum(name: str, rows: Collection[list[Any]]) -> list[Any]:
    totals = [sum(row[i] for row in rows) for i in range(1, 6)]
    worst = max((row[6] for row in rows if row[6]), key=float, default="")
    return [name, *totals, worst, sum(row[7] for row in rows)]


def failure_lines(failures: Sequence[Failure], *, seed: int, verbose: bool) -> list[str]:
    """Short: what failed, and how to see it again."""
    lines = []
    for failure in failures:
        again = f"axicontact check {failure.key} --seed {seed}"
        if failure.trace:
            name = systems.problem(failure.key).profile_id
            again = f"axicontact build --fresh --jobs 1 --only {name}"
        lines.append(f"{failure.key}: {failure.message}\n    again: {again} -v")
        if verbose and failure.trace:
            lines.append(failure.trace.rstrip())
    if lines:
        lines.append(f"left out of the catalogue: {', '.join(dict.fromkeys(map(_problem, failures)))}")
    return lines


def _worse_lines(catalogue: Catalogue) -> list[str]:
    """The functions whose measured errors have jumped, and what to do about them."""
    lines = [f"{key}: {sentence}" for key, sentence in catalogue.worse]
    if lines:
        key = catalogue.worse[0][0]
        lines.append(f"find the cause, or say in the commit why it stays; axicontact check {key} -v measures again")
    return lines


def _problem(failure: Failure) -> str:
    """Key of the problem that a failure keeps out: its own, or that of the formula that failed."""
    known = {problem.key for problem in systems.problems()}
    return failure.key if failure.key in known else failure.key.rpartition(".")[0]
