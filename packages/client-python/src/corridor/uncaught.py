"""Prints uncaught errors as the script's line and a sentence."""

from __future__ import annotations

import linecache
import os
import sys
from types import TracebackType
from typing import Optional, Type

from .errors import RobotError


def explain(error: RobotError, trace: Optional[TracebackType]) -> str:
    """The line of the script, then the cause and the hint."""
    line = ""
    while trace is not None:
        # The last frame outside of the library belongs to the script.
        if not _is_of(trace, __name__):
            line = f"{_line_of(trace)}\n"
        trace = trace.tb_next
    return f"{line}{error.what}. {error.hint}\n"


def explain_interrupt(error: BaseException) -> Optional[str]:
    """The line of the script that Ctrl+C interrupted; None if it called neither library nor asyncio."""
    line = _line_before(error.__traceback__, __name__)
    # asyncio raises it outside of the script, while it handles the cancellation of the script.
    if line is None and error.__context__ is not None:
        line = _line_before(error.__context__.__traceback__, __name__)
    # Before Python 3.11, asyncio raises it where it waits, with no trace of the waiting line.
    if line is None:
        line = _line_before(error.__traceback__, "asyncio")
    return None if line is None else f"Stopped by Ctrl+C: {line}\n"


def _line_before(trace: Optional[TracebackType], package: str) -> Optional[str]:
    """The last line of the script that calls the package; None if no line does."""
    line: Optional[str] = None
    while trace is not None and trace.tb_next is not None:
        if not _is_of(trace, package) and _is_of(trace.tb_next, package):
            line = _line_of(trace)
        trace = trace.tb_next
    return line


def _is_of(trace: TracebackType, package: str) -> bool:
    """Whether the frame belongs to a module of the package."""
    name: str = trace.tb_frame.f_globals.get("__name__", "")
    return name.split(".")[0] == package.split(".")[0]


def _line_of(trace: TracebackType) -> str:
    file, number = trace.tb_frame.f_code.co_filename, trace.tb_lineno
    code = linecache.getline(file, number).strip()
    return f"{os.path.basename(file)}, line {number}: {code}".rstrip(": ")


def explain_uncaught() -> None:
    """Replaces the traceback of an uncaught RobotError or Ctrl+C, except with `python3 -X dev`."""
    previous = sys.excepthook

    def hook(
        kind: Type[BaseException], error: BaseException, trace: Optional[TracebackType]
    ) -> None:
        text = None
        if isinstance(error, RobotError):
            text = explain(error, trace)
        elif isinstance(error, KeyboardInterrupt):
            text = explain_interrupt(error)
        if text is None or sys.flags.dev_mode or sys.stderr is None:
            previous(kind, error, trace)
            return
        sys.stderr.write(text)

    sys.excepthook = hook
