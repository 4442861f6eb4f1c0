"""Generates REFERENCE.md from the docstrings (`npm run reference`).

It parses the sources and does not import them, so every version of Python makes the same text.
"""

from __future__ import annotations

import ast
import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import Dict, Iterator, List, Optional, Tuple, Union

PACKAGE = Path(__file__).resolve().parents[1]
SOURCES = PACKAGE / "src/corridor"
REFERENCE = PACKAGE / "REFERENCE.md"

Function = Union[ast.FunctionDef, ast.AsyncFunctionDef]

#: The classes by group, in reading order.
GROUPS: Dict[str, Tuple[str, ...]] = {
    "Robots": ("Robot", "LiveSensor", "AsyncRobot"),
    "What a robot reports": (
        "Snapshot",
        "Sensors",
        "Pose",
        "Cell",
        "Command",
        "Event",
        "Maze",
        "Start",
    ),
    "Errors": (
        "RobotError",
        "AddressError",
        "PairingError",
        "NotAuthorisedError",
        "RobotGoneError",
        "NoMazeError",
        "CommandError",
        "CommandEndedError",
        "NoAnswerError",
        "ClosedError",
    ),
}

INTRODUCTION = """# Reference of the Python library

`from corridor import Robot`. Every public class with its methods, properties, parameters and errors, made from the
docstrings, which an editor shows as well. [The Python library](README.md) shows how to use them.
"""


@dataclass
class Doc:
    """The sections of a docstring."""

    text: str
    args: Dict[str, str] = field(default_factory=dict)
    returns: str = ""
    raises: Dict[str, str] = field(default_factory=dict)


def reference() -> str:
    classes = public_classes()
    parts = [INTRODUCTION]
    for title, names in GROUPS.items():
        links = ", ".join(_link(name) for name in names)
        parts.append(f"- {title}: {links}")
    parts.append("")
    for title, names in GROUPS.items():
        parts.append(f"## {title}\n")
        for name in names:
            parts += _class(*classes[name])
    return "\n".join(parts).rstrip("\n") + "\n"


def public_names() -> List[str]:
    """The names in `__all__`."""
    for node in ast.parse((SOURCES / "__init__.py").read_text()).body:
        if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "__all__":
            names: List[str] = ast.literal_eval(node.value)
            return names
    raise AssertionError("__init__.py has no __all__")


def public_classes() -> Dict[str, Tuple[ast.ClassDef, List[str]]]:
    """The public classes, with the lines of their files."""
    found: Dict[str, Tuple[ast.ClassDef, List[str]]] = {}
    for file in SOURCES.glob("*.py"):
        text = file.read_text()
        for node in ast.parse(text).body:
            if isinstance(node, ast.ClassDef) and node.name in public_names():
                found[node.name] = (node, text.splitlines())
    return found


def methods(node: ast.ClassDef) -> Iterator[Function]:
    """The public methods and properties."""
    for each in node.body:
        if isinstance(each, (ast.FunctionDef, ast.AsyncFunctionDef)) and each.name[0] != "_":
            yield each


def constructor(node: ast.ClassDef) -> Optional[Function]:
    for each in node.body:
        if isinstance(each, ast.FunctionDef) and each.name == "__init__":
            return each
    return None


def fields(node: ast.ClassDef, lines: List[str]) -> Iterator[Tuple[str, str, str]]:
    """Name, type and `#:` comment of each field."""
    for each in node.body:
        if not isinstance(each, ast.AnnAssign):
            continue
        words: List[str] = []
        line = each.lineno - 2
        while lines[line].strip().startswith("#: "):
            words.insert(0, lines[line].strip()[3:])
            line -= 1
        yield ast.unparse(each.target), ast.unparse(each.annotation), " ".join(words)


def parameters(function: Function) -> List[str]:
    given = function.args
    return [each.arg for each in (*given.args, *given.kwonlyargs) if each.arg not in ("self", "cls")]


def is_property(function: Function) -> bool:
    return "property" in map(ast.unparse, function.decorator_list)


