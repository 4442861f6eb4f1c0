"""The exceptions of the library."""

from __future__ import annotations


class RobotError(Exception):
    """The base class of all errors. The text contains `what`, `code` and `hint`, and never the key.

    Uncaught, it prints the script's line, `what` and `hint` instead of a traceback.

    Args:
        code: a stable code for scripts, such as `timeout`.
        what: what went wrong, as a sentence.
        hint: how to fix it.
    """

    #: a stable code for scripts, such as `timeout`
    code: str
    #: what went wrong, as a sentence
    what: str
    #: how to fix it
    hint: str

    def __init__(self, code: str, what: str, hint: str) -> None:
        named = what if what.endswith(code) else f"{what} ({code})"
        super().__init__(f"{named}. {hint}")
        self.code = code
        self.what = what
        self.hint = hint


class AddressError(RobotError, ValueError):
    """The robot's address is invalid, or another server responds there (`bad-address`)."""


class CommandError(RobotError, ValueError):
    """A number is out of its range (`bad-command`), or the robot's host refused the command (`refused`)."""


class NotAuthorisedError(RobotError):
    """The key is wrong (`not-authorised`), or the robot's owner has blocked this script (`blocked`)."""


class PairingError(RobotError):
    """Pairing failed.

    No page shows the code (`wrong-code`), the owner refused (`pairing-refused`), the owner did not answer
    or the code has expired (`pairing-over`), or too many codes were entered (`too-many-tries`).
    """


class RobotGoneError(RobotError):
    """There is no such robot (`no-robot`), or its page is closed (`robot-gone`).

    The relay deletes robots after 2 hours without use.
    """


class CommandEndedError(RobotError):
    """The command ended early.

    A stop, the owner or a reload ended it (`cancelled`), a newer one replaced it (`superseded`), or it
    could not start within its `ttl` (`expired`). A wall is not an error: see `Command.collided`.
    """


class NoMazeError(RobotError):
    """The robot's host does not publish its maze (`no-maze`)."""


class NoAnswerError(RobotError, TimeoutError):
    """The host did not respond in time, or the robot did not finish in time (`timeout`)."""


class ClosedError(RobotError):
    """The script has closed this robot (`closed`)."""
