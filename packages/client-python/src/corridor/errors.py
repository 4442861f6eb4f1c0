"""What can go wrong for a script: each error says what, and what to do."""

from __future__ import annotations


class RobotError(Exception):
    """The base of all errors here. The text of an error has `what`, `code` and `hint`, and never the key.

    Uncaught, it ends the script and prints the script's line, `what` and `hint` in place of a traceback.

    Args:
        code: a stable word for scripts, such as `timeout`.
        what: what went wrong, for people.
        hint: what to do.
    """

    #: a stable word for scripts, such as `timeout`; each error below names its own
    code: str
    #: what went wrong, for people
    what: str
    #: what to do
    hint: str

    def __init__(self, code: str, what: str, hint: str) -> None:
        named = what if what.endswith(code) else f"{what} ({code})"
        super().__init__(f"{named}. {hint}")
        self.code = code
        self.what = what
        self.hint = hint


class AddressError(RobotError, ValueError):
    """The robot's address cannot be read, or leads to something else (`bad-address`)."""


class CommandError(RobotError, ValueError):
    """A number is out of its range (`bad-command`), or the robot's host refused the command (`refused`)."""


class NotAuthorisedError(RobotError):
    """The key is wrong (`not-authorised`), or the robot's owner has blocked this script (`blocked`)."""


class PairingError(RobotError):
    """Pairing failed.

    No page shows the code (`wrong-code`), the owner refused (`pairing-refused`), nobody answered or the
    code is over (`pairing-over`), or too many codes were typed (`too-many-tries`).
    """


class RobotGoneError(RobotError):
    """There is no such robot (`no-robot`), as after 2 hours without use, or its page is closed (`robot-gone`)."""


class CommandEndedError(RobotError):
    """The command did not come to its end.

    A stop, the owner or a reload ended it (`cancelled`), a newer one replaced it (`superseded`), or it
    could not start within its `ttl` (`expired`). A wall is no error: see `Command.collided`.
    """


class NoMazeError(RobotError):
    """The robot's host does not publish its maze (`no-maze`)."""


class NoAnswerError(RobotError, TimeoutError):
    """The host did not answer, or the robot did not finish, in time (`timeout`)."""


class ClosedError(RobotError):
    """The script has closed this robot (`closed`)."""
