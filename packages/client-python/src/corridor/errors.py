"""What can go wrong on a script's side of the line: each error says what, and how to go on."""

from __future__ import annotations


class RobotError(Exception):
    """Something did not work: `what`, and the `hint` says what to do. `code` is stable. All are in the text.

    Uncaught, it ends the script with its line, `what` and `hint` in place of a traceback.
    """

    def __init__(self, code: str, what: str, hint: str) -> None:
        super().__init__(f"{what} ({code}). {hint}")
        self.code = code
        self.what = what
        self.hint = hint


class AddressError(RobotError, ValueError):
    """The robot's address cannot be read, or leads to something else (`bad-address`)."""


class CommandError(RobotError, ValueError):
    """A number is out of its range (`bad-command`), or the robot's host refused the command (`refused`)."""


class NotAuthorisedError(RobotError):
    """The key is wrong (`not-authorised`), or the robot's owner has sent this script away (`sent-away`)."""


class PairingError(RobotError):
    """No robot by this code: `wrong-code`, `pairing-refused`, `pairing-over` or `too-many-tries`."""


class RobotGoneError(RobotError):
    """The robot was forgotten (`no-robot`), or its page is closed (`robot-gone`)."""


class CommandEndedError(RobotError):
    """The command did not come to its end: `cancelled`, `superseded` or `expired`."""


class NoMazeError(RobotError):
    """The robot's host does not publish its maze (`no-maze`)."""


class NoAnswerError(RobotError, TimeoutError):
    """No answer in time (`timeout`)."""


class ClosedError(RobotError):
    """This robot was closed by the script itself (`closed`)."""
