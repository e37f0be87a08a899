"""Comparisons that are not part of a build: `axicontact study corpus | error | speed | maps | extremes | forms`."""

from __future__ import annotations

import argparse
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .report import Record

LIMIT = 60.0
SEED = 17
TOPICS = {
    "corpus": "63 Abel integrals of contact mechanics: the engine beside SymPy's integrate",
    "error": "error against run time of p(r), F(d), w(r): the emitted functions beside other methods",
    "speed": "what a call costs: the emitted functions beside `math`, lambdify and a mere copy",
    "maps": "stability maps: worst error over the dimensionless ratios, emitted beside naive",
    "extremes": "stiff and extreme cases: emitted beside naive at the ends of the ranges",
    "forms": "the race of evaluation forms: whether another form than the frozen one keeps its digits and costs less",
}


def add_commands(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add `study` and its topics; nothing heavy is imported before one runs."""
    study = commands.add_parser("study", help="comparisons: the engine and its functions beside other ways")
    study.set_defaults(run=_topics)
    topics = study.add_subparsers(metavar="topic")
    parsers = {name: topics.add_parser(name, help=text) for name, text in TOPICS.items()}
    add_corpus_arguments(parsers["corpus"])
    for name, run in (
        ("corpus", _corpus),
        ("error", _error),
        ("speed", _speed),
        ("maps", _maps),
        ("extremes", _extremes),
        ("forms", _forms),
    ):
        parsers[name].set_defaults(run=run)
    for name in ("error", "speed", "maps", "forms"):
        parsers[name].add_argument("--only", type=_profiles, default=[], metavar="A,B", help="these problems only")
    parsers["maps"].add_argument("--seed", type=int, default=SEED, help="seed of the points (%(default)s)")
    for name in ("error", "speed", "maps", "extremes"):
        add_record_arguments(parsers[name])


def add_corpus_arguments(parser: argparse.ArgumentParser) -> None:
    """Adds the arguments of `axicontact study corpus` to its parser."""
    parser.add_argument("ids", nargs="*", metavar="ID", help="cone_p, say; default all")
    parser.add_argument("--sympy", action="store_true", help="run SymPy's integrate beside, in processes of its own")
    parser.add_argument(
        "--limit", type=_seconds, default=LIMIT, metavar="SECONDS", help="of the processor for each (%(default)g)"
    )


def add_record_arguments(parser: argparse.ArgumentParser) -> None:
    """Adds --quick, --json and --write to the parser of a study that keeps a record."""
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


def _profiles(text: str) -> list[str]:
    return [name.strip() for name in text.split(",") if name.strip()]


def _topics(arguments: argparse.Namespace) -> int:
    for name, text in TOPICS.items():
        print(f"axicontact study {name:9s} {text}")
    return 0


def _corpus(arguments: argparse.Namespace) -> int:
    from .corpus import compare

    return compare(arguments.ids, sympy=arguments.sympy, limit=arguments.limit)


def _error(arguments: argparse.Namespace) -> int:
    _ready(arguments)
    from . import error
    from .problems import EVERY

    return _finish(arguments, error.measure(_names(arguments, tuple(EVERY)), quick=arguments.quick), error.text)


def _speed(arguments: argparse.Namespace) -> int:
    _ready(arguments)
    from . import speed
    from .problems import NAMES

    return _finish(arguments, speed.measure(_names(arguments, NAMES), quick=arguments.quick), speed.text)


def _maps(arguments: argparse.Namespace) -> int:
    _ready(arguments)
    from . import maps
    from .problems import GRADED, NAMES

    record = maps.measure(_names(arguments, (*NAMES, GRADED)), seed=arguments.seed, quick=arguments.quick)
    return _finish(arguments, record, maps.text)


def _extremes(arguments: argparse.Namespace) -> int:
    _ready(arguments)
    from . import extremes

    return _finish(arguments, extremes.measure(quick=arguments.quick), extremes.text)


def _forms(arguments: argparse.Namespace) -> int:
    from . import forms

    print(forms.text(forms.measure(_names(arguments, forms.names()))))
    return 0


def _ready(arguments: argparse.Namespace) -> None:
    """Refuse before the work: SciPy is missing, or a part of a record would be kept."""
    from importlib.util import find_spec

    from ..exits import ENVIRONMENT, USAGE, CommandError

    if find_spec("scipy") is None:
        message = "the other methods are SciPy's; pip install 'axicontact[test]'"
        raise CommandError(message, ENVIRONMENT)
    if arguments.write and (arguments.quick or getattr(arguments, "only", [])):
        message = "--write keeps whole records; leave out --quick and --only, or --write"
        raise CommandError(message, USAGE)


def _names(arguments: argparse.Namespace, known: Sequence[str]) -> list[str]:
    """The problems asked for, of those that the study knows."""
    only: list[str] = arguments.only
    for name in only:
        if name not in known:
            from ..store.index import nearest

            raise nearest(name, "problem of the study", known)
    return only or list(known)


def _finish(arguments: argparse.Namespace, record: Record, text: Callable[[Record], str]) -> int:
    """Print the record and, where asked for, keep it."""
    from .report import store, to_json

    print(to_json(record).rstrip() if arguments.json else text(record))
    if arguments.write:
        path = store(record)
        if not arguments.json:
            print(f"wrote {path}")
    return 0
