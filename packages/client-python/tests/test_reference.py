"""The reference is up to date, and every public name has a docstring."""

import ast
from typing import List

from library_reference import (
    GROUPS,
    REFERENCE,
    constructor,
    fields,
    is_property,
    methods,
    parameters,
    public_classes,
    public_names,
    read_doc,
    reference,
)


def test_it_matches_the_docstrings() -> None:
    assert REFERENCE.read_text(encoding="utf-8") == reference(), (
        "Run `npm run reference`, and commit REFERENCE.md."
    )


def test_it_contains_every_public_class_once() -> None:
    assert sorted(name for names in GROUPS.values() for name in names) == sorted(public_names())


def test_every_method_property_and_parameter_is_documented() -> None:
    without: List[str] = []
    for name, (node, lines) in public_classes().items():
        if not read_doc(node).text:
            without.append(name)
        without += [f"{name}.{field}" for field, _, words in fields(node, lines) if not words]
        for method in methods(node):
            if not read_doc(method).text:
                without.append(f"{name}.{method.name}")
            # The parameters of AsyncRobot are documented at Robot.
            if name == "AsyncRobot":
                continue
            doc = read_doc(method)
            if list(doc.args) != parameters(method):
                without.append(f"{name}.{method.name}: {parameters(method)}")
            gives = method.returns is not None and ast.unparse(method.returns) not in ("None", name)
            if gives and not is_property(method) and not doc.returns:
                without.append(f"{name}.{method.name}: what it returns")
            without += [
                f"{name}.{method.name}: {error}" for error in doc.raises if error not in public_names()
            ]
    assert without == []


def test_the_parameters_of_constructors_are_documented() -> None:
    classes = public_classes()
    for name in ("Robot", "RobotError"):
        init = constructor(classes[name][0])
        assert init is not None
        assert list(read_doc(classes[name][0]).args) == parameters(init)


def test_the_asynchronous_robot_has_the_same_methods_and_parameters() -> None:
    classes = public_classes()
    own = {each.name: parameters(each) for each in methods(classes["AsyncRobot"][0])}
    other = {each.name: parameters(each) for each in methods(classes["Robot"][0])}
    first = constructor(classes["Robot"][0])
    assert first is not None
    assert own.pop("connect") == parameters(first)
    for name in ("sensor", "goal_reached", "bumps"):
        del other[name]
    assert own == other