def read_doc(node: Union[ast.ClassDef, Function]) -> Doc:
    """Parses the sections `Args:`, `Returns:` and `Raises:`."""
    text, *rest = re.split(r"^(Args|Returns|Raises):\n", ast.get_docstring(node) or "", flags=re.M)
    doc = Doc(text.strip())
    for name, body in zip(rest[::2], rest[1::2]):
        if name == "Returns":
            doc.returns = " ".join(body.split())
            continue
        entries = re.findall(r"^    (\w+): ((?:.*\n?)(?:^     .*\n?)*)", body, flags=re.M)
        into = doc.args if name == "Args" else doc.raises
        into.update({entry: " ".join(words.split()) for entry, words in entries})
    return doc


def _class(node: ast.ClassDef, lines: List[str]) -> List[str]:
    doc = read_doc(node)
    parts = [f"### `{node.name}`\n"]
    bases = [ast.unparse(base) for base in node.bases]
    bases = [base for base in bases if base not in ("NamedTuple", "Exception")]
    if bases:
        parts.append(f"Is a {' and a '.join(_link(base) for base in bases)}.\n")
    parts.append(f"{doc.text}\n")
    init = constructor(node)
    if init is not None and doc.args:
        parts.append(_signature(node.name, init, ""))
        parts += _lists(init, doc)
    own = list(methods(node))
    attributes = list(fields(node, lines))
    attributes += [
        (each.name, ast.unparse(each.returns), read_doc(each).text)
        for each in own
        if is_property(each) and each.returns is not None
    ]
    if attributes:
        parts.append("| Property | Type | Meaning |\n| --- | --- | --- |")
        parts += [
            f"| `{name}` | {_type(kind)} | {words} |" for name, kind, words in attributes
        ]
        parts.append("")
    for each in own:
        if is_property(each):
            continue
        parts.append(f"#### `{node.name}.{each.name}`\n")
        is_class_method = "classmethod" in map(ast.unparse, each.decorator_list)
        owner = node.name if is_class_method else node.name.lower().replace("async", "")
        doc = read_doc(each)
        parts.append(f"{doc.text}\n")
        is_generator = any(isinstance(inner, ast.Yield) for inner in ast.walk(each))
        is_awaited = isinstance(each, ast.AsyncFunctionDef) and not is_generator
        parts.append(_signature(f"{owner}.{each.name}", each, "await " if is_awaited else ""))
        parts += _lists(each, doc)
    return parts


def _signature(name: str, function: Function, before: str) -> str:
    given = function.args
    words = [
        _parameter(each, default)
        for each, default in zip(
            given.args, [*[None] * (len(given.args) - len(given.defaults)), *given.defaults]
        )
        if each.arg not in ("self", "cls")
    ]
    if given.kwonlyargs:
        words.append("*")
        words += [_parameter(*each) for each in zip(given.kwonlyargs, given.kw_defaults)]
    result = "" if function.name == "__init__" or function.returns is None else (
        f" -> {ast.unparse(function.returns)}"
    )
    line = f"{before}{name}({', '.join(words)}){result}"
    if len(line) > 80:
        inside = "".join(f"    {word},\n" for word in words)
        line = f"{before}{name}(\n{inside}){result}"
    return f"```python\n{line}\n```\n"


def _parameter(each: ast.arg, default: Optional[ast.expr]) -> str:
    kind = "" if each.annotation is None else f": {ast.unparse(each.annotation)}"
    return f"{each.arg}{kind}" + ("" if default is None else f" = {ast.unparse(default)}")


def _lists(function: Function, doc: Doc) -> List[str]:
    parts: List[str] = []
    if doc.args:
        parts += [f"- `{name}`: {doc.args[name]}" for name in parameters(function)]
    if doc.returns:
        parts.append(f"- Returns: {doc.returns}")
    parts += [f"- Raises {_link(name)}: {words}" for name, words in doc.raises.items()]
    return [*parts, ""] if parts else []


def _type(text: str) -> str:
    return _link(text) if text in public_names() else f"`{text}`"


def _link(name: str) -> str:
    return f"[`{name}`](#{name.lower()})" if name in public_names() else f"`{name}`"


if __name__ == "__main__":
    REFERENCE.write_text(reference(), encoding="utf-8")
