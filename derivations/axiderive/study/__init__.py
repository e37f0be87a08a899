"""Comparisons that are not part of a build: `axicontact study corpus | error | speed | languages | maps | extremes`."""

from __future__ import annotations

import argparse
from collections.abc import Callable, Sequence

LIMIT = 60.0
TOPICS = {
    "corpus": "63 Abel integrals of contact mechanics: the engine beside SymPy's integrate",
    "error": "error against run time of p(r), F(d), w(r): the emitted functions beside other methods",
    "speed": "what a call costs: the emitted functions beside `math`, lambdify and a mere copy",
    "languages": "what a call costs in C: the functions as C99 beside those of the package",
    "maps": "stability maps: worst error over the dimensionless ratios, emitted beside naive",
    "extremes": "stiff and extreme cases: emitted beside naive at the ends of the ranges",
}
"""What is compared, each in the module of its name."""


def add_commands(
    commands: argparse._SubParsersAction[argparse.ArgumentParser], executor: Callable[[argparse.ArgumentParser], None]
) -> None:
    """Add `study` and its topics, with the option of an executor; nothing heavy is imported before one runs."""
    study = commands.add_parser("study", help="comparisons: the engine and its functions beside other ways")
    study.set_defaults(run="study:topics")
    topics = study.add_subparsers(metavar="topic")
    for topic, text in TOPICS.items():
        parser = topics.add_parser(topic, help=text)
        parser.set_defaults(run="study:measure", topic=topic)
        executor(parser)
        if topic == "corpus":
            parser.set_defaults(run="study:solve_corpus")
            parser.add_argument("ids", nargs="*", metavar="ID", help="cone_p, say; default all")
            parser.add_argument("--sympy", action="store_true", help="run SymPy's integrate beside")
            limit = "of the processor for each (%(default)g)"
            parser.add_argument("--limit", type=_seconds, default=LIMIT, metavar="SECONDS", help=limit)
            continue
        parser.add_argument("--only", type=_problems, default=[], metavar="A,B", help="these problems only")
        parser.add_argument("--quick", action="store_true", help="few points and settings")
        parser.add_argument("--json", action="store_true", help="for programs")
        parser.add_argument("--write", action="store_true", help="keep the record in catalogue/evidence/study")


def _seconds(text: str) -> float:
    try:
        seconds = float(text)
    except ValueError:
        seconds = 0.0
    if not 0 < seconds < float("inf"):
        message = f"{text!r} is not a number of seconds above 0"
        raise argparse.ArgumentTypeError(message)
    return seconds


def _problems(text: str) -> list[str]:
    return [name.strip() for name in text.split(",") if name.strip()]


def topics(arguments: argparse.Namespace) -> int:
    """Say what can be compared; the exit code."""
    for name, text in TOPICS.items():
        print(f"axicontact study {name:9s} {text}")
    return 0


def solve_corpus(arguments: argparse.Namespace) -> int:
    """Solve the integrals of the corpus; the exit code."""
    from ..build.pool import workers
    from .corpus import compare

    with workers(arguments.executor, 1) as jobs:
        return compare(arguments.ids, sympy=arguments.sympy, limit=arguments.limit, jobs=jobs)


def measure(arguments: argparse.Namespace) -> int:
    """Print the record of a topic and, where asked for, keep it; what cannot be kept is refused before the work."""
    from importlib import import_module
    from importlib.util import find_spec

    from ..build.pool import workers
    from ..exits import ENVIRONMENT, USAGE, CommandError

    if find_spec("scipy") is None:
        message = "the other methods are SciPy's; pip install 'axicontact[test]'"
        raise CommandError(message, ENVIRONMENT)
    if arguments.write and (arguments.quick or arguments.only):
        message = "--write keeps whole records; leave out --quick and --only, or --write"
        raise CommandError(message, USAGE)
    from .report import store, to_json

    topic = import_module(f".{arguments.topic}", __package__)
    names = _names(arguments.only, topic.KNOWN)
    with workers(arguments.executor, 1) as jobs:
        record = topic.measure(names, quick=arguments.quick, jobs=jobs)
    print(to_json(record).rstrip() if arguments.json else topic.text(record))
    if arguments.write:
        path = store(record)
        if not arguments.json:
            print(f"wrote {path}")
    return 0


def _names(only: Sequence[str], known: Sequence[str]) -> Sequence[str]:
    """The problems asked for, of those that the study knows."""
    from ..store.index import nearest

    for name in only:
        if name not in known:
            raise nearest(name, "problem of the study", known)
    return only or known
