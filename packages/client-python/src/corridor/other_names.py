"""Hints for names that other libraries use, and that are spelled differently here."""

from __future__ import annotations

from typing import Dict, Tuple

#: The attribute of this library by the other name, and how to use it.
_OTHER_NAMES: Dict[str, Tuple[str, str]] = {
    "move": ("forward", "forward(100)"),
    "left90": ("left", "left(90)"),
    "right90": ("right", "right(90)"),
    "turn180": ("turn", "turn(180)"),
    "delayedLeft90": ("delayed_left", "delayed_left()"),
    "delayedRight90": ("delayed_right", "delayed_right()"),
    "goalReached": ("goal_reached", "goal_reached"),
    "rear": ("back", "back"),
}


def no_attribute(owner: object, name: str) -> AttributeError:
    """The error for an attribute that does not exist, with the name that is used here."""
    kind = type(owner)
    own, usage = _OTHER_NAMES.get(name, ("", ""))
    is_known = hasattr(kind, own) or own in getattr(kind, "__dataclass_fields__", {})
    # Python adds ". Did you mean" and a similar name when it prints the error, so no period here.
    hint = f". Use {usage}" if is_known else ""
    return AttributeError(f"{kind.__name__!r} object has no attribute {name!r}{hint}")
