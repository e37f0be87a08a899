"""A scene holds no parameter that its calls leave at one value, and nothing that such a value decides."""

from __future__ import annotations

import ast
import re

import pytest
from scenes import EXAMPLES, composed_from

from axiderive.scene.linker.binding import bind
from axiderive.scene.linker.library import Module, Program
from axiderive.scene.linker.linking import inline
from axiderive.scene.linker.written import function_head, function_text

RULE = '''
LENGTHS = (1.0, 2.0)


def rule(x, stop, width=1.0, lengths=LENGTHS, tip=None, smooth=False, least=0.0):
    """The rule.  Without `width` it is none of this.

    Up to `stop`.  A `tip` is said in two
    words.
    """
    longest = np.minimum((x + stop) / width, np.inf)
    # of the tip
    if tip is not None:
        longest = tip(longest)
    if not smooth:
        # twice
        longest = longest + 0.0 * least
        return longest if tip is None else tip
    return many(x, width=width) - lengths[0]


def many(x, width=1.0):
    def inner(y):
        return width * (y - 1.0)

    return inner(x) + x if width > 2.0 else inner(x) * width
'''


def texts(callers: str, rules: str = RULE, wanted: str = "own:f") -> dict[str, str]:
    """The functions by name, after what all calls of one agree on is bound to it."""
    names = ", ".join(node.name for node in ast.parse(rules).body if isinstance(node, ast.FunctionDef))
    modules = {"rules": Module("rules", rules), "own": Module("own", f"from .rules import {names}\n{callers}")}
    program = Program(modules, [wanted], frozenset())
    bind(program, frozenset(), frozenset())
    own = {key: key.partition(":")[2] for key in program.trees}
    return {
        own[key]: function_text(function_head(own[key], node, own), node, own)
        for key, node in program.functions.items()
    }  # fmt: skip


CHAIN = """
def chain(x, first=None, second=None, third=0.0):
    if first is not None:
        y = first
    elif second is not None:
        # of the second
        y = second
    elif third > 1.0:
        y = third
    else:
        y = x
    return y
"""


@pytest.mark.parametrize(
    ("call", "body"),
    [
        ("chain(x)", ["y = x", "return y"]),
        ("chain(x, x)", ["if first is not None:", "    y = first", "else:", "    y = x", "return y"]),
        (
            "chain(x, x, x)",
            ["if first is not None:", "    y = first",
             "elif second is not None:", "    # of the second", "    y = second", "else:", "    y = x", "return y"],
        ),
        ("chain(x, x, third=2.0)", ["if first is not None:", "    y = first", "else:", "    y = 2.0", "return y"]),
        (
            "chain(x, None, x)",
            ["if second is not None:", "    # of the second", "    y = second", "else:", "    y = x", "return y"],
        ),
        ("chain(x, third=2.0)", ["y = 2.0", "return y"]),
    ],
)  # fmt: skip
def test_a_chain_of_conditions_stays_one(call: str, body: list[str]) -> None:
    """An `elif` takes the place of what is decided before it, or becomes the `else` of what is not."""
    found = texts(f"def f(x):\n    return {call}\n", CHAIN)
    assert [line.removeprefix("    ") for line in found["chain"].splitlines()[1:]] == body


JOINED = """
def joined(x, first=None, second=0.0):
    if first is not None and x > 1.0:
        return first
    if second > 1.0 or x > 2.0:
        return second
    return x
"""


@pytest.mark.parametrize(
    ("call", "conditions"),
    [
        ("joined(x)", ["x > 2.0"]),
        ("joined(x, x)", ["first is not None and x > 1.0", "x > 2.0"]),
        ("joined(x, x, 2.0)", ["first is not None and x > 1.0"]),
        ("joined(x, None, x)", ["second > 1.0 or x > 2.0"]),
    ],
)
def test_of_joined_conditions_stays_what_is_not_known(call: str, conditions: list[str]) -> None:
    """A known part of `and` or `or` decides the whole or falls out."""
    found = texts(f"def f(x):\n    return {call}\n", JOINED)["joined"]
    assert re.findall("if (.*):", found) == conditions


