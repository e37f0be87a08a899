"""What a call costs in C: functions of the package as C99 beside themselves, at the numbers of their examples."""

from __future__ import annotations

import ast
import doctest
import inspect
import shutil
import statistics
import subprocess
import tempfile
from collections.abc import Iterator, Sequence
from functools import cache, partial
from importlib import import_module
from itertools import chain
from pathlib import Path
from typing import Any

import axicontact

from ..build.pool import Jobs, run
from ..exits import ENVIRONMENT, CommandError
from ..languages.reach import NoProgramError, Package
from ..languages.standalone import Asked, CFile
from .report import SHORTEST, Record, rounded, seconds, table

CATALOGUE = Path(axicontact.__file__).parent.parent
ROUNDS, ASKED = 5, 10.0
"""Timings of each, of which the shortest counts, and the ratio below which a function is listed."""
COMMAND = ("cc", "-std=c99", "-O2")
NOTE = (
    "Processor time of a call of the package with plain numbers over that of the same function as C99 (cc -O2), the "
    "shortest of several timings of each in one run, at the arguments of its example; both have seen them before."
)


@cache
def _package() -> Package:
    return Package({
        path.relative_to(CATALOGUE).as_posix(): path.read_text(encoding="utf-8")
        for path in (CATALOGUE / "axicontact").rglob("*.py")
    })  # fmt: skip


def _known() -> Iterator[str]:
    for path in sorted(_package().texts):
        parts = Path(path).with_suffix("").parts[1:]
        if len(parts) > 1 and not any(part.startswith("_") for part in parts):
            yield ".".join(parts)


KNOWN = tuple(_known())
"""Modules of the package."""


def measure(names: Sequence[str] = KNOWN, *, quick: bool = False, jobs: Jobs = 1) -> Record:
    """The record of the study.

    Raises
    ------
    CommandError
        If there is no C compiler.
    """
    if shutil.which(COMMAND[0]) is None:
        message = f"no {COMMAND[0]}; install a C compiler: apt-get install gcc libc6-dev"
        raise CommandError(message, ENVIRONMENT)
    rounds = 1 if quick else ROUNDS
    found = run(_rows, [(name, rounds) for name in names], jobs, ordered=True)
    rows = list(chain.from_iterable(found))
    return {"study": "languages", "note": NOTE, "settings": {"rounds": rounds}, "rows": rows}


def _rows(name: str, rounds: int) -> list[Record]:
    module, file, calls = import_module(f"axicontact.{name}"), CFile(_package()), list[tuple[str, str]]()
    timed = []
    for own in module.__all__:
        found = example(getattr(module, own))
        if found is None:
            continue
        signature = inspect.signature(getattr(module, own))
        parts = getattr(getattr(module, signature.return_annotation, None), "_fields", ("",))
        known = {key: value for key, value in found.items() if isinstance(value, str | tuple)}
        known |= {"control": "force"} if "control" in signature.parameters else {}
        asked = Asked(own, name, own, known, "", parts[0])
        try:
            file.add(asked)
        except NoProgramError:
            continue
        calls.append((own, ", ".join(repr(float(found[one])) for one in asked.arguments(_package()))))
        timed.append(_in_python(partial(getattr(module, own), **found), rounds))
    there = _in_c(file.text(name), calls, rounds) if calls else []
    return [{"function": f"{name}.{own}", "ratio": rounded(here / other), "nanoseconds": rounded(1e9 * other)}
            for (own, _), here, other in zip(calls, timed, there, strict=True)]  # fmt: skip


def example(function: Any) -> dict[str, Any] | None:
    """The arguments by name of the first call of a function in its docstring; None where there is none."""
    for one in doctest.DocTestParser().get_examples(function.__doc__ or ""):
        for node in ast.walk(ast.parse(one.source)):
            if isinstance(node, ast.Call) and ast.unparse(node.func).rpartition(".")[2] == function.__name__:
                try:
                    given = [ast.literal_eval(value) for value in node.args]
                    named = {str(own.arg): ast.literal_eval(own.value) for own in node.keywords}
                except ValueError:
                    return None
                return dict(inspect.signature(function).bind(*given, **named).arguments)
    return None


def _in_python(call: partial[Any], rounds: int) -> float:
    call()
    repeats = max(1, int(SHORTEST / max(seconds(call), 1e-7)))
    return min(seconds(call, repeats) for _ in range(rounds))


def _in_c(text: str, calls: Sequence[tuple[str, str]], rounds: int) -> list[float]:
    """Seconds of each call; its arguments are volatile, or it would be worked out by the compiler."""
    each = []
    for own, given in calls:
        values = f"volatile double x[] = {{{given or 0.0}}};"
        count = given.count(",") + 1 if given else 0
        each.append(f"{{ {values} (void)x; TIMED({own}({', '.join(f'x[{place}]' for place in range(count))})) }}")
    main = f"""
#include <stdio.h>
#include <time.h>
#define TIMED(call) {{ double best = 1e9, sum = 0.0, last; long n = 1, i; int done = 0; while (done < {rounds}) {{ \\
  clock_t start = clock(); for (i = 0; i < n; i++) sum += call; last = (double)(clock() - start) / CLOCKS_PER_SEC; \\
  if (last < {SHORTEST!r}) n *= 2; else {{ done++; if (last / n < best) best = last / n; }} }} \\
  printf("%.9g %g\\n", best, sum); }}
int main(void) {{
{chr(10).join(each)}
return 0; }}
"""
    with tempfile.TemporaryDirectory(prefix="axicontact-c-") as folder:
        source, program = Path(folder) / f"program.{CFile.suffix}", Path(folder) / "program"
        source.write_text(text + main, encoding="utf-8")
        subprocess.run([*COMMAND, str(source), "-lm", "-o", str(program)], check=True)
        told = subprocess.run([str(program)], capture_output=True, text=True, check=True).stdout
    return [float(line.split()[0]) for line in told.splitlines()]


def text(record: Record) -> str:
    """The median, and the functions below what is asked."""
    rows = sorted(record["rows"], key=lambda row: row["ratio"])
    below = [row for row in rows if row["ratio"] < ASKED]
    median = statistics.median(row["ratio"] for row in rows)
    head = f"{len(rows)} functions: C is {median:.3g} times faster in the median, {len(below)} below {ASKED:g}"
    cells = [(row["function"], row["ratio"], row["nanoseconds"]) for row in below]
    return "\n".join([head, table(("function", "Python/C", "ns in C"), cells)] if below else [head])
