"""The commands `axicontact list` and `axicontact show`, by the standard library only, so that both are instant."""

from __future__ import annotations

import argparse
import ast
import json

from ..store.index import PREFIX, Index, NoCatalogueError, Row, load, module_of, table

TOPICS = ("profiles", "physics", "quantities", "units", "matrix")
FORMS = ("text", "latex", "python", "json")


def list_topic(arguments: argparse.Namespace) -> int:
    """Print what the catalogue holds; the exit code."""
    print(listing(load(), arguments.topic, as_json=arguments.json))
    return 0


def show(arguments: argparse.Namespace) -> int:
    """Print a profile or one of its formulas; the exit code."""
    print(shown(load(), arguments.key, arguments.form).rstrip())
    return 0


def listing(index: Index, topic: str, *, as_json: bool = False) -> str:
    """What `axicontact list TOPIC` prints: a table, or rows of JSON."""
    rows = _rows(index, topic)
    if as_json:
        return json.dumps(rows, indent=1, ensure_ascii=False)
    return table([list(rows[0]), *([_cell(value) for value in row.values()] for row in rows)]) if rows else ""


def _rows(index: Index, topic: str) -> list[Row]:
    if topic == "units":
        return [{k: row[k] for k in ("name", "unit", "domain", "meaning")} for row in index.data["units"]]
    if topic == "matrix":
        systems = [row["name"] for row in index.data["physics"]]
        cells: dict[str, dict[str, str]] = index.data["matrix"]["profiles"]
        return [{"profile": name, **{s: own.get(s, "") for s in systems}} for name, own in cells.items()]
    if topic == "physics":
        return list(index.data["physics"])
    if topic == "quantities":
        first = {(row["quantity"], row["function"]): row for row in index.entries}
        names = {"quantity": "suffix", "function": "function", "label": "label", "symbol": "symbol", "unit": "unit"}
        return [{new: row[old] for old, new in names.items()} for row in first.values()]
    return [
        {
            "name": row["name"],
            "profile f(r)": _shape(row["shape"]),
            "parameters": row["parameters"],
            "contact": row["contact"],
            "formulas": sum(problem["formulas"] for problem in row["problems"].values()),
        }
        for row in index.profiles
    ]


def _shape(pieces: list[Row]) -> str | list[str]:
    if len(pieces) > 1:
        return [f"{piece['text']} ({piece['conditions'] or 'else'})" for piece in pieces]
    return "".join(piece["text"] for piece in pieces)


def shown(index: Index, key: str, form: str) -> str:
    """The entry, or all entries of a problem, in one of `FORMS`."""
    entries = index.select(key)
    problem = entries[0]["problem"]
    whole = key.removeprefix(PREFIX) in (problem, module_of(entries[0]))
    profile = index.profile(entries[0]["profile"])
    if form == "json":
        record = {"profile": profile, "entries": entries} if whole else entries[0]
        return json.dumps(record, indent=1, ensure_ascii=False)
    if form == "python":
        first = {entry["function"]: entry for entry in entries}
        return "\n\n".join(_source(index, entry) for entry in first.values())
    if form == "latex":
        return "\n".join(f"%% {e['key']}{_when(c['conditions'])}\n{c['text']}" for e in entries for c in e["latex"])
    head = [_profile_text(profile, problem)] if whole else []
    first = {entry["note"]: entry["key"] for entry in reversed(entries)} if whole else {}
    return "\n\n".join([*head, *(_entry_text(entry, first) for entry in entries)])


def _profile_text(profile: Row, key: str) -> str:
    shape = "\n".join(f"  f(r) = {piece['text']}{_when(piece['conditions'])}" for piece in profile["shape"])
    rows = [f"{profile['title']} ({profile['name']}): {profile['subtitle']}", shape]
    rows += [f"  with     {text}" for text in profile["abbreviations"]]
    rows += [f"  rule     {rule}" for rule in profile["rules"]]
    rows += [f"  {name:8} {text}" for name, text in (("valid", profile["validity"]), ("note", profile["note"])) if text]
    rows.append(f"  sources  {', '.join(profile['sources'])}")
    others = [f"{other} ({found['formulas']})" for other, found in profile["problems"].items() if other != key]
    return "\n".join([*rows, f"  further  {', '.join(others)}"] if others else rows)


def _entry_text(entry: Row, first: Row) -> str:
    unit = f" [{entry['unit']}]" if entry["unit"] else ""
    rows = [f"{entry['key']}  {entry['label']}{unit}"]
    if entry["composed"]:
        outer, inner = (f"{entry['problem']}.{suffix}" for suffix in entry["composed"])
        rows.append(f"  {entry['symbol']} = {outer} with a from {inner}")
    else:
        solved = entry["status"] == "root" or " = " in entry["cases"][0]["text"]
        sign = "from" if solved else "="
        rows += [f"  {entry['symbol']} {sign} {case['text']}{_when(case['conditions'])}" for case in entry["cases"]]
    if first:
        noted = entry["note"] and first[entry["note"]] == entry["key"]
        return "\n".join([*rows, f"  note      {entry['note']}"] if noted else rows)
    details = {
        "status": {
            "root": "root of an equation, solved by iteration",
            "integral": "definite integral; closed form not found",
            "equation": "integral equation, solved in numbers",
            "expansion": "beginning of the solution of an integral equation",
        }.get(entry["status"], "closed form"),
        "defined": entry["definition"],
        "python": entry["python"],
        "domain": "; ".join(entry["domain"]),
        "sources": ", ".join(entry["sources"]),
        "evidence": entry["evidence"].replace("; ", "\n            "),
        "note": entry["note"],
    }
    rows += [f"  {name:9} {text}" for name, text in details.items() if text]
    return "\n".join(rows)


def _when(conditions: str) -> str:
    return f"    ({conditions})" if conditions else ""


def _cell(value: object) -> str:
    return ", ".join(map(str, value)) if isinstance(value, list) else str(value)


def _source(index: Index, entry: Row) -> str:
    """Text of the generated function behind an entry."""
    _, *parts, _ = entry["python"].partition("(")[0].split(".")
    path = index.folder.joinpath(*parts).with_suffix(".py")
    text = path.read_text()
    for node in ast.parse(text).body:
        if isinstance(node, ast.FunctionDef) and node.name == entry["function"]:
            first = min([node.lineno, *(decorator.lineno for decorator in node.decorator_list)])
            return "\n".join(text.splitlines()[first - 1 : node.end_lineno]) + "\n"
    message = f"{path} has no function {entry['function']}; run axicontact build"
    raise NoCatalogueError(message)