def test_what_a_default_decides_is_decided():
    """The condition, its branch and its comment, the operation, the sentence; bodies keep all else as it was."""
    found = texts("def f(x):\n    return rule(x, 2.0, least=3.0)\n")
    assert found["f"] == "def f(x):\n    return rule(x, 2.0)"
    assert found["rule"] == (
        'def rule(x, stop):\n    """The rule.\n\n    Up to `stop`.\n    """\n'
        "    longest = np.minimum(x + stop, np.inf)\n"
        "    # twice\n    longest = longest + 0.0 * 3.0\n    return longest"
    )


def test_a_value_that_all_calls_pass_is_one_as_well():
    """Through another function too; the constant of a module keeps its name."""
    found = texts("def f(x):\n    return rule(x, 2.0, 1.0, smooth=True) + many(x)\n")
    assert "return many(x) - LENGTHS[0]" in found["rule"]
    assert "if" not in found["rule"]
    assert found["many"].endswith("return y - 1.0\n\n    return inner(x)")
    assert found["f"] == "def f(x):\n    return rule(x, 2.0) + many(x)"


@pytest.mark.parametrize(
    "caller",
    [
        "def f(x):\n    return many(x, 3.0) + many(x)\n",
        "def f(x):\n    return many(x, x) + many(x)\n",
        "def f(*x):\n    return many(*x)\n",
        "def f(x):\n    return x(many) + many(x)\n",
    ],
    ids=["two values", "no constant", "unpacked", "handed on"],
)
def test_what_is_not_one_value_stays(caller):
    assert texts(caller)["many"] == RULE[RULE.index("def many") :].strip()


def test_a_default_that_no_call_leaves_to_stand_goes():
    """What is behind one that stays has to keep its own."""
    assert texts("def f(x):\n    return many(x, x)\n")["many"].startswith("def many(x, width):\n")
    found = texts("def f(x):\n    return rule(x, 2.0, x, x, x, x, x) + rule(x, 2.0, x, tip=x)\n")["rule"]
    assert found.startswith("def rule(x, stop, width, lengths=LENGTHS, tip=None, smooth=False, least=0.0):\n")


def test_what_is_asked_of_the_scene_stays():
    assert texts("", wanted="rules:many")["many"] == RULE[RULE.index("def many") :].strip()


@pytest.mark.parametrize("path", sorted(EXAMPLES.glob("*.toml")), ids=lambda path: path.stem)
def test_every_default_of_an_example_is_used_and_left(path):
    """With the inverses of a rounded punch: none but what is said where it is called, and no constant without use."""
    source = re.sub(r"(?s)\[want\].*", "", path.read_text())
    module = next(t.decode() for n, t in composed_from(source).files.items() if n.endswith(".py") and "test_" not in n)
    tree = ast.parse(module)
    calls = [node for node in ast.walk(tree) if isinstance(node, ast.Call)]
    for function in (node for node in tree.body if isinstance(node, ast.FunctionDef) and node.name.startswith("_")):
        own = [call for call in calls if ast.unparse(call.func) == function.name]
        names = [arg.arg for arg in function.args.args]
        for name in names[len(names) - len(function.args.defaults) :]:
            said = [len(c.args) > names.index(name) or name in {k.arg for k in c.keywords} for c in own]
            assert not own or (any(said) and not all(said)), (function.name, name)
    used = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load)}
    constants = {node.targets[0].id for node in tree.body if isinstance(node, ast.Assign)}
    assert constants <= used, constants - used


@pytest.mark.parametrize(
    ("value", "written"),
    [
        ("twice(x)", True),
        ("twice(x) + 1.0", True),
        ("[twice(y) for y in x]", False),
        ("{twice(y) for y in x}", False),
        ("{twice(y): y for y in x}", False),
        ("tuple(twice(y) for y in x)", False),
        ("map(lambda y: twice(y), x)", False),
        ("twice(x) if x > 0.0 else x", False),
    ],
)
def test_lines_are_written_out_where_their_names_are_known(value, written):
    """Not before a statement inside of which an argument gets its value, or in which the call may be left out."""
    rules = f"def twice(y):\n    z = np.sqrt(y) * {' * '.join(['y'] * 30)}\n    return z + z\n"
    modules = {"own": Module("own", f"{rules}\n\ndef f(x):\n    return {value}\n")}
    program = Program(modules, ["own:f"], frozenset())
    inline(program, frozenset())
    assert ("own:twice" not in program.functions) == written
