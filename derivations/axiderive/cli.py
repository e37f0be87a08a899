"""The command `axicontact`: build, list, show, check, verify.

What runs a command is said as `module:function` and imported then: `list` and `show` answer from the stored index
without SymPy or NumPy.
"""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Sequence
from importlib import import_module
from pathlib import Path

from . import study
from .commands.show import FORMS, TOPICS
from .exits import ENVIRONMENT, INCOMPLETE, INTERRUPTED, CommandError

JOBS = min(os.cpu_count() or 1, 4)
LEAST_DIGITS = 10
"""With one, enclosures of the cone overlap to 0 digits and pass."""


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command line; returns the exit code."""
    arguments = _parser().parse_args(argv)
    module, _, command = arguments.run.partition(":")
    if module == "commands.scene":
        # SymPy, which is not loaded yet, keeps more than its last 1000 results: 10 % of a derivation
        os.environ.setdefault("SYMPY_CACHE_SIZE", "None")
    try:
        code: int = getattr(import_module(f".{module}", __package__), command)(arguments)
        sys.stdout.flush()
    except CommandError as error:
        print(f"axicontact: {error}", file=sys.stderr)
        return error.code
    except KeyboardInterrupt:
        print("\naxicontact: interrupted; finished profiles are kept, the same command continues", file=sys.stderr)
        return INTERRUPTED
    except BrokenPipeError:
        # the reader (head, less) has gone: nothing is left to say, not even at exit
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0
    except ImportError as error:
        print(
            f"axicontact: {error}; deriving needs more than NumPy: pip install '.[derive]' in the checkout",
            file=sys.stderr,
        )
        return ENVIRONMENT
    except OSError as error:
        print(f"axicontact: {error}", file=sys.stderr)
        return ENVIRONMENT
    return code


def _parser() -> argparse.ArgumentParser:
    from . import __version__

    parser = argparse.ArgumentParser(
        prog="axicontact", description="Closed forms of elastic contact: derived, proved, checked."
    )
    parser.add_argument("--version", action="version", version=f"axicontact {__version__}")
    commands = parser.add_subparsers(required=True, title="commands")

    build = commands.add_parser("build", help="derive, prove, check and write the catalogue")
    build.set_defaults(run="commands.build:build")
    build.add_argument("--only", type=_names, action="extend", default=[], metavar="A,B", help="these profiles only")
    _parallel(build)
    build.add_argument("--out", type=Path, metavar="DIR", help="folder of the catalogue (catalogue/ of the checkout)")
    build.add_argument("--no-pdf", action="store_true", help="leave the handbook as LaTeX")
    build.add_argument(
        "--fresh", action="store_true", help="repeat everything: take nothing from earlier builds or the catalogue"
    )
    build.add_argument(
        "--check", action="store_true", help="write nothing; fail with a diff if the catalogue would change"
    )
    build.add_argument("--no-install", action="store_true", help="never install LaTeX")
    build.add_argument("--strict", action="store_true", help=f"end with code {INCOMPLETE} if there is no PDF")
    build.add_argument("--quiet", action="store_true", help="say nothing but failures")
    _numerical(build)

    listing = commands.add_parser("list", help="what the catalogue holds")
    listing.set_defaults(run="commands.show:list_topic")
    listing.add_argument("topic", nargs="?", choices=TOPICS, default=TOPICS[0])
    listing.add_argument("--json", action="store_true", help="for programs")

    show = commands.add_parser("show", help="a profile or one of its formulas")
    show.set_defaults(run="commands.show:show")
    show.add_argument("key", help="cone, or cone.p")
    show.add_argument("--as", dest="form", choices=FORMS, default=FORMS[0])

    check = commands.add_parser("check", help="verify the stored formulas again, without deriving them")
    check.set_defaults(run="commands.check:check", jobs=JOBS)
    check.add_argument("keys", nargs="*", metavar="KEY", help="cone, or cone.p, or chapter; default all formulas")
    _numerical(check)

    verify = commands.add_parser("verify", help="prove the stored formulas again, by a program that wrote none of them")
    verify.set_defaults(run="commands.check:verify")
    verify.add_argument("keys", nargs="*", metavar="KEY", help="cone, or cone.p; default all formulas")

    derive = commands.add_parser(
        "derive",
        help="formulas and a module for a profile of your own",
        # without it argparse calls the expression missing that begins with a minus
        usage="%(prog)s [-h] [--out DIR] [--k K] (-- EXPRESSION | --from FILE [--jobs N | --executor M:C])",
    )
    derive.set_defaults(run="commands.scene:derive")
    either = derive.add_mutually_exclusive_group(required=True)
    either.add_argument(
        "expression", nargs="?", metavar="EXPRESSION", help="f(r), as 'r**2/(2*R) + c*r**4'; put -- before it"
    )
    either.add_argument("--from", dest="source", type=Path, metavar="FILE", help="many, one on a line")
    derive.add_argument("--out", type=Path, metavar="DIR", help="write the module and its test there")
    _parallel(derive)
    derive.add_argument("--k", default="0", metavar="K", help="exponent of a graded half-space (%(default)s)")

    emit = commands.add_parser("emit", help="a self-contained module for a scene")
    emit.set_defaults(run="commands.scene:emit")
    emit.add_argument("scene", type=Path, metavar="SCENE", help="a TOML file, see examples/")
    emit.add_argument("--out", type=Path, metavar="DIR", help="folder to write to, instead of that of the scene")
    emit.add_argument("--dry-run", action="store_true", help="say what would be written, with all defaults")

    study.add_commands(commands, _executor)
    return parser


def _numerical(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--digits", type=_digits, default=50, help="digits of the numerical checks (%(default)s)")
    parser.add_argument("--points", type=_positive, default=8, help="points per formula (%(default)s)")
    parser.add_argument("--seed", type=int, default=17, help="seed of the points (%(default)s)")
    parser.add_argument("-v", "--verbose", action="store_true", help="say more")


def _parallel(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--jobs", type=_positive, default=JOBS, metavar="N", help="processes (%(default)s)")
    _executor(parser)


def _executor(parser: argparse.ArgumentParser) -> None:
    said = "a callable that returns a concurrent.futures.Executor, which runs the work; docs/many_machines.md"
    parser.add_argument("--executor", default="", metavar="M:C", help=said)


def _positive(text: str) -> int:
    number = int(text) if text.isdecimal() else 0
    if number < 1:
        message = f"{text!r} is not a whole number above 0"
        raise argparse.ArgumentTypeError(message)
    return number


def _digits(text: str) -> int:
    number = _positive(text)
    if number < LEAST_DIGITS:
        message = f"{text!r} is below {LEAST_DIGITS} digits, with which any two numbers agree; leave it at 50"
        raise argparse.ArgumentTypeError(message)
    return number


def _names(text: str) -> list[str]:
    names = [name.strip() for name in text.split(",") if name.strip()]
    if not names:
        message = f"{text!r} names no profile; write cone,sphere, or leave the option out for all"
        raise argparse.ArgumentTypeError(message)
    return names


if __name__ == "__main__":
    raise SystemExit(main())
