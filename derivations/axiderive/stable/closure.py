"""The part of the package that some modules rest on."""

from __future__ import annotations

import ast
from collections.abc import Iterator, Mapping
from pathlib import PurePosixPath


def closure(sources: Mapping[str, str], *modules: str) -> dict[str, str]:
    """The texts of modules, of all they import from the package, and of the packages around them.

    A package stands for its name alone, with an empty text, unless it is imported to ask it for one of its modules.
    """
    found: dict[str, str] = {}
    pending = list(modules)
    while pending:
        path = pending.pop()
        found[path] = sources[path]
        pending += [other for other in _imported(sources, path) if other not in found and other not in pending]
    packages = {f"{parent}/__init__.py" for path in found for parent in PurePosixPath(path).parents if parent.name}
    return dict(sorted({**dict.fromkeys(packages, ""), **found}.items()))


def _imported(sources: Mapping[str, str], path: str) -> Iterator[str]:
    tree = ast.parse(sources[path])
    asked = {
        (node.value.id, node.attr)
        for node in ast.walk(tree)
        if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name)
    }
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and node.level:
            folder = PurePosixPath(path).parents[node.level - 1]
            base = folder.joinpath(*(node.module or "").split(".")) if node.module else folder
            for target in (base, *(base / alias.name for alias in node.names)):
                if f"{target}.py" in sources:
                    yield f"{target}.py"
            for alias in node.names:
                if f"{base}/{alias.name}/__init__.py" in sources:
                    yield f"{base}/{alias.name}/__init__.py"
                    modules = (f"{base}/{alias.name}/{attribute}.py" for name, attribute in asked if name == alias.name)
                    yield from sorted(module for module in modules if module in sources)
