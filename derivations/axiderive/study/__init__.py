"""Comparisons that are not part of a build."""

from __future__ import annotations

import argparse

LIMIT = 60.0


def add_commands(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add `study corpus`; nothing heavy is imported before it runs."""
    study = commands.add_parser("study", help="comparisons: the engine beside SymPy's integrate")
    topics = study.add_subparsers(required=True, metavar="topic")
    corpus = topics.add_parser("corpus", help="63 Abel integrals of contact mechanics")
    add_corpus_arguments(corpus)
    corpus.set_defaults(run=_corpus)


def add_corpus_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("ids", nargs="*", metavar="ID", help="cone_p, say; default all")
    parser.add_argument("--sympy", action="store_true", help="run SymPy's integrate beside, in processes of its own")
    parser.add_argument(
        "--limit", type=_seconds, default=LIMIT, metavar="SECONDS", help="of the processor for each (%(default)g)"
    )


def _seconds(text: str) -> float:
    try:
        seconds = float(text)
    except ValueError:
        seconds = 0.0
    if not 0 < seconds < float("inf"):
        message = f"{text!r} is not a number of seconds above 0"
        raise argparse.ArgumentTypeError(message)
    return seconds


def _corpus(arguments: argparse.Namespace) -> int:
    from .corpus import compare

    return compare(arguments.ids, sympy=arguments.sympy, limit=arguments.limit)
